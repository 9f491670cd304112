// Changing the density of a shape, against bodies that were made with it.
#include <array>
#include <catch2/catch.hpp>

#include "physics/support/scenes.h"

namespace cairn::physics {

using namespace test;

TEST_CASE("a body whose densities are changed weighs and turns as one made with them") {
    World world({.gravity_m_s2 = {}});
    const auto make = [&](float box_density, float disc_density) {
        const BodyId body = add(world, {.position_m = {0, 0}}, Box{1, 0.5f}, {.density_kg_m2 = box_density});
        world.create_shape(body, Circle{{2, 0.5f}, 0.5f}, {.density_kg_m2 = disc_density}).value();
        return body;
    };
    const BodyId changed = make(1, 1);
    const BodyId made = make(3, 0.25f);
    const std::vector<ShapeId> shapes = world.body(changed)->shapes();
    world.shape(shapes[0])->set_density(3).value();
    world.shape(shapes[1])->set_density(0.25f).value();
    const MassData mass = world.body(changed)->mass_data();
    const MassData expected = world.body(made)->mass_data();
    CHECK(mass.mass_kg == expected.mass_kg);
    CHECK(mass.inertia_kg_m2 == expected.inertia_kg_m2);
    CHECK(mass.center_m == expected.center_m);
    CHECK(mass.mass_kg == Approx(3 * 2 + 0.25f * kPi / 4));
}

TEST_CASE("a sleeping stack wakes, and its ground bears the new weight") {
    World world;
    add_ground(world);
    const BodyId lower = add(world, {.position_m = {0, 0.5}}, Box{0.5f, 0.5f});
    const BodyId upper = add(world, {.position_m = {0, 1.5}}, Box{0.5f, 0.5f});
    run_for(world, 3);
    REQUIRE_FALSE(world.body(lower)->is_awake());
    world.shape(world.body(upper)->shapes()[0])->set_density(4).value();
    CHECK(world.body(lower)->is_awake());
    step_times(world, 20);
    const auto on_ground = world.debug_contacts();
    float impulse_ns = 0;
    for (const DebugContact& contact : on_ground) {
        if (contact.body_b != lower || contact.body_a == upper) continue;
        for (int i = 0; i < contact.count; ++i) impulse_ns += contact.points[i].impulse_ns;
    }
    CHECK(impulse_ns == Approx((1 + 4) * 10 * kStep_s).epsilon(1e-2));
}

TEST_CASE("densities that make no sense, and chains, are refused and change nothing") {
    World world;
    const BodyId body = add(world, {}, Box{0.5f, 0.5f});
    const ShapeId shape = world.body(body)->shapes()[0];
    for (const float bad : {-1.0f, std::numeric_limits<float>::quiet_NaN(), kUnlimited}) {
        const auto refused = world.shape(shape)->set_density(bad);
        REQUIRE_FALSE(refused);
        CHECK(refused.error().message.find("shape.density_kg_m2") != std::string::npos);
    }
    CHECK(world.body(body)->mass() == 1);
    const BodyId ground = world.create_body({.type = BodyType::Static}).value();
    const std::array<Vec2, 2> points{Vec2{5, 0}, Vec2{-5, 0}};
    const ChainId chain = world.create_chain(ground, {.points_m = points}).value();
    CHECK_FALSE(world.shape(world.chain(chain)->segment(0).value())->set_density(1));
}

}  // namespace cairn::physics
