// world:set_pair_filter: what it decides, what it is asked, and that nothing can be broken from within it.
#include <catch2/catch.hpp>
#include <string>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

/// A floor and two balls above it, of two teams.
constexpr const char* kScene =
    "w = cairn.physics.new_world{} "
    "floor = w:add_box{ type = 'static', y = -1, width = 20, height = 2, data = { team = 'red' } } "
    "red = w:add_circle{ x = -3, y = 1, radius = 0.5, data = { team = 'red' } } "
    "blue = w:add_circle{ x = 3, y = 1, radius = 0.5, data = { team = 'blue' } } "
    "function steps(n) for i = 1, n do w:step(1 / 60) end end "
    "function leave() blue:set_position(3, 50) steps(2) end "
    "function meet() blue:set_position(3, 0.45) blue:set_linear_velocity(0, 0) steps(2) end "
    "function height(body) return select(2, body:position()) end ";

TEST_CASE("a pair filter lets through what it says no to, and only that") {
    LuaBench bench;
    REQUIRE(bench.run(kScene) == "");
    REQUIRE(bench.run("w:set_pair_filter(function(a, b) return a.data.team == b.data.team end) steps(60)") ==
            "");
    CHECK(std::stod(bench.value("height(red)")) == Approx(0.5).margin(0.01));
    CHECK(std::stod(bench.value("height(blue)")) < -1);
}

TEST_CASE("a pair filter is asked once for a pair, and again when the two have parted") {
    LuaBench bench;
    REQUIRE(bench.run(kScene) == "");
    REQUIRE(bench.run("asked = {} w:set_pair_filter(function(a, b, shape_a, shape_b) "
                      "assert(shape_a:body() == a and shape_b:body() == b) "
                      "asked[#asked + 1] = (a == floor and b or a).data.team return true end) steps(60)") ==
            "");
    CHECK(bench.value("table.concat(asked, ' ')") == "red blue");
    REQUIRE(bench.run("leave() meet()") == "");
    CHECK(bench.value("table.concat(asked, ' ')") == "red blue blue");
    REQUIRE(bench.run("w:set_pair_filter(nil) leave() meet() steps(30)") == "");
    CHECK(bench.value("#asked") == "3");
    CHECK(std::stod(bench.value("height(blue)")) == Approx(0.5).margin(0.01));
}

TEST_CASE("a world with a filter that always agrees goes on as one without") {
    LuaBench bench;
    REQUIRE(bench.run("function hash(filter) local w = cairn.physics.new_world{} "
                      "w:add_box{ type = 'static', width = 40, height = 1 } "
                      "for i = 1, 40 do w:add_box{ x = i % 7, y = 1 + i, width = 1, height = 1 } end "
                      "if filter then w:set_pair_filter(filter) end "
                      "for i = 1, 120 do w:step(1 / 60) end return w:state_hash() end") == "");
    CHECK(bench.value("hash(nil) == hash(function(a, b) return true end)") == "true");
    CHECK(bench.value("hash(nil) == hash(function(a, b) return a.data == b.data end)") == "false");
}

TEST_CASE("a filter may look at bodies and shapes, and its values are the ones that the script knows") {
    LuaBench bench;
    REQUIRE(bench.run(kScene) == "");
    REQUIRE(bench.run("w:set_pair_filter(function(a, b, shape_a, shape_b) "
                      "seen = { a:type(), b:type(), shape_a:kind(), shape_b:kind(), a:world() == w, "
                      "a:is_valid() and b:is_valid() and shape_a:is_valid() and w:is_valid(), "
                      "select(2, a:linear_velocity()) == 0, b:mass() > 0 } "
                      "kept = shape_b return true end) steps(60)") == "");
    CHECK(bench.value("seen[1] .. seen[2] .. seen[3] .. seen[4]") == "staticdynamicpolygoncircle");
    CHECK(bench.value("seen[5] and seen[6] and seen[7] and seen[8]") == "true");
    CHECK(bench.value("kept == kept:body():shapes()[1]") == "true");
}

TEST_CASE("nothing can be changed or searched from within a filter, and the step is whole") {
    LuaBench bench;
    REQUIRE(
        bench.run(std::string(kScene) +
                  "pendulum = cairn.prefab.pendulum(w, { x = 50 }) "
                  "joint = w:add_distance_joint{ body_a = red, body_b = blue } joint:destroy() "
                  "function try(action) local filter = function(a, b) said = select(2, pcall(action, a, "
                  "b)) return true end "
                  "w:set_pair_filter(filter) leave() said = 'not asked' meet() return tostring(said) end") ==
        "");
    for (const char* change :
         {"a:set_position(1, 1)", "b:apply_impulse(1, 1, 0, 0)", "b:destroy()", "b:set_awake(false)",
          "a:add_circle{ radius = 1 }", "w:step(1 / 60)", "w:destroy()", "w:add_circle{ radius = 1 }",
          "w:restore(w:snapshot())", "w:cast_ray(0, 0, 1, 1)", "w:bodies()", "w:set_pair_filter(nil)",
          "b:shapes()[1]:destroy()", "b:cut(0, 0, 1, 1)", "w:state_hash()", "w:set_gravity(0, 0)",
          "a:is_breakable()", "w:add_distance_joint{ body_a = a, body_b = b }"}) {
        INFO(change);
        CHECK_THAT(bench.value(std::string("try(function(a, b) ") + change + " end)"),
                   Catch::Contains("a pair filter may look at bodies and shapes"));
    }
    // Things of the world that are no bodies, too.
    CHECK_THAT(bench.value("try(function() pendulum:destroy() end)"), Catch::Contains("destroyed"));
    CHECK_THAT(bench.value("try(function() coroutine.yield() end)"), Catch::Contains("yield"));
    REQUIRE(bench.run("w:set_pair_filter(nil) blue:set_position(3, 1) steps(90)") == "");
    CHECK(std::stod(bench.value("height(blue)")) == Approx(0.5).margin(0.01));
}

TEST_CASE("an error in a filter is raised by the step that asked, with its place, and the step is done") {
    LuaBench bench;
    REQUIRE(bench.run(kScene) == "");
    REQUIRE(bench.run("w:set_pair_filter(function(a, b)\n  return a.data.tame.x\nend)") == "");
    const std::string message = bench.run("leave() meet()");
    CHECK_THAT(message, Catch::Contains("test.lua:2: attempt to index a nil value (field 'tame')"));
    CHECK_THAT(message, Catch::Contains("pair filter"));
    CHECK(bench.value("w:step_count()") == "3");
    REQUIRE(bench.run("w:set_pair_filter(nil) steps(60)") == "");
    CHECK(std::stod(bench.value("height(blue)")) == Approx(0.5).margin(0.01));
}

TEST_CASE("an answer that is neither true nor false is an error at the filter") {
    LuaBench bench;
    REQUIRE(bench.run(kScene) == "");
    REQUIRE(bench.run("\n\nw:set_pair_filter(function(a, b) end)") == "");
    CHECK_THAT(bench.run("steps(60)"),
               Catch::Contains("test.lua:3: the pair filter returned nil; expected true or false"));
    CHECK_THAT(bench.run("w:set_pair_filter(12)"), Catch::Contains("filter is 12; expected a function"));
}

}  // namespace
}  // namespace cairn::scripting::test
