// Walls: they stand, and break where they are hit.
#include <catch2/catch.hpp>

#include <cairn/physics/prefabs/brick_wall.h>

#include "physics/support/resting.h"

namespace cairn::physics {
namespace {

using namespace test;

TEST_CASE("a wall stands and sleeps whole") {
    World world;
    add_ground(world);
    const BrickWall wall = create_brick_wall(world, {}).value();
    // Even courses have 6 bricks; odd ones begin and end with half a brick: 7.
    CHECK(wall.bodies.size() == 4 * 6 + 4 * 7);
    CHECK(sleeps_within(world, 10));
    CHECK(world.counts().joints == static_cast<int>(wall.joints.size()));
    CHECK(world.body(wall.bodies.back())->position().y == Approx(7.5 * 0.25).margin(0.01));
}

TEST_CASE("a wall has at most ten thousand bricks") {
    World world;
    CHECK(create_brick_wall(world, {.columns = 1000, .courses = 11}).error().message ==
          "brick_wall.courses is 11, but must be at most 10 where columns is 1000: a wall has at most 10000 "
          "bricks");
    CHECK(create_brick_wall(world, {.columns = 3, .courses = 1000}).value().bodies.size() == 3500);
    // A count beyond its own range is told alone.
    CHECK(create_brick_wall(world, {.columns = 1001, .courses = 1000}).error().message ==
          "brick_wall.columns is 1001, but must be from 1 to 1000");
    CHECK(world.counts().bodies == 3500);
}

TEST_CASE("a heavy ball breaks a wall, and a light one does not") {
    for (const bool is_heavy : {false, true}) {
        World world;
        add_ground(world);
        const BrickWall wall = create_brick_wall(world, {}).value();
        run_for(world, 1);
        add(world, {.position_m = {-4, 1.2}, .linear_velocity_m_s = {is_heavy ? 15.0f : 3.0f, 2}},
            Circle{.radius_m = 0.3f},
            {.density_kg_m2 = is_heavy ? 40.0f : 0.2f, .material = {.rolling_resistance = 0.2f}});
        run_for(world, 2);
        const int broken = static_cast<int>(wall.joints.size()) - world.counts().joints;
        INFO("heavy: " << is_heavy << ", broken: " << broken);
        CHECK((broken > 5) == is_heavy);
        CHECK((broken > 0) == is_heavy);
        CHECK(sleeps_within(world, 10));
    }
}

TEST_CASE("mortar bears what it says: a brick that sticks out of a wall, by its weight") {
    // Two bricks, the left one held. What comes on at once is felt 1.4 times for a moment.
    const double weight = 10 * 0.5 * 0.25;
    for (const bool is_strong : {false, true}) {
        World world;
        BrickWallDef def{.columns = 2, .courses = 1};
        // Force: mortar 0.25 m. Torque: weight 0.25 m <= mortar 0.25^2 / 4, that is 4 weight <= 0.25 mortar.
        def.mortar_n_m = static_cast<float>((is_strong ? 1.6 : 0.9) * 4 * weight / 0.25);
        const BrickWall wall = create_brick_wall(world, def).value();
        const BodyId hook = world.create_body({.type = BodyType::Static}).value();
        world
            .create_joint(
                WeldJointDef{.body_a = hook, .body_b = wall.bodies[0], .local_anchor_a_m = {-0.25f, 0.125f}})
            .value();
        run_for(world, 2);
        CHECK(world.contains(wall.joints[0]) == is_strong);
    }
}

}  // namespace
}  // namespace cairn::physics
