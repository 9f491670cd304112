// Locked axes: not the least motion along them, and all else as mechanics has it.
#include <catch2/catch.hpp>
#include <cmath>

#include "physics/support/making.h"
#include "physics/support/random.h"
#include "physics/support/scenes.h"

namespace cairn::physics {
namespace {

using namespace test;

}  // namespace

TEST_CASE("a box locked in x does not move in x at all in a heap that falls on it, nor one locked in y") {
    for (const bool along_x : {true, false}) {
        World world;
        add_ground(world);
        const double x = 0.123456789;
        const double y = 0.7;
        const BodyId locked =
            add(world, {.position_m = {x, y}, .locks = {.x = along_x, .y = !along_x}}, Box{0.5f, 0.5f});
        Random random(7);
        for (int i = 0; i < 60; ++i) {
            const BodyId body = world
                                    .create_body({.position_m = {random.real(-2, 2), 2 + 0.3 * i},
                                                  .linear_velocity_m_s = random.vector(-5, 5),
                                                  .angular_velocity_rad_s = random.real_f(-5, 5)})
                                    .value();
            add_random_shape(world, random, body, {.material = {.restitution = 0.3f}});
        }
        for (int i = 0; i < 600; ++i) {
            world.step(kStep_s).value();
            const Body body = *world.body(locked);
            REQUIRE((along_x ? body.position().x == x : body.position().y == y));
            REQUIRE((along_x ? body.linear_velocity().x == 0 : body.linear_velocity().y == 0));
        }
        CHECK(world.body(locked)->angle() != 0);  // it is pushed about all the same
    }
}

TEST_CASE("a body that must not turn keeps its angle, and is hit as a point mass would be") {
    World world({.gravity_m_s2 = {}});
    const BodyId box =
        add(world, {.angle_rad = 0.25, .locks = {.rotation = true}}, Box{0.5f, 2}, {.density_kg_m2 = 2});
    CHECK(world.body(box)->angle() == Approx(0.25));
    const float angle = world.body(box)->angle();
    const Vec2 normal = rotate(Rotation::from_angle(0.25), {-1, 0});
    // Off the centre by 1.5 m, along the normal.
    const Vec2 along = right_perp(normal);
    const BodyId ball =
        add(world,
            {.position_m = Position{} + (3.0f * normal + 1.5f * along), .linear_velocity_m_s = -6 * normal},
            Circle{{}, 0.5f}, {.material = {.friction = 0, .restitution = 1}});
    const float m = world.body(ball)->mass();
    const float M = world.body(box)->mass();
    CHECK(world.body(box)->mass_data().inertia_kg_m2 > 0);
    run_for(world, 2);
    CHECK(world.body(box)->angle() == angle);
    CHECK(world.body(box)->angular_velocity() == 0);
    CHECK(dot(world.body(ball)->linear_velocity(), normal) == Approx(-6 * (m - M) / (m + M)).epsilon(1e-3));
    CHECK(dot(world.body(box)->linear_velocity(), normal) == Approx(-6 * 2 * m / (m + M)).epsilon(1e-3));
}

TEST_CASE("a bead on a wire is hit with the mass that the wire leaves it") {
    // The bead may move in x only. Along the normal n it has the inverse mass nx^2 / M, so the impulse of a
    // full bounce is J = 2 v / (1/m + nx^2 / M); the ball gets -J n / m, the bead J nx / M.
    for (const double angle : {0.3, 0.8, 1.3}) {
        World world({.gravity_m_s2 = {}});
        const BodyId bead = add(world, {.locks = {.y = true}}, Circle{{}, 0.5f},
                                {.density_kg_m2 = 3, .material = {.friction = 0, .restitution = 1}});
        const Vec2 n = rotate(Rotation::from_angle(angle), {1, 0});
        const BodyId ball = add(world, {.position_m = Position{} + (-3.0f * n), .linear_velocity_m_s = 4 * n},
                                Circle{{}, 0.5f}, {.material = {.friction = 0, .restitution = 1}});
        const float m = world.body(ball)->mass();
        const float M = world.body(bead)->mass();
        run_for(world, 1);
        const float impulse = 2 * 4 / (1 / m + n.x * n.x / M);
        INFO("angle " << angle);
        CHECK(world.body(bead)->linear_velocity().x == Approx(impulse * n.x / M).epsilon(2e-3));
        CHECK(world.body(bead)->position().y == 0);
        CHECK(dot(world.body(ball)->linear_velocity(), n) == Approx(4 - impulse / m).epsilon(2e-3));
    }
}

TEST_CASE("a pendulum on a bead swings with g/L (1 + m/M)") {
    World world({.substeps = 16, .enable_sleep = false});
    const BodyId bead = add(world, {.locks = {.y = true}}, Circle{{}, 0.5f}, {.filter = {.mask = 0}});
    const BodyId bob = add(world, {.position_m = {0.05, -2}}, Circle{{}, 0.25f}, {.density_kg_m2 = 6});
    world.create_joint(DistanceJointDef{.body_a = bead, .body_b = bob, .length_m = 2}).value();
    const double m = static_cast<double>(world.body(bob)->mass());
    const double M = static_cast<double>(world.body(bead)->mass());
    const double period = 2 * M_PI / std::sqrt(10.0 / 2 * (1 + m / M));
    // The bob swings about the common centre; its velocity changes its sign twice a period.
    int turns = 0;
    double first = 0;
    double last = 0;
    float before = 0;
    for (int i = 1; i <= 900; ++i) {
        world.step(kStep_s).value();
        REQUIRE(world.body(bead)->position().y == 0);
        const float now = world.body(bob)->linear_velocity().x - world.body(bead)->linear_velocity().x;
        if (before < 0 && now >= 0) {
            last = (i - static_cast<double>(now / (now - before))) / 60;
            if (turns == 0) first = last;
            ++turns;
        }
        before = now;
    }
    REQUIRE(turns > 5);
    CHECK((last - first) / (turns - 1) == Approx(period).epsilon(0.01));
}

TEST_CASE("a pin holds a locked body along the axes that it has") {
    World world({.enable_sleep = false});
    const BodyId hook = world.create_body({.type = BodyType::Static}).value();
    const auto hang = [&](double x, AxisLocks locks) {
        const BodyId body = add(world, {.position_m = {x, 0}, .locks = locks}, Circle{});
        world
            .create_joint(RevoluteJointDef{
                .body_a = hook, .body_b = body, .local_anchor_a_m = {static_cast<float>(x), 0}})
            .value();
        return body;
    };
    const BodyId in_x = hang(2, {.x = true});
    const BodyId stiff = hang(4, {.x = true, .rotation = true});
    const BodyId fixed = hang(6, {.x = true, .y = true, .rotation = true});
    run_for(world, 5);
    CHECK(world.body(in_x)->position().x == 2);
    CHECK(world.body(in_x)->position().y == Approx(0).margin(1e-3));
    CHECK(world.body(stiff)->position().x == 4);
    CHECK(world.body(stiff)->position().y == Approx(0).margin(1e-3));
    CHECK(world.body(fixed)->position() == Position{6, 0});
    CHECK(world.body(fixed)->is_awake());
}

TEST_CASE("a pin between two bodies that can only turn, on arms at a right angle, stops both") {
    World world({.enable_sleep = false});
    const AxisLocks in_place{.x = true, .y = true};
    const BodyId a = add(world, {.angular_velocity_rad_s = 3, .locks = in_place}, Circle{});
    const BodyId b = add(world, {.position_m = {1, 1}, .locks = in_place}, Circle{});
    world
        .create_joint(RevoluteJointDef{
            .body_a = a, .body_b = b, .local_anchor_a_m = {1, 0}, .local_anchor_b_m = {0, -1}})
        .value();
    for (int i = 0; i < 60; ++i) {
        world.step(kStep_s).value();
        REQUIRE(world.body(a)->position() == Position{});
        REQUIRE(world.body(b)->position() == Position{1, 1});
    }
    CHECK(world.body(a)->angular_velocity() == Approx(0).margin(1e-3));
    CHECK(world.body(b)->angular_velocity() == Approx(0).margin(1e-3));
    CHECK(world.body(a)->angle() == Approx(0).margin(1e-3));
}

TEST_CASE("a shelf locked in y bears what is put on it, without gravity of its own") {
    World world;
    const BodyId shelf =
        add(world, {.position_m = {0, 3}, .locks = {.y = true, .rotation = true}}, Box{2, 0.1f});
    for (int i = 0; i < 5; ++i) add(world, {.position_m = {0, 3.6 + i}}, Box{0.5f, 0.5f});
    run_for(world, 5);
    CHECK(world.body(shelf)->position().y == 3);
    CHECK(world.body(shelf)->position().x == Approx(0).margin(0.001));
    CHECK(world.body(world.bodies().back())->position().y == Approx(7.6).margin(0.01));
    CHECK(world.counts().awake_bodies == 0);
}

TEST_CASE("locks stop what is under way, take no velocity, and give way when they are taken off") {
    World world;
    const BodyId body = add(
        world, {.linear_velocity_m_s = {3, 4}, .angular_velocity_rad_s = 5, .locks = {.x = true}}, Circle{});
    CHECK(world.body(body)->linear_velocity() == Vec2{0, 4});
    world.body(body)->set_locks({.x = true, .y = true, .rotation = true});
    CHECK(world.body(body)->locks() == AxisLocks{true, true, true});
    CHECK(world.body(body)->linear_velocity() == Vec2{});
    CHECK(world.body(body)->angular_velocity() == 0);
    world.body(body)->set_linear_velocity({1, 1}).value();
    world.body(body)->set_angular_velocity(1).value();
    world.body(body)->apply_impulse({5, 5}, {1, 0}).value();
    world.body(body)->apply_angular_impulse(5).value();
    world.body(body)->apply_force({500, 500}, {1, 0}).value();
    world.body(body)->apply_torque(500).value();
    run_for(world, 2);
    CHECK(world.body(body)->position() == Position{});
    CHECK(world.body(body)->angle() == 0);
    CHECK_FALSE(world.body(body)->is_awake());
    world.body(body)->set_locks({});
    CHECK(world.body(body)->is_awake());
    run_for(world, 1);
    CHECK(world.body(body)->position().y == Approx(-5).epsilon(0.01));
    world.body(body)->apply_angular_impulse(1).value();
    CHECK(world.body(body)->angular_velocity() != 0);
}

TEST_CASE("locks are for dynamic bodies: a kinematic one goes its way") {
    World world;
    const BodyId body = add(world,
                            {.type = BodyType::Kinematic,
                             .linear_velocity_m_s = {1, 2},
                             .angular_velocity_rad_s = 0.5f,
                             .locks = {true, true, true}},
                            Circle{});
    run_for(world, 1);
    CHECK(world.body(body)->position().x == Approx(1));
    CHECK(world.body(body)->position().y == Approx(2));
    CHECK(world.body(body)->angle() == Approx(0.5));
}

}  // namespace cairn::physics
