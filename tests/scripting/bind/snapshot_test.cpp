// Going back in time from Lua: the same future, the same values, and errors with names.
#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

const std::string kPile =
    "w = cairn.physics.new_world{} "
    "w:add_box{ y = -1, width = 40, height = 2, type = 'static' } "
    "crates = {} "
    "for i = 1, 10 do crates[i] = w:add_box{ width = 1, height = 1, y = i * 1.1, x = i % 3 * 0.2, data = { "
    "number = i } } end "
    "function run(n) for _ = 1, n do w:step(1 / 60) end end ";

TEST_CASE("a restored world goes on as it did, and its bodies are the values that they were") {
    LuaBench bench;
    REQUIRE(bench.run(kPile + "run(40) s = w:snapshot() run(60) hash = w:state_hash() "
                              "crates[3]:destroy() new = w:add_circle{ radius = 0.5, y = 20 } run(10) "
                              "w:restore(s) now = w:body_count() run(60)") == "");
    CHECK(bench.value("now") == "11");
    CHECK(bench.value("w:state_hash() == hash") == "true");
    CHECK(bench.value("crates[3]:is_valid()") == "true");
    CHECK(bench.value("crates[3].data.number") == "3");
    CHECK(bench.value("new:is_valid()") == "false");
    CHECK(bench.value("w:bodies()[4] == crates[3]") == "true");
}

TEST_CASE("a body that was destroyed has its data from the snapshot, and none from the bytes alone") {
    LuaBench bench;
    REQUIRE(bench.run(kPile + "s = w:snapshot() crates[2]:destroy() crates[2] = nil run(3) w:restore(s)") ==
            "");
    CHECK(bench.value("w:body_count()") == "11");
    CHECK(bench.value("#s.bodies") == "11");
    CHECK(bench.value("w:bodies()[3].data.number") == "2");
    REQUIRE(bench.run("crates[3]:destroy() run(3) w:restore(s.bytes)") == "");
    CHECK(bench.value("w:bodies()[4].data.number") == "nil");
    CHECK(bench.value("w:bodies()[5].data.number") == "4");
    CHECK(bench.value("crates[3]:is_valid()") == "false");
}

TEST_CASE("what was made in a future that was undone never comes to name something else") {
    LuaBench bench;
    REQUIRE(bench.run(
                kPile +
                "s = w:snapshot() undone = w:add_circle{ radius = 0.5, y = 20, data = { name = 'undone' } } "
                "w:restore(s) other = w:add_circle{ radius = 0.5, y = 30, data = { name = 'other' } }") ==
            "");
    CHECK(bench.value("undone:is_valid()") == "false");
    CHECK(bench.value("other:is_valid()") == "true");
    CHECK(bench.value("w:bodies()[12] == other and other.data.name") == "other");
}

TEST_CASE("another world takes a snapshot too") {
    LuaBench bench;
    REQUIRE(bench.run(kPile + "run(40) s = w:snapshot() run(30) hash = w:state_hash() "
                              "v = cairn.physics.new_world{ gravity_y = 3 } v:restore(s) "
                              "for _ = 1, 30 do v:step(1 / 60) end") == "");
    CHECK(bench.value("v:state_hash() == hash") == "true");
    CHECK(bench.value("#v:bodies()") == "11");
}

TEST_CASE("bytes that are no snapshot are an error that says what is wrong, and change nothing") {
    LuaBench bench;
    REQUIRE(bench.run(kPile + "run(5) s = w:snapshot() hash = w:state_hash()") == "");
    CHECK_THAT(bench.run("w:restore('nonsense')"), Catch::Contains("has 8 bytes, but must have at least 32"));
    CHECK_THAT(bench.run("w:restore(('x'):rep(100))"), Catch::Contains("the bytes are no snapshot"));
    CHECK_THAT(bench.run("w:restore(s.bytes:sub(1, -2))"), Catch::Contains("but says that it has"));
    CHECK_THAT(bench.run("w:restore(s.bytes:sub(1, -2) .. '!')"), Catch::Contains("the snapshot is damaged"));
    CHECK_THAT(bench.run("w:restore(12)"), Catch::Contains("expected a snapshot"));
    CHECK_THAT(bench.run("w:restore({})"), Catch::Contains("expected a snapshot"));
    CHECK_THAT(bench.run("w:restore{ bytes = s.bytes, bodies = 3 }"),
               Catch::Contains("World:restore: snapshot.bodies is 3; expected the list of bodies"));
    CHECK_THAT(bench.run("w:restore{ bytes = s.bytes, bodies = { s.bodies[1], 'crate' } }"),
               Catch::Contains("snapshot.bodies[2] is \"crate\"; expected a Body"));
    CHECK(bench.value("w:state_hash() == hash") == "true");
    REQUIRE(bench.run("w:restore{ bytes = s.bytes }") == "");
}

}  // namespace
}  // namespace cairn::scripting::test
