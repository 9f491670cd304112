#include <catch2/catch.hpp>

#include "bind/joint_fields.h"
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

/// A static body `a` at the origin and a square `b` of 2 kg at (1, 0), without gravity.
const char* const kTwoBodies = R"(
w = cairn.physics.new_world{ gravity_y = 0 }
a = w:new_body{ type = "static" }
b = w:add_box{ x = 1, width = 1, height = 1, density = 2 }
function steps(n) for i = 1, n do w:step(1 / 60) end end
)";

double number(LuaBench& bench, const std::string& expression) {
    return std::stod(bench.value(expression));
}

TEST_CASE("all kinds of joints can be made from Lua") {
    LuaBench bench;
    REQUIRE(bench.run(kTwoBodies) == "");
    REQUIRE(bench.run("c = w:add_box{ x = 3, width = 1, height = 1 } "
                      "r = w:add_revolute_joint{ body_a = a, body_b = b, x = 0, y = 0 } "
                      "p = w:add_prismatic_joint{ body_a = a, body_b = c, x = 3, y = 0 } "
                      "joints = { r, p, "
                      "w:add_distance_joint{ body_a = b, body_b = c }, "
                      "w:add_weld_joint{ body_a = b, body_b = c, x = 2, y = 0 }, "
                      "w:add_wheel_joint{ body_a = b, body_b = c, x = 3, y = 0 }, "
                      "w:add_motor_joint{ body_a = b, body_b = c, x = 3, y = 0 }, "
                      "w:add_mouse_joint{ body = c, x = 3, y = 0 }, "
                      "w:add_gear_joint{ joint_1 = r, joint_2 = p, ratio = 2 }, "
                      "w:add_pulley_joint{ body_a = b, body_b = c, wheel_x_a = 1, wheel_y_a = 5, "
                      "wheel_x_b = 3, wheel_y_b = 5 }, "
                      "w:add_friction_joint{ body_a = b, body_b = c, x = 3, y = 0 }, "
                      "w:add_filter_joint{ body_a = b, body_b = c } }") == "");
    REQUIRE(bench.run("names = '' for _, j in ipairs(joints) do names = names .. j:kind() .. ' ' end") == "");
    CHECK(bench.value("names") ==
          "revolute prismatic distance weld wheel motor mouse gear pulley friction filter ");
    CHECK(bench.run("steps(2)") == "");
}

TEST_CASE("a new joint is at rest where its bodies stand") {
    LuaBench bench;
    REQUIRE(bench.run(kTwoBodies) == "");
    REQUIRE(
        bench.run(
            "b:set_position(1, 2) b:set_angle(0.7) "
            "for _, kind in ipairs{ 'revolute', 'prismatic', 'weld', 'wheel', 'motor', 'friction' } do "
            "  local j = w['add_' .. kind .. '_joint'](w, { body_a = a, body_b = b, x = 0.5, y = 1 }) "
            "  if kind ~= 'wheel' and kind ~= 'friction' then assert(math.abs(j:angle()) < 1e-6, kind) end "
            "  assert(math.abs(j:translation()) < 1e-6, kind) "
            "  assert(j:length() < 1e-6, kind) "
            "  steps(30) j:destroy() end "
            "x, y = b:position()") == "");
    CHECK(number(bench, "x") == Approx(1).margin(1e-4));
    CHECK(number(bench, "y") == Approx(2).margin(1e-4));
    CHECK(number(bench, "b:angle()") == Approx(0.7).margin(1e-4));
}

