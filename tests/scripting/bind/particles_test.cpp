// cairn.particles from Lua.
#include <catch2/catch.hpp>

#include "scripting/support/drawing.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

const GameFiles kSmall = {{"conf.lua", "{ width = 200, height = 100 }"}};

}  // namespace

TEST_CASE("particles are emitted, live and go") {
    LuaBench bench(kSmall);
    REQUIRE(bench.run("p = cairn.particles.new{ rate = 60, lifetime = 0.5 }") == "");
    CHECK(bench.value("p:is_active()") == "false");
    REQUIRE(bench.run("p:emit(5) p:start() for i = 1, 10 do p:update(1 / 60) end") == "");
    CHECK(bench.value("p:count()") == "15");
    REQUIRE(bench.run("p:stop() for i = 1, 40 do p:update(1 / 60) end") == "");
    CHECK(bench.value("p:count()") == "0");
    CHECK(bench.value("p:is_active()") == "false");
}

TEST_CASE("an emitter turns, and its rate changes, for those that are born from then on") {
    LuaBench bench(kSmall, MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("p = cairn.particles.new{ rate = 60, lifetime = 9, speed = 30, spread = 0, size = 30, "
                      "size_end = 30, colors = { { 1, 1, 1 } }, x = 100, y = 50 } p:set_direction(math.pi) "
                      "p:emit(1) p:update(1) "
                      "p:set_direction(0) p:emit(1) p:update(1)") == "");
    const engine::Image image = picture_of(bench, "p:draw()");
    is_color(image, 40, 50, 254, 254, 254);   // two seconds to the left
    is_color(image, 130, 50, 254, 254, 254);  // one to the right
    is_color(image, 70, 50, 0, 0, 0);
    REQUIRE(bench.run("p:start() p:set_rate(0) p:update(1)") == "");
    CHECK(bench.value("p:count()") == "2");
    REQUIRE(bench.run("p:set_rate(7) p:update(1)") == "");
    CHECK(bench.value("p:count()") == "9");
    CHECK_THAT(bench.run("p:set_rate(-1)"),
               Catch::Contains("rate is -1; expected a number from 0 to 1000000 1/s"));
    CHECK_THAT(bench.run("p:set_direction(0/0)"),
               Catch::Contains("direction is nan; expected a finite number"));
}

TEST_CASE("particles take nothing from the gameplay stream") {
    LuaBench bench(kSmall);
    const std::uint64_t hash = bench.game().state_hash();
    REQUIRE(bench.run("p = cairn.particles.new{ lifetime = 1, lifetime_max = 2 } p:emit(50) p:update(0.1)") ==
            "");
    CHECK(bench.game().state_hash() == hash);
}

TEST_CASE("particles are drawn where they are, in their color, and keep the blend mode") {
    LuaBench bench(kSmall, MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("p = cairn.particles.new({ size = 30, colors = { { 0, 1, 0 } }, blend = 'add' }) "
                      "p:emit(1, 50, 50) camera = cairn.camera.new{ height = 10 } "
                      "q = cairn.particles.new{ size = 3, colors = { { 1, 0, 0 } } } q:emit(1, 5, 0)") == "");
    const engine::Image image = picture_of(
        bench,
        "p:draw() cairn.graphics.set_color(0, 0, 1) cairn.graphics.rectangle('fill', 40, 40, 5, 5) "
        "cairn.graphics.set_color(1, 1, 1) camera:attach() q:draw() camera:detach()");
    is_color(image, 50, 50, 0, 254, 0);
    is_color(image, 42, 42, 0, 0, 255);
    is_color(image, 150, 50, 254, 0, 0);
    is_color(image, 80, 50, 0, 0, 0);
}

TEST_CASE("wrong particles name the field, the value and the rule") {
    LuaBench bench(kSmall);
    const auto message = [&](const std::string& fields) {
        return bench.run("cairn.particles.new{ " + fields + " }");
    };
    CHECK(message("lifetime = 0") ==
          "test.lua:1: cairn.particles.new: lifetime = 0: must be above 0 and at most 1000000");
    CHECK(message("speed = 3, speed_max = 2") ==
          "test.lua:1: cairn.particles.new: speed_max = 2: must be at least speed");
    CHECK(message("max_count = 0").find("must be from 1 to 100000") != std::string::npos);
    CHECK(message("colors = {}").find("must have 1 to 16 colors") != std::string::npos);
    CHECK(message("colors = { { 1, 'x', 0 } }").find("colors[1] must be {r, g, b}") != std::string::npos);
    CHECK(message("colors = { 3 }").find("colors[1] must be {r, g, b}") != std::string::npos);
    CHECK(message("blend = 'glow'").find("must be \"alpha\" or \"add\"") != std::string::npos);
    CHECK(message("lifetim = 1").find("did you mean \"lifetime\"?") != std::string::npos);
}

}  // namespace cairn::scripting::test
