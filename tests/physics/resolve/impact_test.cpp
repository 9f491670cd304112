// Impacts between free bodies against the conservation laws.
#include <catch2/catch.hpp>
#include <cmath>

#include "physics/support/making.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using namespace test;

struct Momentum {
    double x = 0;
    double y = 0;
    double angular = 0;  // about the world's origin
    double energy = 0;
};

Momentum momentum_of(World& world) {
    Momentum sum;
    for (const BodyId id : world.bodies()) {
        const Body body = *world.body(id);
        const auto m = static_cast<double>(body.mass());
        const auto vx = static_cast<double>(body.linear_velocity().x);
        const auto vy = static_cast<double>(body.linear_velocity().y);
        const Position c = body.world_center();
        sum.x += m * vx;
        sum.y += m * vy;
        sum.angular += m * (c.x * vy - c.y * vx) + static_cast<double>(body.mass_data().inertia_kg_m2) *
                                                       static_cast<double>(body.angular_velocity());
        sum.energy += kinetic_energy(body);
    }
    return sum;
}

}  // namespace

TEST_CASE("in a head-on elastic impact two discs exchange speeds by the formula") {
    for (const float density : {1.0f, 0.25f, 7.0f}) {
        World world({.gravity_m_s2 = {}});
        const ShapeDef elastic{.material = {.restitution = 1}};
        ShapeDef other = elastic;
        other.density_kg_m2 = density;
        const BodyId a =
            add(world, {.position_m = {-3, 0}, .linear_velocity_m_s = {4, 0}}, Circle{}, elastic);
        const BodyId b = add(world, {.position_m = {3, 0}, .linear_velocity_m_s = {-2, 0}}, Circle{}, other);
        const Momentum before = momentum_of(world);
        run_for(world, 2);
        const Momentum after = momentum_of(world);
        const double m1 = 1;
        const auto m2 = static_cast<double>(density);
        INFO("density " << density);
        // A handful of float operations on speeds of up to 10 m/s.
        CHECK(world.body(a)->linear_velocity().x ==
              Approx(((m1 - m2) * 4 + 2 * m2 * -2) / (m1 + m2)).margin(1e-5));
        CHECK(world.body(b)->linear_velocity().x ==
              Approx(((m2 - m1) * -2 + 2 * m1 * 4) / (m1 + m2)).margin(1e-5));
        CHECK(after.x == Approx(before.x).margin(1e-5));
        CHECK(after.energy == Approx(before.energy).epsilon(1e-5));
    }
}

TEST_CASE("an off-centre hit keeps linear and angular momentum, and with e = 1 the energy") {
    World world({.gravity_m_s2 = {}});
    const ShapeDef smooth{.material = {.friction = 0, .restitution = 1}};
    add(world, {.position_m = {-3, 0.4}, .linear_velocity_m_s = {5, 0}}, Circle{{}, 0.25f}, smooth);
    const BodyId bar = add(world, {.position_m = {0, 0}}, Box{0.25f, 1}, smooth);
    const Momentum before = momentum_of(world);
    run_for(world, 1);
    const Momentum after = momentum_of(world);
    REQUIRE(world.body(bar)->angular_velocity() < -0.1f);
    CHECK(after.x == Approx(before.x).epsilon(1e-5));
    CHECK(after.y == Approx(before.y).margin(1e-5));
    // The lever arms are those of the start of the step, a motion of at most 5 / 60 m along the impulse ago.
    CHECK(after.angular == Approx(before.angular).epsilon(1e-4));
    CHECK(after.energy == Approx(before.energy).epsilon(1e-4));
}

