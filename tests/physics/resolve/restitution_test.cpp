// Bounces against the law of restitution.
#include <catch2/catch.hpp>
#include <cmath>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

// The height of the top of the next bounce: the energy of free flight tells it between steps too.
double next_bounce_height(World& world, BodyId ball, double rest_height) {
    const auto speed = [&] { return static_cast<double>(world.body(ball)->linear_velocity().y); };
    for (int i = 0; i < 1000 && speed() <= 0; ++i) world.step(kStep_s).value();
    for (int i = 0; i < 1000 && speed() > 0; ++i) world.step(kStep_s).value();
    return world.body(ball)->position().y + speed() * speed() / 20 - rest_height;
}

}  // namespace

TEST_CASE("a ball dropped from h rises to e^2 h") {
    for (const double e : {0.2, 0.3, 0.5, 0.8, 1.0}) {
        for (const double h : {2.0, 3.3, 5.0, 7.1, 10.0}) {
            World world;
            add_ground(world, {.material = {.restitution = static_cast<float>(e)}});
            const BodyId ball = add(world, {.position_m = {0, 0.5 + h}}, Circle{});
            INFO("e = " << e << ", h = " << h);
            CHECK(next_bounce_height(world, ball, 0.5) == Approx(e * e * h).epsilon(1e-4));
        }
    }
}

TEST_CASE("the n-th bounce rises to e^(2 n) h") {
    const double e = 0.8;
    World world;
    add_ground(world, {.material = {.restitution = 0.8f}});
    const BodyId ball = add(world, {.position_m = {0, 5.5}}, Circle{});
    for (int n = 1; n <= 5; ++n) {
        INFO("bounce " << n);
        CHECK(next_bounce_height(world, ball, 0.5) == Approx(5 * std::pow(e, 2 * n)).epsilon(2e-3));
    }
}

TEST_CASE("a perfectly elastic ball neither gains nor loses height in ten bounces") {
    World world;
    add_ground(world, {.material = {.restitution = 1}});
    const BodyId ball = add(world, {.position_m = {0, 4.5}}, Circle{});
    for (int n = 1; n <= 10; ++n) CHECK(next_bounce_height(world, ball, 0.5) == Approx(4).epsilon(2e-3));
}

TEST_CASE("a perfectly elastic ball keeps its energy and its rhythm over hundreds of bounces") {
    const double radius = 0.1, height = 0.25, g = 10;
    World world({.enable_sleep = false});
    add_ground(world, {.material = {.restitution = 1}});
    const BodyId ball = add(world, {.position_m = {0, height + radius}}, Circle{{}, 0.1f});
    const double period_s = 2 * std::sqrt(2 * height / g);
    const int steps = 60 * 200;
    int bounces = 0;
    double before = 0;
    for (int i = 0; i < steps; ++i) {
        world.step(kStep_s).value();
        const auto speed = static_cast<double>(world.body(ball)->linear_velocity().y);
        const double energy = g * (world.body(ball)->position().y - radius) + 0.5 * speed * speed;
        // Where a step passes the ground, the ball is inside until the next one turns it: not counted.
        if (world.body(ball)->position().y > radius) CHECK(energy == Approx(g * height).epsilon(1e-3));
        if (before < 0 && speed > 0) ++bounces;
        before = speed;
    }
    CHECK(bounces == Approx(steps / 60.0 / period_s).margin(2));
}

TEST_CASE("two elastic balls that meet in free flight end the step where they would be") {
    World world({.gravity_m_s2 = {0, 0}, .enable_sleep = false});
    const ShapeDef elastic{.material = {.friction = 0, .restitution = 1}};
    const BodyId left = add(world, {.position_m = {-1, 0}, .linear_velocity_m_s = {3, 0}}, Circle{}, elastic);
    const BodyId right =
        add(world, {.position_m = {1, 0}, .linear_velocity_m_s = {-3, 0}}, Circle{}, elastic);
    // Apart by 1 m, they meet after 1/6 s, and half a second later each is 1.5 m further out.
    run_for(world, 1.0 / 6 + 0.5);
    CHECK(world.body(left)->position().x == Approx(-0.5 - 1.5).margin(1e-4));
    CHECK(world.body(right)->position().x == Approx(0.5 + 1.5).margin(1e-4));
}

TEST_CASE("a flat box bounces as a ball does, and does not turn") {
    World world;
    add_ground(world, {.material = {.restitution = 0.5f}});
    const BodyId box = add(world, {.position_m = {0, 4.5}}, Box{0.5f, 0.5f});
    CHECK(next_bounce_height(world, box, 0.5) == Approx(1).epsilon(1e-3));
    CHECK(world.body(box)->angle() == Approx(0).margin(1e-4));
}

TEST_CASE("without restitution nothing bounces") {
    World world;
    add_ground(world);
    const BodyId ball = add(world, {.position_m = {0, 5.5}}, Circle{});
    double highest_speed = 0;
    bool landed = false;
    for (int i = 0; i < 120; ++i) {
        world.step(kStep_s).value();
        landed = landed || world.counts().touching > 0;
        const auto speed = static_cast<double>(world.body(ball)->linear_velocity().y);
        if (landed) highest_speed = std::max(highest_speed, speed);
    }
    REQUIRE(landed);
    // The speed at which the overlap of the impact is undone is taken out again after each substep.
    CHECK(highest_speed < 0.02);
    CHECK(world.body(ball)->position().y == Approx(0.5).margin(0.005));
}

TEST_CASE("slower than the restitution speed nothing bounces") {
    World world({.restitution_speed_m_s = 3});
    add_ground(world, {.material = {.restitution = 1}});
    const BodyId slow = add(world, {.position_m = {0, 0.9}}, Circle{});   // arrives with 2.8 m/s
    const BodyId fast = add(world, {.position_m = {5, 1.05}}, Circle{});  // arrives with 3.3 m/s
    CHECK(next_bounce_height(world, fast, 0.5) == Approx(0.55).epsilon(1e-2));
    run_for(world, 1);
    CHECK(world.body(slow)->position().y == Approx(0.5).margin(0.005));
    CHECK_FALSE(world.body(slow)->is_awake());
}

TEST_CASE("of two materials the bouncier one counts") {
    World world;
    add_ground(world, {.material = {.restitution = 0.2f}});
    const BodyId ball = add(world, {.position_m = {0, 4.5}}, Circle{}, {.material = {.restitution = 0.7f}});
    CHECK(next_bounce_height(world, ball, 0.5) == Approx(0.49 * 4).epsilon(1e-3));
}

}  // namespace cairn::physics
