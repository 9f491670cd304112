// Faults of levels: none hides another one.
#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

/// The faults of a level, and that there are no others.
void expect_faults(const std::string& level, const std::vector<std::string>& expected) {
    INFO(level);
    LuaBench bench(GameFiles{{"bad.lua", level}});
    REQUIRE(bench.run("faults = cairn.level.check('bad.lua')") == "");
    INFO(bench.value("table.concat(faults, '\\n')"));
    REQUIRE(bench.value("#faults") == std::to_string(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CHECK_THAT(bench.value("faults[" + std::to_string(i + 1) + "]"), Catch::Contains(expected[i]));
    }
}

TEST_CASE("the form of a shape is tried out although other fields of it are wrong") {
    expect_faults(
        "{ bodies = { { shape = 'polygon', friction = -1, points = { { 0, 0 }, { 1, 0 }, { 2, 0 } } } } }",
        {"bodies[1].friction = -1: must be at least 0", "bodies[1]: points lie on one line"});
    expect_faults("{ bodies = { { shape = 'chain', type = 'sttic', points = { { 0, 0 } } } } }",
                  {"bodies[1].type = \"sttic\": no such type; did you mean \"static\"?",
                   "bodies[1]: points has 1 points, but must have at least"});
    expect_faults(
        "{ triggers = { { name = 'a b', shape = 'polygon', mask = 0.5, "
        "points = { { 0, 0 }, { 1, 0 }, { 2, 0 } } } } }",
        {"triggers[1].name = \"a b\": must be letters", "triggers[1].mask = 0.5: must be an integer",
         "triggers[1]: points lie on one line"});
}

TEST_CASE("the forms of a body's shapes are tried out although the body or the shape is faulty") {
    expect_faults(
        "{ bodies = { { x = 'left', shapes = { "
        "{ shape = 'polygon', points = { { 0, 0 }, { 1, 0 }, { 2, 0 } } }, "
        "{ shape = 'chain', frction = 1, points = { { 0, 0 } } } } } } }",
        {"bodies[1].x = \"left\": must be a number", "shapes[2].frction = 1: unknown field",
         "bodies[1].shapes[1]: points lie on one line", "bodies[1].shapes[2]: points has 1 points"});
}

TEST_CASE("a form that is faulty itself, or lacks something, is told once") {
    expect_faults(
        "{ bodies = { { shape = 'polygon', friction = -1, points = { { 0, 0 }, { 1 }, { 2, 0 } } } } }",
        {"bodies[1].friction = -1", "bodies[1].points[2]: must be { x, y }"});
    expect_faults("{ bodies = { { shape = 'polygon', friction = -1 } } }",
                  {"bodies[1]: \"points\" is missing", "bodies[1].friction = -1"});
    expect_faults("{ bodies = { { shape = 'box', width = 1, height = -1, type = 'sttic' } } }",
                  {"bodies[1].height = -1", "bodies[1].type = \"sttic\""});
}

TEST_CASE("every number of a prefab that is out of its range is told") {
    expect_faults(
        "{ prefabs = { { prefab = 'rope', x = 0, y = 0, to_x = 5, to_y = 0, links = -4, density = -1, "
        "frction = 2 } } }",
        {"prefabs[1].links = -4: must be from 2 to 10000", "prefabs[1].density = -1: must be at least 0",
         "prefabs[1].frction = 2: unknown field; did you mean \"friction\"?"});
    expect_faults(
        "{ prefabs = { { prefab = 'brick_wall', columns = 0, brick_width = 0.02, mortar = 0 }, "
        "{ prefab = 'windmill', sails = 25, sail_width = 0, restitution = 2 } } }",
        {"columns = 0: must be from 1 to 1000", "brick_width = 0.02: must be above 0.02",
         "mortar = 0: must be above 0", "sails = 25: must be from 2 to 24", "sail_width = 0: must be above 0",
         "restitution = 2: must be from 0 to 1"});
}

TEST_CASE("rules over several fields are judged where these fields are sound, whatever else is wrong") {
    const std::string density = "prefabs[1].density = -1: must be at least 0";
    expect_faults("{ prefabs = { { prefab = 'rope', x = 1, to_x = 1, to_y = 0, density = -1 } } }",
                  {density, "prefabs[1]: to - from is 0, but must be longer than 0.01 m"});
    expect_faults("{ prefabs = { { prefab = 'rope', to_x = 5, length = 1, density = -1, links = -4 } } }",
                  {density, "prefabs[1].links = -4",
                   "prefabs[1]: length is 1, but must be from the distance of the ends to 100 times that"});
    expect_faults("{ prefabs = { { prefab = 'pulley_lift', distance = 1, width = 2, ratio = 0 } } }",
                  {"ratio = 0: must be above 0",
                   "prefabs[1]: distance is 1, but must be finite and greater than width"});
    expect_faults(
        "{ prefabs = { { prefab = 'rope', to_x = 0, densty = 1, start_body = 'gone', friction = 'x', "
        "radius = 0, damping = -1, restitution = 2 } } }",
        {"densty = 1: unknown field", "start_body = \"gone\"", "friction = \"x\"", "radius = 0",
         "damping = -1", "restitution = 2", "to - from is 0"});
    expect_faults(
        "{ bodies = { { name = 'a', shape = 'circle', radius = 1, type = 'dynamic' } }, joints = { "
        "{ joint = 'revolute', body_b = 'a', x = 0, y = 0, lower = 1, upper = -1, break_force = -1 } } }",
        {"break_force = -1", "joints[1]: lower is 1, but must be"});
}

TEST_CASE("all broken rules over several fields of a prefab are told, each on its own") {
    const std::string distance = "prefabs[1]: distance is 1, but must be finite and greater than width";
    const std::string rope = "prefabs[1]: rope is 1, but must be finite and greater than travel";
    expect_faults("{ prefabs = { { prefab = 'pulley_lift', distance = 1, rope = 1, travel = 3 } } }",
                  {distance, rope});
    expect_faults(
        "{ prefabs = { { prefab = 'pulley_lift', distance = 1, rope = 1, travel = 3, ratio = 0 } } }",
        {"ratio = 0: must be above 0", distance, rope});
    // Another travel may be right for the rope.
    expect_faults("{ prefabs = { { prefab = 'pulley_lift', distance = 1, rope = 1, travel = -3 } } }",
                  {"travel = -3: must be above 0", distance});
    LuaBench bench;
    CHECK(
        bench.run("cairn.prefab.pulley_lift(cairn.physics.new_world{}, { distance = 1, travel = 9 })") ==
        "test.lua:1: cairn.prefab.pulley_lift: distance is 1, but must be finite and greater than width; and "
        "rope is 5, but must be finite and greater than travel");
}

TEST_CASE("rules over a faulty field and others are not judged: another value may keep them") {
    expect_faults("{ prefabs = { { prefab = 'pulley_lift', rope = 1, travel = -1 } } }", {"travel = -1"});
    expect_faults("{ prefabs = { { prefab = 'pulley_lift', rope = -1, travel = 4 } } }", {"rope = -1"});
    expect_faults("{ prefabs = { { prefab = 'pulley_lift', width = 9, distance = 0 } } }", {"distance = 0"});
    expect_faults("{ prefabs = { { prefab = 'pulley_lift', width = 'wide', distance = 0.1 } } }",
                  {"width = \"wide\""});
    expect_faults("{ prefabs = { { prefab = 'rope', to_x = 5, length = -1, links = 2000 } } }",
                  {"length = -1"});
    expect_faults("{ prefabs = { { prefab = 'rope', x = 5, to_x = 'far', to_y = 0 } } }", {"to_x = \"far\""});
    expect_faults(
        "{ prefabs = { { prefab = 'bridge', to_x = 1, planks = -1, slack = 2, density = -1, friction = -1 } "
        "} }",
        {"planks = -1", "slack = 2", "density = -1", "friction = -1"});
    expect_faults(
        "{ prefabs = { { name = 'r', prefab = 'rope', links = -4 } }, joints = { "
        "{ joint = 'pin', body_b = 'r.3' } } }",
        {"links = -4", "joint = \"pin\""});
}

TEST_CASE("a number that a float cannot hold is told beside others") {
    expect_faults(
        "{ bodies = { { shape = 'circle', radius = 1, friction = 1e300, surface_speed = 1e300 } } }",
        {"friction = 1e+300: must be between -3.4e38 and 3.4e38",
         "surface_speed = 1e+300: must be between -3.4e38 and 3.4e38"});
}

}  // namespace
}  // namespace cairn::scripting::test