TEST_CASE("what whirls hits with all its momentum, wherever and whenever its tip comes round") {
    for (const float spin : {100.0f, 300.0f, 1000.0f, -1000.0f}) {
        for (const double aside : {-0.6, -0.3, 0.1, 0.45}) {
            INFO("spin " << spin << ", aside by " << aside);
            World world({.gravity_m_s2 = {}, .enable_sleep = false});
            add(world, {.angular_velocity_rad_s = spin}, Box{0.5f, 0.05f});
            const BodyId other =
                add(world, {.position_m = {aside, 1.5}, .linear_velocity_m_s = {0, -2}}, Box{0.5f, 0.05f});
            const Momentum before = momentum_of(world);
            run_for(world, 2);
            const Momentum after = momentum_of(world);
            CHECK(length(world.body(other)->linear_velocity()) > 2.01f);  // it was hit
            CHECK(after.x == Approx(before.x).margin(1e-5));
            CHECK(after.y == Approx(before.y).margin(1e-5));
            CHECK(after.angular == Approx(before.angular).epsilon(1e-3));
            CHECK(after.energy <= before.energy * 1.001);
        }
    }
}

TEST_CASE("a hit of what whirls keeps the energy with e = 1") {
    World world({.gravity_m_s2 = {}, .enable_sleep = false});
    const ShapeDef elastic{.material = {.friction = 0, .restitution = 1}};
    add(world, {.angular_velocity_rad_s = 500}, Box{0.5f, 0.05f}, elastic);
    const BodyId disc =
        add(world, {.position_m = {0.2, 1.5}, .linear_velocity_m_s = {0, -3}}, Circle{{}, 0.1f}, elastic);
    const Momentum before = momentum_of(world);
    run_for(world, 2);
    const Momentum after = momentum_of(world);
    CHECK(length(world.body(disc)->linear_velocity()) > 10);
    CHECK(after.energy == Approx(before.energy).epsilon(1e-3));
    CHECK(after.angular == Approx(before.angular).epsilon(1e-3));
}

TEST_CASE("whatever free bodies do to each other, their momentum stays and their energy does not grow") {
    World world({.gravity_m_s2 = {}});
    Random random(1);
    for (int i = 0; i < 40; ++i) {
        const BodyDef def{.position_m = {random.real(-5, 5), random.real(-5, 5)},
                          .angle_rad = random.real(-3, 3),
                          .linear_velocity_m_s = random.vector(-4, 4),
                          .angular_velocity_rad_s = random.real_f(-3, 3)};
        const ShapeDef shape{.density_kg_m2 = random.real_f(0.2, 3),
                             .material = {.friction = random.real_f(0, 1)}};
        if (random.chance(0.5)) {
            add(world, def, Circle{{}, random.real_f(0.1, 0.4)}, shape);
        } else {
            add(world, def, Box{random.real_f(0.1, 0.4), random.real_f(0.1, 0.4)}, shape);
        }
    }
    step_times(world, 30);  // what overlapped at the start has parted
    const Momentum before = momentum_of(world);
    double energy = before.energy;
    for (int i = 0; i < 300; ++i) {
        world.step(kStep_s).value();
        const Momentum now = momentum_of(world);
        // A relaxing pass takes out what pushing apart put in, up to what one sweep over the contacts leaves.
        REQUIRE(now.energy <= energy * 1.001);
        energy = now.energy;
    }
    const Momentum after = momentum_of(world);
    // 40 bodies with momenta of up to 10 N s, each changed a few hundred times by opposite impulses that are
    // rounded to 2^-24 of the velocity.
    CHECK(after.x == Approx(before.x).margin(2e-3));
    CHECK(after.y == Approx(before.y).margin(2e-3));
}

TEST_CASE("a light and a heavy body push each other with opposite impulses") {
    World world({.gravity_m_s2 = {}, .enable_sleep = false});
    const BodyId light =
        add(world, {.position_m = {-2, 0}, .linear_velocity_m_s = {6, 0}}, Circle{{}, 0.25f});
    const BodyId heavy = add(world, {.position_m = {0, 0}}, Circle{{}, 0.5f}, {.density_kg_m2 = 1000});
    const auto light_mass = static_cast<double>(world.body(light)->mass());
    const auto heavy_mass = static_cast<double>(world.body(heavy)->mass());
    run_for(world, 1);
    const double lost = light_mass * (6 - static_cast<double>(world.body(light)->linear_velocity().x));
    const double gained = heavy_mass * static_cast<double>(world.body(heavy)->linear_velocity().x);
    CHECK(gained == Approx(lost).epsilon(1e-4));
}

}  // namespace cairn::physics
