// What is told about a world as a whole, against what was put into it.
#include <array>
#include <catch2/catch.hpp>

#include "physics/support/scenes.h"

namespace cairn::physics {

using namespace test;

TEST_CASE("the deepest overlap is that of the shapes as they stand, not as the last step found them") {
    World world({.gravity_m_s2 = {}, .enable_sleep = false});
    const BodyId left = add(world, {.position_m = {0, 0}}, Circle{{}, 0.5f});
    const BodyId right = add(world, {.position_m = {0.97, 0}}, Circle{{}, 0.5f});
    add(world, {.position_m = {0, 5}}, Box{0.5f, 0.5f});
    CHECK(world.max_penetration_m() == 0);  // no step has looked for contacts yet
    step_times(world, 1);
    const double distance = world.body(right)->position().x - world.body(left)->position().x;
    REQUIRE(distance < 1);
    CHECK(world.max_penetration_m() == Approx(1 - distance).margin(1e-6));
}

TEST_CASE("of several overlaps the deepest counts") {
    World world({.gravity_m_s2 = {}});
    const std::array depths_m{0.01, 0.04, 0.02};
    for (std::size_t i = 0; i < depths_m.size(); ++i) {
        const double x = 5.0 * static_cast<double>(i);
        add(world, {.type = BodyType::Static, .position_m = {x, 0}}, Box{0.5f, 0.5f});
        add(world, {.position_m = {x, 1 - depths_m[i]}}, Box{0.5f, 0.5f});
    }
    world.step(1e-6f).value();  // finds the contacts, and moves bodies by micrometres
    CHECK(world.max_penetration_m() == Approx(0.04).margin(1e-5));
}

TEST_CASE("bodies awake are counted without walking over the contacts, to the same number") {
    World world;
    build_stack(world);
    add(world, {.type = BodyType::Kinematic, .position_m = {20, 5}, .angular_velocity_rad_s = 1}, Box{1, 1});
    bool slept = false;
    for (int i = 0; i < 240; ++i) {
        step_times(world, 1);
        CHECK(world.awake_body_count() == world.counts().awake_bodies);
        slept = slept || world.awake_body_count() == 1;
    }
    CHECK(slept);
}

}  // namespace cairn::physics
