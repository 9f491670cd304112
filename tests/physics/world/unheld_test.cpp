// What held others is taken away: they go on from what acts on them now, and not from what they bore.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

std::vector<BodyId> add_column(World& world, int boxes) {
    std::vector<BodyId> column;
    for (int i = 0; i < boxes; ++i)
        column.push_back(add(world, {.position_m = {0, 0.5 + i}}, Box{0.5f, 0.5f}));
    return column;
}

}  // namespace

TEST_CASE("a tower of which the ground is taken away falls as one, as all things fall") {
    const int boxes = GENERATE(5, 20, 100);
    const bool sleeps = GENERATE(true, false);
    CAPTURE(boxes, sleeps);
    World world({.enable_sleep = sleeps});
    const BodyId ground = add_ground(world);
    const std::vector<BodyId> column = add_column(world, boxes);
    run_for(world, 2);
    world.destroy_body(ground).value();
    for (int step = 1; step <= 60; ++step) {
        world.step(kStep_s).value();
        for (const BodyId box : column) {
            REQUIRE(static_cast<double>(world.body(box)->linear_velocity().y) ==
                    Approx(-10.0 * step / 60).margin(0.001));
        }
    }
}

TEST_CASE("a shape that held a tower and is taken away, or refuses it now, leaves it falling as one") {
    const bool refuses = GENERATE(true, false);
    World world;
    const BodyId body = world.create_body({.type = BodyType::Static}).value();
    const ShapeId floor = world.create_shape(body, Box{20, 1, {0, -1}}).value();
    const std::vector<BodyId> column = add_column(world, 50);
    run_for(world, 2);
    if (refuses) {
        world.shape(floor)->set_filter({.mask = 0});
    } else {
        world.destroy_shape(floor).value();
    }
    world.step(kStep_s).value();
    for (const BodyId box : column)
        CHECK(static_cast<double>(world.body(box)->linear_velocity().y) == Approx(-10.0 / 60).margin(0.001));
}

TEST_CASE("light boxes from which a heavy one is lifted stay where they are") {
    const float ratio = GENERATE(20.0f, 1e2f, 1e4f);
    CAPTURE(ratio);
    World world({.enable_sleep = false});
    add_ground(world);
    const std::vector<BodyId> column = add_column(world, 5);
    const BodyId load = add(world, {.position_m = {0, 5.5}}, Box{0.5f, 0.5f}, {.density_kg_m2 = ratio});
    run_for(world, 3);
    world.destroy_body(load).value();
    float fastest = 0;
    for (int step = 0; step < 60; ++step) {
        world.step(kStep_s).value();
        for (const BodyId box : column)
            fastest = std::max(fastest, length(world.body(box)->linear_velocity()));
    }
    // They begin anew, and settle.
    CHECK(fastest < 0.1f);
    for (int i = 0; i < 5; ++i)
        CHECK(world.body(column[static_cast<std::size_t>(i)])->position().y == Approx(0.5 + i).margin(0.003));
}

}  // namespace cairn::physics
