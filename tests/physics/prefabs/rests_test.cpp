// What stands, stands still: with sleep off, so that nothing but the solver holds it.
#include <catch2/catch.hpp>

#include <cairn/physics/prefabs/all.h>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

// m. In 20 s after 15 s: 1 mm in ten minutes.
constexpr double kStill_m = 3.3e-5;

double way_at_rest_m(World& world) {
    run_for(world, 15);
    const std::vector<BodyId> bodies = world.bodies();
    std::vector<Position> before;
    for (const BodyId body : bodies) before.push_back(world.body(body)->position());
    run_for(world, 20);
    double farthest = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Vec2 way = world.body(bodies[i])->position() - before[i];
        farthest = std::max(farthest, static_cast<double>(length(way)));
    }
    return farthest;
}

TEST_CASE("crates on a bridge, level or hanging deep, do not creep down its slopes") {
    for (const float slack : {0.01f, 0.05f}) {
        World world({.enable_sleep = false});
        create_bridge(world, {.slack = slack}).value();
        for (int i = 0; i < 3; ++i)
            add(world, {.position_m = {3.0 + 2 * i, 1}}, Box{0.4f, 0.4f}, {.density_kg_m2 = 5});
        CHECK(way_at_rest_m(world) < kStill_m);
    }
}

TEST_CASE("a vehicle with its brakes on does not creep down a slope") {
    World world({.enable_sleep = false});
    add(world, {.type = BodyType::Static, .angle_rad = 0.15}, Box{50, 1, {0, -1}});
    const Vehicle vehicle = create_vehicle(world, {.position_m = {0, 1}}).value();
    brake_vehicle(world, vehicle).value();
    CHECK(way_at_rest_m(world) < kStill_m);
}

TEST_CASE("a ragdoll on the ground, a blob, a wall and a loaded elevator do not creep") {
    World world({.enable_sleep = false});
    add_ground(world);
    create_ragdoll(world, {.position_m = {-10, 2}}).value();
    create_blob(world, {.position_m = {0, 2}}).value();
    create_brick_wall(world, {.position_m = {10, 0}}).value();
    create_elevator(world, {.position_m = {20, 1}}).value();
    add(world, {.position_m = {20, 1.5}}, Box{}, {.density_kg_m2 = 100});
    CHECK(way_at_rest_m(world) < kStill_m);
}

}  // namespace
}  // namespace cairn::physics
