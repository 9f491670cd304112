// What the definitions of prefabs say in numbers, against what is then there: masses, lengths, loads.
#include <catch2/catch.hpp>

#include <cairn/physics/prefabs/all.h>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr double kCircle = 3.14159265358979;

double mass_kg(World& world, const std::vector<BodyId>& bodies) {
    double sum = 0;
    for (const BodyId body : bodies) sum += static_cast<double>(world.body(body)->mass());
    return sum;
}

double way_m(Position from, Position to) {
    return static_cast<double>(length(to - from));
}

TEST_CASE("prefabs weigh what their outlines and densities say") {
    World world;
    const LinkChain chain =
        create_link_chain(world, {.links = 7, .link_length_m = 0.4f, .thickness_m = 0.1f}).value();
    CHECK(mass_kg(world, chain.bodies) == Approx(7 * (0.4 * 0.1 + kCircle * 0.05 * 0.05)).epsilon(1e-5));
    // Planks leave a fiftieth of their length between them.
    const Bridge bridge = create_bridge(world, {.planks = 25, .slack = 0.02f}).value();
    CHECK(mass_kg(world, bridge.planks) == Approx(0.98 * 10.2 * 0.2 * 4).epsilon(1e-4));
    const Blob blob = create_blob(world, {.rings = 2, .shape = {.density_kg_m2 = 3}}).value();
    CHECK(mass_kg(world, blob.bodies) == Approx(3 * 19 * kCircle * 0.15 * 0.15).epsilon(1e-5));
    const BrickWall wall = create_brick_wall(world, {.shape = {.density_kg_m2 = 2}}).value();
    CHECK(mass_kg(world, wall.bodies) == Approx(2 * (6 * 0.5) * (8 * 0.25)).epsilon(1e-5));
    const Vehicle vehicle = create_vehicle(world, {}).value();
    CHECK(mass_kg(world, vehicle.bodies) == Approx(2 * 3 * 0.6 + 2 * kCircle * 0.4 * 0.4).epsilon(1e-5));
    const Pendulum pendulum = create_pendulum(world, {.bobs = 3}).value();
    CHECK(mass_kg(world, pendulum.bobs) == Approx(3 * kCircle * 0.15 * 0.15).epsilon(1e-5));
}

TEST_CASE("the pins of a bridge are as far apart as its planks are long, under any load") {
    World world;
    const Bridge bridge = create_bridge(world, {.planks = 20, .slack = 0.03f}).value();
    add(world, {.position_m = {4, 0.5}}, Box{0.4f, 0.4f}, {.density_kg_m2 = 5000});
    add(world, {.position_m = {6, 0.5}}, Box{0.4f, 0.4f}, {.density_kg_m2 = 50});
    run_for(world, 10);
    for (std::size_t i = 1; i < bridge.pins.size(); ++i) {
        const Position from = world.joint(bridge.pins[i - 1])->anchor_b();
        CHECK(way_m(from, world.joint(bridge.pins[i])->anchor_a()) == Approx(10.3 / 20).epsilon(1e-3));
    }
    CHECK(world.report().max_joint_error_m < 1e-4f);
}

TEST_CASE("a ragdoll is as tall as its scale says") {
    for (const float scale : {0.5f, 1.0f, 3.0f}) {
        World world;
        const Ragdoll ragdoll = create_ragdoll(world, {.position_m = {0, 0}, .scale = scale}).value();
        const Position head = world.body(ragdoll.bone(Bone::Head))->world_center();
        const auto top = world.cast_ray({head.x, 10}, {0, -10}).value();
        REQUIRE(top);
        CHECK(top->point_m.y == Approx(1.6 * static_cast<double>(scale)).epsilon(0.01));
    }
}

TEST_CASE("an elevator carries its full load at its speed") {
    World world;
    const Elevator elevator = create_elevator(world, {.load_kg = 400}).value();
    const BodyId load = add(world, {.position_m = {0, 0.5}}, Box{}, {.density_kg_m2 = 400});
    run_for(world, 1);
    send_elevator(world, elevator, 2).value();
    run_for(world, 2);
    CHECK(static_cast<double>(world.body(load)->linear_velocity().y) == Approx(1.5).epsilon(0.01));
    run_for(world, 3);
    CHECK(is_elevator_at(world, elevator, 2).value());
}

}  // namespace
}  // namespace cairn::physics
