// Bodies that were put into each other come apart without being thrown.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr WorldDef kWeightless{.gravity_m_s2 = {}, .enable_sleep = false};

// Squares of 1 m in rows, each half inside of its neighbours.
void pile_up(World& world, int rows) {
    for (int i = 0; i < rows * rows; ++i)
        add(world, {.position_m = {0.5 * (i % rows), 0.5 * (i / rows)}}, Box{0.5f, 0.5f});
}

Position middle_of(World& world) {
    double x = 0, y = 0, mass = 0;
    for (const BodyId id : world.bodies()) {
        const auto m = static_cast<double>(world.body(id)->mass());
        x += m * world.body(id)->world_center().x;
        y += m * world.body(id)->world_center().y;
        mass += m;
    }
    return {x / mass, y / mass};
}

}  // namespace

TEST_CASE("a pile put into itself comes apart no faster than the cap, and not for ever") {
    for (const int rows : {2, 3, 5, 7}) {
        INFO(rows << " rows");
        World world(kWeightless);
        pile_up(world, rows);
        float fastest = 0;
        for (int i = 0; i < 600; ++i) {
            world.step(kStep_s).value();
            for (const BodyId id : world.bodies())
                fastest = std::max(fastest, length(world.body(id)->linear_velocity()));
        }
        CHECK(fastest < WorldDef{}.max_push_out_speed_m_s);
        CHECK(world.report().max_penetration_m < 1e-3f);
    }
}

TEST_CASE("what comes apart keeps its middle and its momentum") {
    World world(kWeightless);
    pile_up(world, 5);
    const Position before = middle_of(world);
    run_for(world, 2);
    const WorldReport report = world.report();
    // 25 bodies of 1 kg, pushed in a few dozen steps by opposite amounts, each rounded to 2^-24 of a metre or
    // so.
    CHECK(middle_of(world).x == Approx(before.x).margin(1e-5));
    CHECK(middle_of(world).y == Approx(before.y).margin(1e-5));
    CHECK(report.momentum_x_kg_m_s == Approx(0).margin(1e-4));
    CHECK(report.momentum_y_kg_m_s == Approx(0).margin(1e-4));
}

TEST_CASE("while an overlap is deep it gets less by the cap in each step, without speed") {
    World world(kWeightless);
    const BodyId left = add(world, {}, Box{0.5f, 2});
    const BodyId right = add(world, {.position_m = {0.4, 0}}, Box{0.5f, 0.5f});
    const auto apart = [&] { return world.body(right)->position().x - world.body(left)->position().x; };
    const double cap_m = static_cast<double>(WorldDef{}.max_push_out_speed_m_s * kStep_s);
    // 0.6 m deep: eleven steps of 5 cm until it is not deep any more.
    for (int i = 1; i <= 10; ++i) {
        world.step(kStep_s).value();
        CHECK(apart() == Approx(0.4 + i * cap_m).margin(1e-5));
        CHECK(world.body(right)->linear_velocity() == Vec2{});
    }
}

TEST_CASE("a wheel deep in the ground is pushed out, and rolls on") {
    World world;
    add_ground(world);
    const BodyId wheel =
        add(world, {.position_m = {0, 0.1}, .linear_velocity_m_s = {2, 0}}, Circle{{}, 0.5f});
    double highest = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(kStep_s).value();
        highest = std::max(highest, world.body(wheel)->position().y);
    }
    CHECK(highest < 0.51);
    CHECK(world.body(wheel)->position().y == Approx(0.5).margin(1e-3));
    CHECK(world.body(wheel)->linear_velocity().x > 1);
}

// 600 bodies of two triangles each hit each other so hard that they are squeezed into each other. Moving them
// apart pair by pair, without a velocity that reaches the others, would keep half a metre of that.
TEST_CASE("what was pressed into each other is pressed apart by velocities") {
    World world;
    add_ground(world);
    for (const double x : {-11.0, 11.0})
        add(world, {.type = BodyType::Static, .position_m = {x, 300}}, Box{0.5f, 300});
    for (int row = 0; row < 60; ++row) {
        for (int column = 0; column < 10; ++column) {
            const Position at{2.0 * column - 9 + 0.1 * (row % 2), 1 + 2.25 * row};
            const BodyId id = world.create_body({.position_m = at, .linear_velocity_m_s = {0, -40}}).value();
            for (const float side : {-1.0f, 1.0f}) {
                const std::array<Vec2, 3> half{Vec2{side, 0}, {-0.5f * side, 1}, {0, 2}};
                world.create_shape(id, Polygon{half}).value();
            }
        }
    }
    run_for(world, 3);
    CHECK(world.report().max_penetration_m < 0.25f);
}

// The contact of what was put in is gone in the step after, with the body; its neighbour's other contact
// became deep by other means. A restored world has never known the first.
TEST_CASE("what was put into a body and destroyed leaves no trace on the body's other contacts") {
    World world(kWeightless);
    const BodyId body = add(world, {}, Box{0.5f, 0.5f});
    const BodyId beside = add(world, {.position_m = {1.001, 0}}, Box{0.5f, 0.5f});
    world.step(kStep_s).value();
    const BodyId put_in = add(world, {.position_m = {0, 0.7}}, Box{0.5f, 0.5f});
    world.step(kStep_s).value();
    world.destroy_body(put_in).value();
    const Position at = world.body(body)->position();
    world.body(beside)->set_transform({at.x + 0.8, at.y}, 0).value();
    World restored(kWeightless);
    restored.restore(world.snapshot().value().bytes()).value();
    REQUIRE(restored.state_hash() == world.state_hash());
    world.step(kStep_s).value();
    restored.step(kStep_s).value();
    CHECK(restored.state_hash() == world.state_hash());
}

}  // namespace cairn::physics
