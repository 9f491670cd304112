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

TEST_CASE("a number that a float cannot hold is told beside others") {
    expect_faults(
        "{ bodies = { { shape = 'circle', radius = 1, friction = 1e300, surface_speed = 1e300 } } }",
        {"friction = 1e+300: must be between -3.4e38 and 3.4e38",
         "surface_speed = 1e+300: must be between -3.4e38 and 3.4e38"});
}

}  // namespace
}  // namespace cairn::scripting::test
