// Chains of links, and what all prefabs promise about errors and destruction.
#include <catch2/catch.hpp>

#include <cairn/physics/prefabs/all.h>

#include "physics/support/resting.h"

namespace cairn::physics {
namespace {

using namespace test;

TEST_CASE("a hanging chain is as long as its links, and sleeps") {
    World world;
    const LinkChain chain = create_link_chain(world, {.start_m = {0, 10}, .links = 20}).value();
    REQUIRE(chain.links.size() == 20);
    REQUIRE(chain.joints.size() == 20);
    CHECK(sleeps_within(world, 10));
    const Joint last = world.joint(chain.joints.back()).value();
    CHECK(last.anchor_b().y == Approx(0.5).margin(0.005 * 10));
    // The first pin bears the weight of all links.
    double weight = 0;
    for (const BodyId link : chain.links) weight += 10.0 * static_cast<double>(world.body(link)->mass());
    CHECK(static_cast<double>(world.joint(chain.joints.front())->reaction_force().y) ==
          Approx(weight).epsilon(0.02));
}

TEST_CASE("a chain holds two bodies together") {
    World world;
    const BodyId crate = add(world, {.position_m = {0, 4}}, Box{});
    const LinkChain chain =
        create_link_chain(world, {.start_m = {0, 10}, .links = 11, .end = {.held = true, .body = crate}})
            .value();
    CHECK(chain.joints.size() == 12);
    run_for(world, 5);
    CHECK(world.body(crate)->position().y == Approx(4).margin(0.06));
}

template <class Result>
void check_refused(const World& world, const Result& result, const std::string& message) {
    REQUIRE(!result);
    CHECK(result.error().message == message);
    CHECK(listed(world.counts()) == listed(World().counts()));
}

TEST_CASE("a bad definition of a prefab names the field, the value and the rule, and makes nothing") {
    World world;
    check_refused(world, create_link_chain(world, {.links = 0}),
                  "link_chain.links is 0, but must be from 1 to 10000");
    check_refused(world, create_rope(world, {.length_m = 2}),
                  "rope.length_m is 2, but must be from the distance of the ends to 100 times that");
    check_refused(world, create_bridge(world, {.slack = -1}), "bridge.slack is -1, but must be from 0 to 1");
    check_refused(world, create_vehicle(world, {.length_m = -1}),
                  "vehicle.length_m is -1, but must be finite and greater than 0");
    check_refused(world, create_ragdoll(world, {.scale = 0}),
                  "ragdoll.scale is 0, but must be finite and greater than 0");
    check_refused(world, create_brick_wall(world, {.mortar_n_m = 0}),
                  "brick_wall.mortar_n_m is 0, but must be finite and greater than 0");
    check_refused(world, create_blob(world, {.rings = 99}), "blob.rings is 99, but must be from 1 to 50");
    check_refused(world, create_pendulum(world, {.rod_m = kUnlimited}),
                  "pendulum.rod_m is inf, but must be finite and greater than 0");
    check_refused(world, create_windmill(world, {.sails = 1}),
                  "windmill.sails is 1, but must be from 2 to 24");
    check_refused(world, create_elevator(world, {.floors_m = {0, 3, 2}}),
                  "elevator.floors_m is 2, but must be above the floor before it");
    check_refused(world, create_gear_train(world, {.radii_m = {1, -1}}),
                  "gear_train.radii_m is -1, but must be finite and greater than 0");
    check_refused(world, create_pulley_lift(world, {.distance_m = 1}),
                  "pulley_lift.distance_m is 1, but must be finite and greater than width_m");
    // An error that only the world finds, when some parts are made already.
    check_refused(world, create_vehicle(world, {.tyre = {.density_kg_m2 = -1}}),
                  "shape.density_kg_m2 is -1, but must be finite and at least 0");
}

TEST_CASE("all broken rules of a prefab are told, but for those that are broken because others are") {
    World world;
    check_refused(world, create_vehicle(world, {.length_m = -1, .drive_torque_nm = -2}),
                  "vehicle.length_m is -1, but must be finite and greater than 0; and "
                  "vehicle.drive_torque_nm is -2, but must be finite and at least 0");
    check_refused(world, create_pulley_lift(world, {.distance_m = 1, .travel_m = 9}),
                  "pulley_lift.distance_m is 1, but must be finite and greater than width_m; and "
                  "pulley_lift.rope_m is 5, but must be finite and greater than travel_m");
    check_refused(world, create_pulley_lift(world, {.distance_m = 1, .travel_m = kUnlimited}),
                  "pulley_lift.travel_m is inf, but must be finite and greater than 0");
    check_refused(world, create_gear_train(world, {.direction = {0, 0}, .radii_m = {1, -1, -2}}),
                  "gear_train.direction is 0, but must be finite and greater than 0; and "
                  "gear_train.radii_m is -1, but must be finite and greater than 0");
    // Its length is the distance of its ends, unless it is said.
    check_refused(world, create_rope(world, {.to_m = {0, 0}, .radius_m = -1}),
                  "rope.radius_m is -1, but must be finite and greater than 0");
    check_refused(world, create_rope(world, {.to_m = {0, 0}}),
                  "rope.to_m - rope.from_m is 0, but must be longer than 0.01 m");
    check_refused(world, create_rope(world, {.length_m = 2, .links = 500}),
                  "rope.length_m is 2, but must be from the distance of the ends to 100 times that; and "
                  "rope.length_m is 2, but must be more than 0.01 m for each link");
    check_refused(world, create_link_chain(world, {.direction = {kUnlimited, 0}}),
                  "link_chain.direction is (inf, 0), but must be finite");
}

TEST_CASE("destroying a prefab leaves nothing of it, whatever was taken away before") {
    World world;
    const Counts before = world.counts();
    const Bridge bridge = create_bridge(world, {}).value();
    const Vehicle vehicle = create_vehicle(world, {.position_m = {3, 2}}).value();
    run_for(world, 0.5);
    world.destroy_body(bridge.planks[4]).value();
    destroy_prefab(world, bridge);
    destroy_prefab(world, vehicle);
    destroy_prefab(world, vehicle);
    CHECK(listed(world.counts()) == listed(before));
}

}  // namespace
}  // namespace cairn::physics
