#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

const char* const kScene =
    "w = cairn.physics.new_world{} b = w:add_box{ x = 1, y = 2, width = 1, height = 1, angle = 0.5 }";

TEST_CASE("a body is one value: it compares equal and is a key of tables") {
    LuaBench bench;
    REQUIRE(bench.run(kScene) == "");
    CHECK(bench.value("w:bodies()[1] == b") == "true");
    CHECK(bench.value("rawequal(w:body_at(1, 2), b)") == "true");
    CHECK(bench.run("t = { [b] = 'mine' } collectgarbage('count')") == "");
    CHECK(bench.value("t[w:body_at(1, 2)]") == "mine");
    CHECK(bench.value("b == w:new_body{}") == "false");
    CHECK(bench.value("b:shapes()[1] == b:shapes()[1]") == "true");
    CHECK(bench.value("b:shapes()[1]:body() == b") == "true");
    CHECK(bench.value("b:world() == w") == "true");
}

TEST_CASE("a body keeps its data although the script forgets it") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} w:add_circle{ radius = 1, data = { name = 'ball' } }") ==
            "");
    lua_gc(bench.game().lua(), LUA_GCCOLLECT);
    CHECK(bench.value("w:bodies()[1].data.name") == "ball");
}

TEST_CASE("data is a table from the start, may be replaced, and nothing else can be set") {
    LuaBench bench;
    REQUIRE(bench.run(kScene) == "");
    CHECK(bench.run("b.data.hits = 3 b.data = { other = b.data.hits }") == "");
    CHECK(bench.value("b.data.other") == "3");
    CHECK(bench.run("b.data = 5").find("body.data is 5; expected a table") != std::string::npos);
    CHECK(bench.run("b.color = 5") ==
          "test.lua:1: a Body has no field \"color\" to set; keep values of your own in body.data");
    CHECK(bench.value("b:position()") == "1.0");
}

TEST_CASE("bodies have the same methods, and none can be replaced") {
    LuaBench bench;
    REQUIRE(bench.run(std::string(kScene) + " other = w:new_body{}") == "");
    for (const std::string method : {"position", "transform", "linear_velocity", "angle", "destroy"}) {
        CHECK(bench.value("b." + method + " == other." + method) == "true");
        CHECK(bench.run("b." + method + " = print") == "test.lua:1: a Body has no field \"" + method +
                                                           "\" to set; keep values of your own in body.data");
    }
}

TEST_CASE("a destroyed body raises a clear error, except for is_valid and data") {
    LuaBench bench;
    REQUIRE(bench.run(std::string(kScene) + " b.data.name = 'old' s = b:shapes()[1] b:destroy()") == "");
    CHECK(bench.value("b:is_valid()") == "false");
    CHECK(bench.value("s:is_valid()") == "false");
    CHECK(bench.value("b.data.name") == "old");
    CHECK(bench.run("b:position()") ==
          "test.lua:1: Body:position: this body was destroyed; is_valid() tells");
    CHECK(bench.run("b:destroy()") == "test.lua:1: Body:destroy: this body was destroyed; is_valid() tells");
    CHECK(bench.run("s:radius()") == "test.lua:1: Shape:radius: this shape was destroyed; is_valid() tells");
    // Another body in the same slot is another body.
    REQUIRE(bench.run("c = w:new_body{}") == "");
    CHECK(bench.value("b == c") == "false");
    CHECK(bench.value("b:is_valid()") == "false");
    CHECK(bench.value("c:is_valid()") == "true");
}

TEST_CASE("what is set is got") {
    LuaBench bench;
    REQUIRE(bench.run(kScene) == "");
    REQUIRE(bench.run("b:set_transform(3, 4, -1) b:set_linear_velocity(5, 6) b:set_angular_velocity(7) "
                      "b:set_linear_damping(0.25) "
                      "b:set_angular_damping(0.5) b:set_gravity_scale(2) b:set_allow_sleep(false)") == "");
    CHECK(bench.run("local x, y, a = b:transform() assert(x == 3 and y == 4 and math.abs(a + 1) < 1e-6)") ==
          "");
    CHECK(bench.run("local x, y = b:linear_velocity() assert(x == 5 and y == 6)") == "");
    CHECK(bench.value("b:angular_velocity()") == "7.0");
    CHECK(bench.value("b:linear_damping()") == "0.25");
    CHECK(bench.value("b:angular_damping()") == "0.5");
    CHECK(bench.value("b:gravity_scale()") == "2.0");
    CHECK(bench.value("b:allows_sleep()") == "false");
    CHECK(bench.value("b:type()") == "dynamic");
    CHECK(bench.run("b:set_position(8, 9) local x, y, a = b:transform() assert(x == 8 and y == 9 and "
                    "math.abs(a + 1) < 1e-6)") == "");
    CHECK(bench.run("b:set_angle(0) local x, y = b:to_world(1, 2) assert(x == 9 and y == 11)") == "");
    CHECK(bench.run("local x, y = b:to_local(9, 11) assert(x == 1 and y == 2)") == "");
}

TEST_CASE("impulses and forces change the velocity by the mass") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{ gravity_y = 0 } b = w:add_box{ width = 2, height = 1, "
                      "density = 2 }") == "");
    CHECK(bench.value("b:mass()") == "4.0");
    CHECK(
        bench.run(
            "b:apply_impulse_to_center(8, 0) local x = b:linear_velocity() assert(math.abs(x - 2) < 1e-6)") ==
        "");
    CHECK(
        bench.run("b:apply_angular_impulse(b:inertia()) assert(math.abs(b:angular_velocity() - 1) < 1e-6)") ==
        "");
    CHECK(bench.run("b:apply_force_to_center(0, 4) w:step(0.5) local _, y = b:linear_velocity() "
                    "assert(math.abs(y - 0.5) < 1e-5)") == "");
    CHECK(bench.run("b:set_linear_velocity(0/0, 0)").find("Body:set_linear_velocity: ") != std::string::npos);
}

TEST_CASE("compounds take shapes placed in the body's frame") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} b = w:new_body{ x = 10 } left = b:add_circle{ x = -2, "
                      "radius = 0.5 } "
                      "right = b:add_box{ x = 2, width = 1, height = 1, angle = math.pi / 4 } "
                      "bar = b:add_capsule{ length = 4, radius = 0.1, friction = 0.25, group = -3 }") == "");
    CHECK(bench.value("#b:shapes()") == "3");
    CHECK(bench.value("w:body_at(8, 0) == b") == "true");
    CHECK(bench.value("w:body_at(12.6, 0) == b") == "true");
    CHECK(bench.value("w:body_at(12.45, 0.45)") == "nil");
    CHECK(bench.value("left:kind() .. ' ' .. right:kind() .. ' ' .. bar:kind()") == "circle polygon capsule");
    CHECK(bench.run(
              "local x1, y1, x2, y2 = bar:points() assert(x1 == -2 and x2 == 2 and y1 == 0 and y2 == 0)") ==
          "");
    CHECK(bench.value("bar:friction()") == "0.25");
    CHECK(bench.run("local c, m, g = bar:filter() assert(c == 1 and m == -1 and g == -3)") == "");
    CHECK(bench.run("bar:set_friction(0.5) bar:set_restitution(0.75) assert(bar:friction() == 0.5 and "
                    "bar:restitution() == 0.75)") == "");
    CHECK(bench.run("left:destroy()") == "");
    CHECK(bench.value("#b:shapes()") == "2");
    CHECK(bench.value("left:is_valid()") == "false");
}

}  // namespace
}  // namespace cairn::scripting::test
