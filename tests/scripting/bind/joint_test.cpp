#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

TEST_CASE("a revolute joint holds a pendulum at its pin") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} hook = w:new_body{ type = 'static', y = 5 } bob = "
                      "w:add_circle{ x = 2, y = 5, radius = 0.2 } "
                      "j = w:add_revolute_joint{ body_a = hook, body_b = bob, x = 0, y = 5 } "
                      "for i = 1, 200 do w:step(1 / 60) end") == "");
    CHECK(bench.run("local x, y = bob:position() local r = math.sqrt(x * x + (y - 5) ^ 2) assert(math.abs(r "
                    "- 2) < 0.01, r)") == "");
    CHECK(bench.run("local x, y = j:anchor_b() assert(math.abs(x) < 0.01 and math.abs(y - 5) < 0.01)") == "");
    CHECK(bench.value("j:kind()") == "revolute");
    CHECK(bench.value("j:body_a() == hook and j:body_b() == bob") == "true");
    CHECK(bench.value("bob:joints()[1] == j and hook:joints()[1] == j") == "true");
    CHECK(bench.value("w:joint_count()") == "1");
}

TEST_CASE("a distance joint measures its own length") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{ gravity_y = 0 } a = w:new_body{ type = 'static' } b = "
                      "w:add_circle{ x = 3, y = 4, radius = 1 } "
                      "j = w:add_distance_joint{ body_a = a, body_b = b }") == "");
    CHECK(std::stod(bench.value("j:length()")) == Approx(5).margin(1e-5));
    REQUIRE(bench.run("j:set_length(2) for i = 1, 120 do w:step(1 / 60) end") == "");
    CHECK(std::stod(bench.value("j:length()")) == Approx(2).margin(0.02));
    CHECK(bench.run("j:set_motor(true, 1, 1)").find("Joint:set_motor: ") != std::string::npos);
}

TEST_CASE("joints say what is wrong with their description") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} other = cairn.physics.new_world{} a = w:new_body{} b = "
                      "w:new_body{ x = 1 } c = other:new_body{}") == "");
    CHECK(bench.run("w:add_revolute_joint{ body_a = a, x = 0, y = 0 }") ==
          "test.lua:1: World:add_revolute_joint: body_b is missing; it must be a Body");
    CHECK(bench.run("w:add_revolute_joint{ body_a = a, body_b = {}, x = 0, y = 0 }")
              .find("body_b = a table: must be a Body") != std::string::npos);
    CHECK(bench.run("w:add_revolute_joint{ body_a = a, body_b = b, x = 0, y = 0, lower = 1 }")
              .find("lower is given without upper") != std::string::npos);
    CHECK(bench.run("w:add_distance_joint{ body_a = a, body_b = c }").find("World:add_distance_joint: ") !=
          std::string::npos);
    CHECK(bench.run("b:destroy() w:add_distance_joint{ body_a = a, body_b = b }")
              .find("body_b = a Body: it was destroyed") != std::string::npos);
}

TEST_CASE("a joint goes with either of its bodies") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} a = w:new_body{} b = w:new_body{ x = 1 } j = "
                      "w:add_distance_joint{ body_a = a, body_b = b } "
                      "k = w:add_distance_joint{ body_a = a, body_b = b } j:destroy()") == "");
    CHECK(bench.value("j:is_valid()") == "false");
    CHECK(bench.value("k:is_valid()") == "true");
    CHECK(bench.run("a:destroy()") == "");
    CHECK(bench.value("k:is_valid()") == "false");
    CHECK(bench.run("k:length()") == "test.lua:1: Joint:length: this joint was destroyed; is_valid() tells");
}

}  // namespace
}  // namespace cairn::scripting::test
