// Bodies in free flight against the formulas of mechanics.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "physics/support/making.h"
#include "physics/support/precise.h"

namespace cairn::physics {
namespace {

using namespace test;

}  // namespace

TEST_CASE("a falling body is where y0 + v t - g t^2 / 2 puts it, at every step") {
    World world;
    const BodyId ball = add(world, {.position_m = {0, 100}, .linear_velocity_m_s = {0, 4}}, Circle{});
    for (int step = 1; step <= 60; ++step) {
        world.step(kStep_s).value();
        const double t = step * d(kStep_s);
        // v is rounded at each step, by at most 2^-24 * 8 = 5e-7 of up to 8 m/s; over a second that shifts
        // the place by at most 60 * 5e-7 / 2 = 1.5e-5 m.
        CHECK(world.body(ball)->position().y == Approx(100 + 4 * t - 5 * t * t).margin(1.5e-5).epsilon(0));
        CHECK(d(world.body(ball)->linear_velocity().y) == Approx(4 - 10 * t).margin(3e-5).epsilon(0));
    }
}

TEST_CASE("where all numbers fit into float, a fall is exact") {
    World world;
    const BodyId ball = add(world, {.position_m = {0, 100}}, Circle{});
    step_times(world, 64, 1.0f / 64);
    CHECK(world.body(ball)->position() == Position{0, 95});
    CHECK(world.body(ball)->linear_velocity() == Vec2{0, -10});
}

TEST_CASE("the length of the step does not change where a fall ends") {
    for (const float dt : {1.0f, 0.5f, 0.125f, 1.0f / 256}) {
        World world;
        const BodyId ball = add(world, {.position_m = {0, 100}}, Circle{});
        run_for(world, 2, dt);
        CHECK(world.body(ball)->position().y == 80);
    }
}

TEST_CASE("a projectile flies v^2 sin(2 a) / g far") {
    for (const double angle : {0.3, 0.7853981634, 1.2}) {
        World world;
        const double speed = 20;
        const BodyId ball = add(world,
                                {.linear_velocity_m_s = {static_cast<float>(speed * std::cos(angle)),
                                                         static_cast<float>(speed * std::sin(angle))}},
                                Circle{});
        Position before;
        while (world.body(ball)->position().y >= 0) {
            before = world.body(ball)->position();
            world.step(kStep_s).value();
        }
        const Position after = world.body(ball)->position();
        // Between two steps the path is a parabola, not a line: its height differs by g dt^2 / 8 = 3.5e-4 m
        // at most, which the slope of the path turns into range.
        const double range = before.x + (after.x - before.x) * before.y / (before.y - after.y);
        CHECK(range ==
              Approx(speed * speed * std::sin(2 * angle) / 10).margin(3.5e-4 / std::tan(angle) + 1e-4));
    }
}

TEST_CASE("linear damping leaves v0 e^(-c t)") {
    World world({.gravity_m_s2 = {}});
    const BodyId ball = add(world, {.linear_velocity_m_s = {8, -3}, .linear_damping_1_s = 0.7f}, Circle{});
    run_for(world, 2);
    // 120 products, each of two roundings of 2^-24: at most 1.5e-5 relative.
    CHECK(d(world.body(ball)->linear_velocity().x) == Approx(8 * std::exp(-1.4)).epsilon(1.5e-5));
    CHECK(d(world.body(ball)->linear_velocity().y) == Approx(-3 * std::exp(-1.4)).epsilon(1.5e-5));
}

TEST_CASE("angular damping leaves w0 e^(-c t)") {
    World world;
    const BodyId ball = add(world, {.angular_velocity_rad_s = 5, .angular_damping_1_s = 0.5f}, Circle{});
    run_for(world, 2);
    CHECK(d(world.body(ball)->angular_velocity()) == Approx(5 * std::exp(-1.0)).epsilon(1.5e-5));
}

TEST_CASE("a free body turns by w t and keeps its spin") {
    World world({.gravity_m_s2 = {}});
    const BodyId box = add(world, {.angle_rad = 0.25, .angular_velocity_rad_s = 1.3f}, Box{1, 0.2f});
    run_for(world, 1);
    // Each of 60 products of rotations is rounded by about 2^-24 in each of its four terms.
    CHECK(d(world.body(box)->angle()) == Approx(1.55).margin(1.5e-5).epsilon(0));
    CHECK(world.body(box)->angular_velocity() == 1.3f);
}

TEST_CASE("a body whose centre of mass is not its origin turns about its centre of mass") {
    World world({.gravity_m_s2 = {}});
    const BodyId body =
        add(world, {.position_m = {10, 20}, .angular_velocity_rad_s = 2}, Circle{{3, 0}, 0.5f});
    REQUIRE(world.body(body)->world_center() == Position{13, 20});
    // The origin's velocity was 0, so the centre moves.
    CHECK(world.body(body)->linear_velocity() == Vec2{0, 6});
    world.body(body)->set_linear_velocity({}).value();
    run_for(world, 1);
    CHECK(world.body(body)->world_center() == Position{13, 20});
    const Position origin = world.body(body)->position();
    CHECK(origin.x == Approx(13 - 3 * std::cos(2)).margin(1e-4));
    CHECK(origin.y == Approx(20 - 3 * std::sin(2)).margin(1e-4));
}

TEST_CASE("the gravity scale multiplies gravity, and 0 takes it away") {
    World world;
    const BodyId floating = add(world, {.position_m = {0, 0}, .gravity_scale = 0}, Circle{});
    const BodyId rising = add(world, {.position_m = {5, 0}, .gravity_scale = -0.5f}, Circle{});
    step_times(world, 64, 1.0f / 64);
    CHECK(world.body(floating)->position() == Position{0, 0});
    CHECK(world.body(rising)->position() == Position{5, 2.5});
}

TEST_CASE("a force accelerates by F / m for one step, an impulse at once by P / m") {
    World world({.gravity_m_s2 = {}});
    const BodyId box = add(world, {}, Box{0.5f, 0.5f}, {.density_kg_m2 = 4});
    world.body(box)->apply_force_to_center({8, 0}).value();
    world.step(0.5f).value();
    CHECK(world.body(box)->linear_velocity() == Vec2{1, 0});
    world.step(0.5f).value();
    CHECK(world.body(box)->linear_velocity() == Vec2{1, 0});
    world.body(box)->apply_impulse_to_center({0, 2}).value();
    CHECK(world.body(box)->linear_velocity() == Vec2{1, 0.5f});
}

TEST_CASE("a spring that the host computes swings on for ever") {
    World world({.gravity_m_s2 = {}, .enable_sleep = false});
    const BodyId box = add(world, {.position_m = {1, 0}}, Box{0.5f, 0.5f});
    const float mass_kg = world.body(box)->mass();
    const float w = 2 * kPi;  // rad/s
    double farthest = 0;
    for (int i = 0; i < 60 * 1000; ++i) {
        const auto x = static_cast<float>(world.body(box)->position().x);
        world.body(box)->apply_force_to_center({-mass_kg * w * w * x, 0}).value();
        world.step(kStep_s).value();
        farthest = std::max(farthest, std::fabs(world.body(box)->position().x));
    }
    // Kick and drift keep x^2 + (v/w)^2 - dt x v: the amplitude stays within dt w / 2 of what it was.
    const double band = d(kStep_s * w) / 2;
    CHECK(farthest == Approx(1).margin(band));
}

TEST_CASE("torques, angular impulses and forces off the centre turn by the inertia") {
    World world({.gravity_m_s2 = {}});
    const BodyId box = add(world, {}, Box{0.5f, 0.5f}, {.density_kg_m2 = 6});  // inertia 1
    REQUIRE(d(world.body(box)->mass_data().inertia_kg_m2) == Approx(1));
    world.body(box)->apply_torque(2).value();
    world.step(0.5f).value();
    CHECK(d(world.body(box)->angular_velocity()) == Approx(1));
    world.body(box)->apply_angular_impulse(1).value();
    CHECK(d(world.body(box)->angular_velocity()) == Approx(2));
    const Position center = world.body(box)->world_center();
    world.body(box)->apply_impulse({0, 3}, center + Vec2{0.5f, 0}).value();
    CHECK(d(world.body(box)->angular_velocity()) == Approx(3.5));
    CHECK(d(world.body(box)->linear_velocity().y) == Approx(0.5));
    CHECK(d(world.body(box)->velocity_at(center + Vec2{2, 0}).y) == Approx(0.5 + 2 * 3.5));
}

TEST_CASE("a scene 1000 km from the origin moves as at the origin") {
    const auto fall = [](double x) {
        World world;
        add(world, {.type = BodyType::Static, .position_m = {x, -1}}, Box{10, 1});
        const BodyId box = add(world, {.position_m = {x, 2}, .angle_rad = 0.3}, Box{0.5f, 0.5f});
        run_for(world, 1);
        const Transform xf = world.body(box)->transform();
        return Transform{{xf.p.x - x, xf.p.y}, xf.q};
    };
    const Transform near = fall(0);
    const Transform far = fall(1e6);
    // A double holds places at 1e6 m to 1.2e-10 m; the impact in between magnifies that.
    CHECK(far.p.x == Approx(near.p.x).margin(1e-6));
    CHECK(far.p.y == Approx(near.p.y).margin(1e-6));
    CHECK(far.q.s == Approx(near.q.s).margin(1e-6));
}

TEST_CASE("interpolated transforms go from the place before the last step to that after it") {
    World world;
    const BodyId box =
        add(world, {.linear_velocity_m_s = {6, 0}, .angular_velocity_rad_s = 3}, Box{0.5f, 0.5f, {1, 0}});
    run_for(world, 0.5);
    const Transform before = world.body(box)->transform();
    world.step(kStep_s).value();
    const Transform after = world.body(box)->transform();
    const Transform start = world.body(box)->interpolated_transform(0);
    const Transform end = world.body(box)->interpolated_transform(1);
    const Transform half = world.body(box)->interpolated_transform(0.5f);
    CHECK(length(start.p - before.p) < 1e-6f);
    CHECK(start.q.s == Approx(before.q.s).margin(1e-6));
    CHECK(length(end.p - after.p) < 1e-6f);
    CHECK(end.q.s == Approx(after.q.s).margin(1e-6));
    CHECK(half.q.angle_rad() == Approx(0.5 * (before.q.angle_rad() + after.q.angle_rad())).margin(1e-6));
    // The centre goes straight; the origin, a metre beside it, on an arc of 3 / 60 rad.
    const Position center = half.p + rotate(half.q, {1, 0});
    const Vec2 travelled = (after.p + rotate(after.q, {1, 0})) - (before.p + rotate(before.q, {1, 0}));
    CHECK(length((center - (before.p + rotate(before.q, {1, 0}))) - 0.5f * travelled) < 1e-6f);
}

}  // namespace cairn::physics
