// Friction against Coulomb's law.
#include <catch2/catch.hpp>
#include <cmath>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

// A slope through the origin; places on it are told by how far along and above it they are.
struct Slope {
    double angle;

    [[nodiscard]] Position at(double along, double above) const {
        return {along * std::cos(angle) - above * std::sin(angle),
                along * std::sin(angle) + above * std::cos(angle)};
    }
    [[nodiscard]] double along(Position p) const { return p.x * std::cos(angle) + p.y * std::sin(angle); }
    [[nodiscard]] double along(Vec2 v) const {
        return static_cast<double>(v.x) * std::cos(angle) + static_cast<double>(v.y) * std::sin(angle);
    }
    void add_to(World& world, float friction) const {
        add(world, {.type = BodyType::Static, .angle_rad = angle},
            Box{.half_width_m = 100, .half_height_m = 1, .center_m = {0, -1}},
            {.material = {.friction = friction}});
    }
};

}  // namespace

TEST_CASE("a box that slides stops after v^2 / (2 mu g)") {
    for (const float mu : {0.2f, 0.5f, 0.9f}) {
        for (const float speed : {2.0f, 5.0f, 10.0f}) {
            World world;
            add_ground(world, {.material = {.friction = mu}});
            const BodyId box = add(world, {.position_m = {0, 0.1}, .linear_velocity_m_s = {speed, 0}},
                                   Box{0.5f, 0.1f}, {.material = {.friction = mu}});
            run_for(world, 2 + static_cast<double>(speed / mu) / 10);
            // Semi-implicit Euler brakes at the start of each substep h: the box loses v h / 2 of its way.
            const auto v = static_cast<double>(speed);
            const double way = v * v / (2 * static_cast<double>(mu) * 10);
            INFO("mu = " << mu << ", speed = " << speed);
            CHECK(world.body(box)->linear_velocity() == Vec2{0, 0});
            CHECK(world.body(box)->position().x == Approx(way).epsilon(0).margin(v / 240 / 2 + 1e-4));
        }
    }
}

TEST_CASE("two materials rub with the geometric mean of their friction") {
    World world;
    add_ground(world, {.material = {.friction = 0.2f}});
    const BodyId box = add(world, {.position_m = {0, 0.1}, .linear_velocity_m_s = {5, 0}}, Box{0.5f, 0.1f},
                           {.material = {.friction = 0.8f}});
    run_for(world, 4);
    // Euler's substeps give a way that is shorter by half a substep's; the rest is rounding.
    CHECK(world.body(box)->position().x ==
          Approx(25.0 / (2 * 0.4 * 10)).epsilon(0).margin(5.0 / 240 / 2 + 1e-4));
}

TEST_CASE("without friction a box slides on with its speed") {
    World world;
    add_ground(world, {.material = {.friction = 0}});
    const BodyId box = add(world, {.position_m = {0, 0.1}, .linear_velocity_m_s = {5, 0}}, Box{0.5f, 0.1f});
    run_for(world, 4);
    CHECK(world.body(box)->linear_velocity().x == 5);
    CHECK(world.body(box)->position().x == Approx(20).epsilon(1e-5));
}

TEST_CASE("a box does not stir on slopes of up to 0.999 of the friction angle's tangent") {
    for (const double share : {0.5, 0.95, 0.999})
        for (const double mu : {0.2, 0.5, 0.8}) {
            const Slope slope{std::atan(share * mu)};
            World world({.enable_sleep = false});
            slope.add_to(world, static_cast<float>(mu));
            const BodyId box = add(world, {.position_m = slope.at(0, 0.1), .angle_rad = slope.angle},
                                   Box{0.5f, 0.1f}, {.material = {.friction = static_cast<float>(mu)}});
            run_for(world, 10);
            INFO("mu = " << mu << ", share " << share);
            CHECK(slope.along(world.body(box)->position()) == Approx(0).margin(1e-5));
            CHECK(world.body(box)->angle() == Approx(slope.angle).margin(1e-5));
        }
}

