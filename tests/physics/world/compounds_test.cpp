// Bodies of many shapes: mass by parallel axes however the shapes came, and no work that grows with the
// square.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/random.h"

namespace cairn::physics {

using namespace test;

TEST_CASE("a compound has the mass of its parts, moved to their common centre by parallel axes") {
    // A dumbbell: two discs on a rod. Closed form, about the middle.
    World world({.gravity_m_s2 = {}});
    const BodyId body = add(world, {.position_m = {3, 2}}, Circle{{-1, 0}, 0.5f}, {.density_kg_m2 = 2});
    world.create_shape(body, Circle{{1, 0}, 0.5f}, {.density_kg_m2 = 2}).value();
    world.create_shape(body, Box{1, 0.05f}, {.density_kg_m2 = 4}).value();
    const double disc = 2 * static_cast<double>(kPi) * 0.25;
    const double rod = 4 * 2 * 0.1;
    const MassData mass = world.body(body)->mass_data();
    CHECK(mass.mass_kg == Approx(2 * disc + rod).epsilon(1e-6));
    CHECK(mass.center_m.x == Approx(0).margin(1e-6));
    CHECK(mass.inertia_kg_m2 == Approx(2 * (disc * 0.25 / 2 + disc) + rod * (4 + 0.01) / 12).epsilon(1e-6));
}

TEST_CASE("shapes without density weigh nothing, and take no part in the centre") {
    World world;
    const BodyId body = add(world, {}, Box{0.5f, 0.5f}, {.density_kg_m2 = 3});
    const MassData before = world.body(body)->mass_data();
    world.create_shape(body, Circle{{5, 5}, 1}, {.density_kg_m2 = 0}).value();
    world.create_shape(body, Segment{{0, 0}, {9, 9}}).value();
    const MassData after = world.body(body)->mass_data();
    CHECK(after.mass_kg == before.mass_kg);
    CHECK(after.inertia_kg_m2 == before.inertia_kg_m2);
    CHECK(after.center_m == before.center_m);
}

TEST_CASE("a body that lost shapes weighs what one made of the rest weighs, whoever asks first") {
    Random random(1);
    for (int round = 0; round < 20; ++round) {
        World world({.gravity_m_s2 = {}});
        const BodyId lost = world.create_body({.position_m = {1, 1}, .angular_velocity_rad_s = 2}).value();
        const BodyId made = world.create_body({.position_m = {1, 1}}).value();
        std::vector<ShapeId> gone;
        for (int i = 0; i < 30; ++i) {
            const Circle disc{random.vector(-3, 3), random.real_f(0.1, 0.5)};
            const ShapeId shape = world.create_shape(lost, disc).value();
            if (random.chance(0.5)) {
                gone.push_back(shape);
            } else {
                world.create_shape(made, disc).value();
            }
        }
        const Vec2 v_before = world.body(lost)->velocity_at({2, 3});
        for (const ShapeId shape : gone) world.destroy_shape(shape).value();
        if (round % 2 == 0) {
            // The material goes on as it went.
            const Vec2 v = world.body(lost)->velocity_at({2, 3});
            CHECK(v.x == Approx(v_before.x).margin(1e-4));
            CHECK(v.y == Approx(v_before.y).margin(1e-4));
            const Position p = world.body(lost)->position();
            CHECK(p.x == Approx(1).margin(1e-6));
            CHECK(p.y == Approx(1).margin(1e-6));
        } else {
            world.step(kStep_s).value();
        }
        const MassData a = world.body(lost)->mass_data();
        const MassData b = world.body(made)->mass_data();
        CHECK(a.mass_kg == Approx(b.mass_kg).epsilon(1e-6));
        CHECK(a.inertia_kg_m2 == Approx(b.inertia_kg_m2).epsilon(1e-6));
        CHECK(a.center_m.x == Approx(b.center_m.x).margin(1e-6));
        CHECK(a.center_m.y == Approx(b.center_m.y).margin(1e-6));
    }
}

TEST_CASE("a body of 1,000 shapes is made, falls, and is taken apart") {
    World world;
    add_ground(world);
    const BodyId body = world.create_body({.position_m = {0, 1}}).value();
    std::vector<ShapeId> shapes;
    for (int i = 0; i < 1'000; ++i) {
        const Vec2 center{0.1f * static_cast<float>(i % 100) - 4.95f, 0.1f * static_cast<float>(i / 100)};
        shapes.push_back(world.create_shape(body, Box{0.05f, 0.05f, center}).value());
    }
    CHECK(world.body(body)->mass() == Approx(10).epsilon(1e-5));
    CHECK(world.body(body)->world_center().y == Approx(1.45).margin(1e-5));
    CHECK(world.body(body)->mass_data().inertia_kg_m2 == Approx(10 * (100 + 1) / 12.0).epsilon(1e-4));
    run_for(world, 2);
    CHECK(world.body(body)->position().y == Approx(0.05).margin(0.005));
    CHECK(world.body(body)->shapes() == shapes);
    for (std::size_t i = 0; i < shapes.size(); i += 2) world.destroy_shape(shapes[i]).value();
    CHECK(world.body(body)->mass() == Approx(5).epsilon(1e-5));
    CHECK(world.body(body)->shapes().size() == 500);
    for (std::size_t i = 1; i < shapes.size(); i += 2) world.destroy_shape(shapes[i]).value();
    CHECK(world.body(body)->mass() == 0);
    CHECK(world.body(body)->shapes().empty());
    CHECK(world.counts().contacts == 0);
    run_for(world, 0.1);
}

TEST_CASE("a slot that is used again starts without the mass of the body before") {
    World world;
    const BodyId first = add(world, {}, Box{1, 1});
    world.destroy_shape(world.body(first)->shapes()[0]).value();
    world.destroy_body(first).value();
    const BodyId second = add(world, {}, Box{0.5f, 0.5f});
    CHECK(world.body(second)->mass() == 1);
    run_for(world, 0.1);
    CHECK(world.body(second)->mass() == 1);
}

}  // namespace cairn::physics