TEST_CASE("every parameter that has a default has the one that the reference says") {
    LuaBench bench;
    REQUIRE(bench.run(kTwoBodies) == "");
    REQUIRE(bench.run("joints = { "
                      "w:add_distance_joint{ body_a = a, body_b = b }, "
                      "w:add_revolute_joint{ body_a = a, body_b = b, x = 0, y = 0 }, "
                      "w:add_prismatic_joint{ body_a = a, body_b = b, x = 0, y = 0 }, "
                      "w:add_weld_joint{ body_a = a, body_b = b, x = 0, y = 0 }, "
                      "w:add_wheel_joint{ body_a = a, body_b = b, x = 0, y = 0 }, "
                      "w:add_motor_joint{ body_a = a, body_b = b, x = 0, y = 0 }, "
                      "w:add_mouse_joint{ body = b, x = 0, y = 0 } } "
                      "joints[8] = w:add_gear_joint{ joint_1 = joints[2], joint_2 = "
                      "w:add_revolute_joint{ body_a = a, body_b = w:add_circle{ x = 9, radius = 1 }, "
                      "x = 9, y = 0 } } "
                      "joints[9] = w:add_pulley_joint{ body_a = a, body_b = b, wheel_x_a = 0, wheel_y_a = 5, "
                      "wheel_x_b = 1, wheel_y_b = 5 } "
                      "joints[10] = w:add_friction_joint{ body_a = a, body_b = b, x = 0, y = 0 } "
                      "joints[11] = w:add_filter_joint{ body_a = a, body_b = b }") == "");
    int compared = 0;
    for (std::size_t kind = 0; kind < std::size(kJointKinds); ++kind) {
        for (const JointParameter& parameter : kJointKinds[kind].made) {
            const Field& field = *parameter.field;
            if (field.default_text == nullptr || *field.default_text == '\0') continue;
            INFO(kJointKinds[kind].name << " " << field.name);
            const std::string joint = "joints[" + std::to_string(kind + 1) + "]";
            CHECK(bench.value("math.abs((function(v) return v == true and 1 or v == false and 0 or v end)(" +
                              joint + ":parameter('" + field.name + "')) - " +
                              (field.type == FieldType::Boolean ? std::to_string(field.default_number)
                                                                : std::string(field.default_text)) +
                              ") < 1e-6 or " + joint + ":parameter('" + field.name +
                              "') == " + field.default_text) == "true");
            ++compared;
        }
    }
    CHECK(compared > 50);
}

TEST_CASE("every parameter can be read, changed and read again") {
    LuaBench bench;
    REQUIRE(bench.run(kTwoBodies) == "");
    REQUIRE(bench.run("j = w:add_revolute_joint{ body_a = a, body_b = b, x = 0, y = 0, motor_speed = 2, "
                      "max_motor_torque = 50 }") == "");
    CHECK(bench.value("j:parameter('enable_motor')") == "true");
    CHECK(bench.value("j:parameter('enable_limit')") == "false");
    REQUIRE(bench.run("j:change{ lower = -1, upper = 20, motor_speed = 3, break_force = 1000 }") == "");
    CHECK(bench.value("j:parameter('lower')") == "-1.0");
    CHECK(bench.value("j:parameter('upper')") == "20.0");
    CHECK(bench.value("j:parameter('enable_limit')") == "true");
    CHECK(bench.value("j:parameter('max_motor_torque')") == "50.0");
    CHECK(bench.value("j:parameters().break_force") == "1000.0");
    REQUIRE(bench.run("j:change{ enable_motor = false, motor_speed = 4 }") == "");
    CHECK(bench.value("j:parameter('enable_motor')") == "false");
    // All of them at once: what is read can be written back.
    REQUIRE(bench.run("before = j:parameters() j:change(before) "
                      "for k, v in pairs(j:parameters()) do assert(before[k] == v, k) end") == "");
}

TEST_CASE("a motor turns at the speed it is told, and sliders slide along their axis") {
    LuaBench bench;
    REQUIRE(bench.run(kTwoBodies) == "");
    REQUIRE(bench.run("j = w:add_revolute_joint{ body_a = a, body_b = b, x = 1, y = 0, motor_speed = 3, "
                      "max_motor_torque = 1000 } steps(60)") == "");
    CHECK(number(bench, "j:angle()") == Approx(3).epsilon(0.02));
    REQUIRE(
        bench.run("j:destroy() b:set_angular_velocity(0) b:set_angle(0) b:set_position(1, 0) "
                  "j = w:add_prismatic_joint{ body_a = a, body_b = b, x = 1, y = 0, axis_x = 3, axis_y = 4, "
                  "motor_speed = 2, max_motor_force = 1000 } steps(60) x, y = b:position()") == "");
    CHECK(number(bench, "j:translation()") == Approx(2).epsilon(0.02));
    CHECK(number(bench, "(x - 1) / y") == Approx(0.75).epsilon(1e-3));
}

TEST_CASE("a joint tells what it bears") {
    LuaBench bench;
    REQUIRE(bench.run(kTwoBodies) == "");
    REQUIRE(bench.run("w:set_gravity(0, -10) j = w:add_weld_joint{ body_a = a, body_b = b, x = 0, y = 0 } "
                      "steps(120) fx, fy = j:reaction_force()") == "");
    CHECK(number(bench, "fy") == Approx(20).epsilon(0.01));
    CHECK(number(bench, "j:reaction_torque()") == Approx(20).epsilon(0.05));  // 20 N at 1 m
}

