#include <catch2/catch.hpp>
#include <cmath>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

/// A ball falls onto the ground: `until_event(kind)` steps until such an event comes.
const char* const kScene = R"(
w = cairn.physics.new_world{}
ground = w:add_box{ type = "static", y = -0.5, width = 20, height = 1 }
ball = w:add_circle{ y = 1.5, radius = 0.5, density = 2, data = { name = "ball" } }
function until_event(kind)
    for i = 1, 600 do
        w:step(1 / 60)
        for k, a, b, impulse, x, y, nx, ny, speed in w:events(kind) do
            return k, a, b, impulse, x, y, nx, ny, speed
        end
    end
end
)";

TEST_CASE("a hit tells who, where, how fast and how hard") {
    LuaBench bench;
    REQUIRE(bench.run(kScene) == "");
    REQUIRE(bench.run("k, a, b, impulse, x, y, nx, ny, speed = until_event('hit')") == "");
    CHECK(bench.value("k") == "hit");
    CHECK(bench.value("(a == ground and b == ball) or (a == ball and b == ground)") == "true");
    CHECK(std::stod(bench.value("y")) == Approx(0).margin(0.02));
    CHECK(std::stod(bench.value("math.abs(ny)")) == Approx(1).margin(1e-4));
    // 1 m of fall: v^2 = 2 g d; the impulse stops mass times speed.
    CHECK(std::stod(bench.value("speed")) == Approx(std::sqrt(20.0)).epsilon(0.05));
    CHECK(std::stod(bench.value("impulse / (ball:mass() * speed)")) == Approx(1).epsilon(0.15));
}

TEST_CASE("begins and ends come when touching begins and ends") {
    LuaBench bench;
    REQUIRE(bench.run(kScene) == "");
    CHECK(bench.value("until_event('begin')") == "begin");
    REQUIRE(bench.run("ball:set_linear_velocity(0, 5)") == "");
    CHECK(bench.value("until_event('end')") == "end");
}

TEST_CASE("without a kind all events come") {
    LuaBench bench;
    REQUIRE(bench.run(kScene) == "");
    REQUIRE(bench.run("kinds = '' repeat w:step(1 / 60) for k in w:events() do kinds = kinds .. k .. ' ' end "
                      "until kinds ~= ''") == "");
    CHECK(bench.value("kinds") == "begin hit ");
}

TEST_CASE("bodies may be destroyed and made while events are read, and stay themselves") {
    LuaBench bench;
    REQUIRE(bench.run(kScene) == "");
    REQUIRE(bench.run(R"(
seen = {}
for i = 1, 600 do
    w:step(1 / 60)
    for kind, a, b in w:events() do
        local other = a == ground and b or a
        seen[#seen + 1] = other
        if other:is_valid() then
            other:destroy()
            w:add_circle{ x = 5, y = 5, radius = 0.1 }   -- takes the slot
        end
    end
    if #seen > 0 then break end
end)") == "");
    CHECK(bench.value("#seen") == "2");
    CHECK(bench.value("seen[1] == ball and seen[2] == ball") == "true");
    CHECK(bench.value("seen[2].data.name") == "ball");
    CHECK(bench.value("seen[2]:is_valid()") == "false");
}

TEST_CASE("the end that a destroyed body causes still gives that body") {
    LuaBench bench;
    REQUIRE(bench.run(kScene) == "");
    REQUIRE(bench.run("until_event('begin') ball:destroy() w:new_body{ x = 9 }") == "");
    CHECK(bench.run("local count = 0 w:step(1 / 60) for k, a, b in w:events('end') do count = count + 1 "
                    "assert(a == ball or b == ball) end assert(count == 1, count)") == "");
}

TEST_CASE("loops may be nested, left early and broken by errors") {
    LuaBench bench;
    REQUIRE(
        bench.run(
            "w = cairn.physics.new_world{} w:add_box{ type = 'static', y = -0.5, width = 20, height = 1 } "
            "for i = 1, 3 do w:add_circle{ x = i * 2, y = 1, radius = 0.5 } end "
            "repeat w:step(1 / 60) n = 0 for k in w:events('begin') do n = n + 1 end until n > 0") == "");
    CHECK(bench.value("n") == "3");
    CHECK(bench.run("local m = 0 for _ in w:events('begin') do for _ in w:events('begin') do m = m + 1 end "
                    "end assert(m == 9)") == "");
    CHECK(bench.run("for i = 1, 100 do for _ in w:events() do break end end") == "");
    CHECK(bench.run("for i = 1, 100 do pcall(function() for _ in w:events() do error('out') end end) end") ==
          "");
    CHECK(bench.run(
              "local m = 0 for _ in w:events('begin') do m = m + 1 w:step(1 / 60) end assert(m == 1)") == "");
    CHECK(bench.run("local m = 0 for _ in w:events() do m = m + 1 w:destroy() end") == "");
}

TEST_CASE("reading events makes no garbage") {
    LuaBench bench;
    REQUIRE(
        bench.run(
            "w = cairn.physics.new_world{} w:add_box{ type = 'static', y = -0.5, width = 20, height = 1 } "
            "for i = 1, 5 do w:add_circle{ x = i * 2, y = 1, radius = 0.5 } end "
            "repeat w:step(1 / 60) n = 0 for k in w:events('begin') do n = n + 1 end until n > 0 "
            "function read() for i = 1, 100 do for k, a, b, impulse, x, y in w:events() do end end end "
            "read()") == "");
    lua_State* L = bench.game().lua();
    lua_gc(L, LUA_GCSTOP);
    lua_getglobal(L, "read");
    const int before = lua_gc(L, LUA_GCCOUNT) * 1024 + lua_gc(L, LUA_GCCOUNTB);
    REQUIRE(lua_pcall(L, 0, 0, 0) == LUA_OK);
    const int after = lua_gc(L, LUA_GCCOUNT) * 1024 + lua_gc(L, LUA_GCCOUNTB);
    CHECK(after == before);
    lua_gc(L, LUA_GCRESTART);
}

TEST_CASE("an unknown kind of event names the nearest") {
    LuaBench bench;
    CHECK(bench.run("for _ in cairn.physics.new_world{}:events('hits') do end") ==
          "test.lua:1: World:events: kind is \"hits\": no such kind of event; did you mean \"hit\"? (begin, "
          "hit, end)");
}

}  // namespace
}  // namespace cairn::scripting::test
