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

TEST_CASE("a name of the wrong kind of part is told with its field, and so is a body that a prefab lacks") {
    const std::string parts =
        "bodies = { { name = 'x', shape = 'circle', radius = 1 } }, "
        "triggers = { { name = 't', shape = 'circle', radius = 1 } }, ";
    expect_faults(
        "{ " + parts +
            "prefabs = { { name = 'r', prefab = 'rope' } }, joints = { "
            "{ name = 'j', joint = 'weld', x = 0, y = 0, body_a = 'r.1', body_b = 'x' }, "
            "{ joint = 'weld', x = 0, y = 0, body_b = 'x.3' }, { joint = 'weld', x = 0, y = 0, body_b = "
            "'t.1' }, "
            "{ joint = 'weld', x = 0, y = 0, body_b = 'j' }, { joint = 'weld', x = 0, y = 0, body_b = 'r' }, "
            "{ joint = 'weld', x = 0, y = 0, body_a = 'r.300', body_b = 'r.23' }, "
            "{ joint = 'weld', x = 0, y = 0, body_b = 'rr.2' } } }",
        {"bad.lua:1:298: joints[2].body_b = \"x.3\": \"x\" is a body, not a prefab",
         "joints[3].body_b = \"t.1\": \"t\" is a trigger, not a prefab",
         "joints[4].body_b = \"j\": \"j\" is a joint, not a body",
         "joints[5].body_b = \"r\": is a prefab; \"r.1\" is its first body",
         "joints[7].body_b = \"rr.2\": no such prefab; did you mean \"r\"? (r)",
         "joints[6].body_a = \"r.300\": there is no such body; \"r\" has 22 bodies",
         "joints[6].body_b = \"r.23\": there is no such body; \"r\" has 22 bodies"});
    // A prefab can hang on those that stand before it.
    expect_faults(
        "{ prefabs = { { name = 'a', prefab = 'rope', start_body = 'b.1' }, "
        "{ name = 'b', prefab = 'rope', start_body = 'b.2', end_body = 'a.1' } } }",
        {"prefabs[1].start_body = \"b.1\": must be of a prefab that stands before this one",
         "prefabs[2].start_body = \"b.2\": must be of a prefab that stands before this one"});
}

TEST_CASE("templates that name each other are told once each, and no body for them") {
    expect_faults(
        "{ templates = { a = { template = 'b' }, b = { template = 'a' } }, bodies = { { template = 'a' } } }",
        {"templates.a.template = \"b\": a template cannot have a template of its own",
         "templates.b.template = \"a\": a template cannot have a template of its own"});
}

TEST_CASE("empty lists are told with the path of their field, and so is what is wrong in lists") {
    expect_faults(
        "{ bodies = { { shapes = {} } }, prefabs = { { prefab = 'gear_train', radii = {} }, "
        "{ prefab = 'elevator', floors = {} }, { prefab = 'gear_train', radii = { 1, -1 } }, "
        "{ prefab = 'elevator', floors = { 0, 'a' } } } }",
        {"bad.lua:1:25: bodies[1].shapes = {}: must hold at least one shape",
         "bad.lua:1:78: prefabs[1].radii = {}: must hold at least one radius",
         "prefabs[2].floors = {}: must hold at least one height",
         "prefabs[3].radii[2] = -1: must be above 0 and finite",
         "prefabs[4].floors[2] = \"a\": must be a number"});
    LuaBench bench;
    CHECK(bench.run("cairn.prefab.gear_train(cairn.physics.new_world{}, { radii = {} })") ==
          "test.lua:1: cairn.prefab.gear_train: radii = {}: must hold at least one radius");
}

TEST_CASE("a number that no float can hold is told with its path, beside the others") {
    expect_faults("{ bodies = { { shape = 'circle', radius = 1e999 }, { shape = 'circle', radius = -1 } } }",
                  {"bad.lua:1:43: bodies[1].radius = 1e999: is too large for a number",
                   "bodies[2].radius = -1: must be above 0"});
}

TEST_CASE("the bricks of a wall and the bodies of a level are limited, and memory is not filled first") {
    const std::string rule =
        "courses is 1000, but must be at most 10 where columns is 1000: a wall has at most 10000 bricks";
    expect_faults("{ prefabs = { { prefab = 'brick_wall', columns = 1000, courses = 1000 } } }",
                  {"prefabs[1]: " + rule});
    // 100 courses of 100 bricks are 10050: every second one begins with half a brick.
    std::string walls;
    for (int i = 0; i < 12; ++i) walls += "{ prefab = 'brick_wall', columns = 100, courses = 100 }, ";
    expect_faults("{ prefabs = { " + walls + "} }",
                  {"prefabs[10]: with it the level has 100500 bodies, but must have at most 100000"});
    LuaBench bench;
    CHECK(
        bench.run("cairn.prefab.brick_wall(cairn.physics.new_world{}, { columns = 1000, courses = 1000 })") ==
        "test.lua:1: cairn.prefab.brick_wall: " + rule);
}

}  // namespace
}  // namespace cairn::scripting::test