TEST_CASE("a joint that bears too much breaks, and says which one it was") {
    LuaBench bench;
    REQUIRE(bench.run(kTwoBodies) == "");
    REQUIRE(bench.run("w:set_gravity(0, -10) "
                      "weak = w:add_weld_joint{ body_a = a, body_b = b, x = 1, y = 0, break_force = 10 } "
                      "found = 0 steps(1) "
                      "for joint, body_a, body_b, x, y, fx, fy, torque, kind in w:joint_breaks() do "
                      "  w:add_distance_joint{ body_a = a, body_b = b } "
                      "  assert(joint == weak and not joint:is_valid()) "
                      "  assert(kind == 'weld' and joint:kind() == 'weld') "
                      "  assert(body_a == a and body_b == b) "
                      "  found = found + 1 force_x, force_y, place_x = fx, fy, x end") == "");
    CHECK(bench.value("found") == "1");
    CHECK(number(bench, "force_y") > 10);
    CHECK(number(bench, "place_x") == Approx(1).margin(0.01));
    REQUIRE(bench.run("steps(1) for joint in w:joint_breaks() do error('broke again') end") == "");
    CHECK(bench.value("weak:kind()") ==
          "error: test.lua:1: Joint:kind: this joint was destroyed; is_valid() tells");
    REQUIRE(bench.run("strong = w:add_weld_joint{ body_a = a, body_b = b, x = 1, y = 0, break_force = 1000 } "
                      "steps(60)") == "");
    CHECK(bench.value("strong:is_valid()") == "true");
}

TEST_CASE("a mouse joint carries a body to its target") {
    LuaBench bench;
    REQUIRE(bench.run(kTwoBodies) == "");
    REQUIRE(bench.run("j = w:add_mouse_joint{ body = b, x = 1, y = 0 } j:set_target(4, 3) steps(120) "
                      "x, y = b:position()") == "");
    CHECK(number(bench, "x") == Approx(4).margin(0.01));
    CHECK(number(bench, "y") == Approx(3).margin(0.01));
    CHECK(bench.value("j:body_a() == w:ground()") == "true");
    CHECK(bench.value("w:ground():type()") == "static");
    CHECK(bench.run("j:set_target(4)") ==
          "test.lua:1: Joint:set_target: y is nil; a mouse joint has a target x, y");
}

TEST_CASE("wrong parameters of joints are named with their value and rule") {
    LuaBench bench;
    REQUIRE(bench.run(kTwoBodies) == "");
    REQUIRE(bench.run("j = w:add_distance_joint{ body_a = a, body_b = b }") == "");
    CHECK(bench.run("j:change{ damping_ratio = -1 }") ==
          "test.lua:1: Joint:change: damping_ratio = -1: must be at least 0 and finite");
    CHECK(bench.run("j:change{ break_force = 0 }").find("break_force = 0: must be above 0") !=
          std::string::npos);
    CHECK(bench.run("j:change{ min_length = 3 }") ==
          "test.lua:1: Joint:change: min_length is 3, but must be at most length");
    CHECK(bench.run("j:change{ motor_speed = 1 }").find("unknown field \"motor_speed\"") !=
          std::string::npos);
    CHECK(bench.run("j:change{ lenght = 1 }").find("did you mean \"length\"") != std::string::npos);
    CHECK(bench.run("j:parameter('lenght')").find("did you mean \"length\"") != std::string::npos);
    CHECK(bench
              .run("w:add_prismatic_joint{ body_a = a, body_b = b, x = 0, y = 0, axis_angle = 1, axis_x = 1, "
                   "axis_y = 0 }")
              .find("axis_angle is given beside axis_x") != std::string::npos);
    CHECK(bench.run("w:add_wheel_joint{ body_a = a, body_b = b, x = 0, y = 0, axis_x = 0, axis_y = 0 }")
              .find("axis_x, axis_y = 0, 0: must be a direction") != std::string::npos);
    CHECK(bench.run("w:add_gear_joint{ joint_1 = j, joint_2 = 3 }").find("joint_2 = 3: must be a Joint") !=
          std::string::npos);
    CHECK(bench.run("w:add_gear_joint{ joint_1 = j, joint_2 = j }").find("must be revolute or prismatic") !=
          std::string::npos);
    CHECK(bench.value("j:parameter('damping_ratio')") == "0.0");
}

}  // namespace
}  // namespace cairn::scripting::test