TEST_CASE("a box slips on a slope of 1.05 of the friction angle's tangent, with g (sin - mu cos)") {
    for (const double mu : {0.2, 0.5, 0.8}) {
        const Slope slope{std::atan(1.05 * mu)};
        World world({.enable_sleep = false});  // at mu = 0.2 it starts so slowly that it would fall asleep
        slope.add_to(world, static_cast<float>(mu));
        const BodyId box = add(world, {.position_m = slope.at(0, 0.1), .angle_rad = slope.angle},
                               Box{0.5f, 0.1f}, {.material = {.friction = static_cast<float>(mu)}});
        run_for(world, 1);
        const double before = slope.along(world.body(box)->linear_velocity());
        run_for(world, 3);
        const double acceleration = (slope.along(world.body(box)->linear_velocity()) - before) / 3;
        const double expected = -10 * (std::sin(slope.angle) - mu * std::cos(slope.angle));
        INFO("mu = " << mu);
        CHECK(acceleration == Approx(expected).epsilon(1e-2));
    }
}

TEST_CASE("a disc rolls down a slope with 2/3 g sin, and a smooth box slides with g sin") {
    const Slope slope{0.3};
    World world;
    slope.add_to(world, 1);
    const BodyId disc =
        add(world, {.position_m = slope.at(0, 0.5)}, Circle{{}, 0.5f}, {.material = {.friction = 1}});
    const BodyId box = add(world, {.position_m = slope.at(-10, 0.1), .angle_rad = slope.angle},
                           Box{0.5f, 0.1f}, {.material = {.friction = 0}});
    for (int i = 1; i <= 120; ++i) {
        world.step(kStep_s).value();
        const Vec2 v = world.body(disc)->linear_velocity();
        const double t = i / 60.0;
        CHECK(slope.along(v) == Approx(-10 * std::sin(0.3) * t * 2 / 3).epsilon(5e-3));
        CHECK(slope.along(world.body(box)->linear_velocity()) ==
              Approx(-10 * std::sin(0.3) * t).epsilon(1e-3));
        // Rolling, not slipping: down the slope to the left it turns anticlockwise.
        const auto rim = 0.5 * static_cast<double>(world.body(disc)->angular_velocity());
        CHECK(rim == Approx(-slope.along(v)).epsilon(1e-4));
    }
}

TEST_CASE(
    "a spinning disc set on the ground ends rolling with a third of its rim speed, away from its spin") {
    // Friction's impulse P at the rim gives v = -P/m and takes P r / I = 2 P / (m r) of the spin until the
    // rim rests: w r = 2 P/m + P/m, whatever the friction.
    for (const float friction : {0.1f, 0.5f}) {
        World world;
        add_ground(world, {.material = {.friction = friction}});
        const BodyId disc = add(world, {.position_m = {0, 0.5}, .angular_velocity_rad_s = 12},
                                Circle{{}, 0.5f}, {.material = {.friction = friction}});
        run_for(world, 4);
        CHECK(world.body(disc)->linear_velocity().x == Approx(-2).epsilon(5e-3));
        CHECK(world.body(disc)->angular_velocity() == Approx(4).epsilon(5e-3));
    }
}

TEST_CASE("a ball that rolls fast does not sink") {
    World world({.enable_sleep = false});
    add_ground(world);
    const BodyId ball =
        add(world, {.position_m = {-40, 0.5}, .linear_velocity_m_s = {10, 0}, .angular_velocity_rad_s = -20},
            Circle{{}, 0.5f});
    for (int i = 0; i < 300; ++i) {
        world.step(kStep_s).value();
        REQUIRE(world.body(ball)->position().y == Approx(0.5).margin(1e-5));
        REQUIRE(world.body(ball)->linear_velocity().y == Approx(0).margin(1e-4));
    }
    CHECK(world.body(ball)->linear_velocity().x == Approx(10).epsilon(1e-3));
    CHECK(world.body(ball)->angular_velocity() == Approx(-20).epsilon(1e-3));
}

TEST_CASE("a changed material rubs from the next step on") {
    World world;
    add_ground(world, {.material = {.friction = 1}});
    const BodyId box = add(world, {.position_m = {0, 0.1}, .linear_velocity_m_s = {5, 0}}, Box{0.5f, 0.1f},
                           {.material = {.friction = 0}});
    run_for(world, 0.5);
    CHECK(world.body(box)->linear_velocity().x == 5);
    world.shape(world.body(box)->shapes()[0])->set_material({.friction = 0.25f}).value();
    run_for(world, 0.5);
    CHECK(world.body(box)->linear_velocity().x == Approx(5 - 0.5 * 10 * 0.5).epsilon(5e-3));
}

}  // namespace cairn::physics
