// Wind against the closed forms of quadratic drag, and against symmetry.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr double kDt_s = static_cast<double>(kStep_s);

void blow_for(World& world, double time_s, const WindDef& wind) {
    const long steps = std::lround(time_s / kDt_s);
    for (long i = 0; i < steps; ++i) {
        world.apply_wind(wind, kStep_s).value();
        world.step(kStep_s).value();
    }
}

// The force on a body at rest: what its momentum changes by in a step so short that nothing else changes.
struct Push {
    Vec2 force;
    double torque;
};

Push push_of(const WindDef& wind, const Geometry& geometry, const BodyDef& def = {}) {
    constexpr float kShort_s = 1e-5f;
    World world({.gravity_m_s2 = {}});
    const BodyId id = add(world, def, geometry, {.density_kg_m2 = 1000});
    world.apply_wind(wind, kShort_s).value();
    world.step(kShort_s).value();
    const Body body = *world.body(id);
    const float mass = body.mass();
    const double spin = static_cast<double>(body.angular_velocity() - def.angular_velocity_rad_s);
    return {(mass / kShort_s) * (body.linear_velocity() - def.linear_velocity_m_s),
            static_cast<double>(body.mass_data().inertia_kg_m2) * spin / static_cast<double>(kShort_s)};
}

}  // namespace

TEST_CASE("a disc is pushed by half the density times its drag, diameter and the square of the wind") {
    const WindDef wind{.velocity_m_s = {6, 8}, .density_kg_m2 = 1.5f, .drag = 0.5f};
    const Push push = push_of(wind, Circle{{}, 0.25f}, {.angular_velocity_rad_s = 5});
    const double force = 0.5 * 1.5 * 0.5 * 0.5 * 100;
    CHECK(static_cast<double>(push.force.x) == Approx(force * 0.6).epsilon(1e-3));
    CHECK(static_cast<double>(push.force.y) == Approx(force * 0.8).epsilon(1e-3));
    CHECK(push.torque == Approx(0).margin(0.01));
}

TEST_CASE("a box is pushed by its width across the wind, and not turned") {
    const WindDef wind{.velocity_m_s = {10, 0}, .density_kg_m2 = 2, .drag = 1};
    CHECK(static_cast<double>(push_of(wind, Box{1, 0.5f}).force.x) == Approx(100 * 1.0).epsilon(1e-3));
    const Push turned = push_of(wind, Box{0.5f, 0.5f}, {.angle_rad = static_cast<double>(kPi) / 4});
    CHECK(static_cast<double>(turned.force.x) == Approx(100 * std::sqrt(2.0)).epsilon(1e-3));
    CHECK(turned.force.y == Approx(0).margin(0.1));
    CHECK(turned.torque == Approx(0).margin(0.1));
}

TEST_CASE("a flat plate is lifted as the sine times the cosine of its angle") {
    const WindDef wind{.velocity_m_s = {10, 0}, .density_kg_m2 = 2, .drag = 0, .lift = 1};
    const double angle = 0.3;
    // Nearly all of its outline that faces the wind is one side, 4 m long.
    const Push push = push_of(wind, Box{2, 0.001f}, {.angle_rad = angle});
    const double facing = 4 * std::sin(angle);
    CHECK(static_cast<double>(push.force.y) == Approx(-100 * facing * std::cos(angle)).epsilon(0.01));
    CHECK(push.force.x == Approx(0).margin(1));
}

TEST_CASE("wind on one arm of a lever turns it") {
    World world({.gravity_m_s2 = {}});
    const BodyId lever = world.create_body({}).value();
    world.create_shape(lever, Box{0.1f, 0.1f}, {.density_kg_m2 = 1e6f}).value();
    world.create_shape(lever, Box{0.1f, 0.5f, {0, 2}}, {.density_kg_m2 = 0}).value();
    world.apply_wind({.velocity_m_s = {10, 0}, .density_kg_m2 = 2}, kStep_s).value();
    world.step(kStep_s).value();
    const double torque = static_cast<double>(world.body(lever)->angular_velocity()) *
                          static_cast<double>(world.body(lever)->mass_data().inertia_kg_m2) / kDt_s;
    CHECK(torque == Approx(-100 * 1.0 * 2).epsilon(0.02));
}

TEST_CASE("a disc follows the exact solution of quadratic drag, however strong the wind") {
    for (const float density : {0.1f, 10.0f, 1e4f}) {
        INFO("density of the air " << density);
        World world({.gravity_m_s2 = {}});
        const BodyId disc = add(world, {}, Circle{{}, 0.5f});
        const double mass = static_cast<double>(world.body(disc)->mass());
        const WindDef wind{.velocity_m_s = {20, 0}, .density_kg_m2 = density};
        blow_for(world, 0.5, wind);
        const double k = 0.5 * static_cast<double>(density);
        const double expected = 20 - 20 / (1 + k * 20 * 0.5 / mass);
        CHECK(static_cast<double>(world.body(disc)->linear_velocity().x) == Approx(expected).epsilon(1e-3));
    }
}

TEST_CASE("a disc that falls in still air reaches its terminal speed") {
    World world;
    const BodyId disc = add(world, {.position_m = {0, 1000}}, Circle{{}, 0.5f}, {.density_kg_m2 = 10});
    const double mass = static_cast<double>(world.body(disc)->mass());
    blow_for(world, 30, {.density_kg_m2 = 1.2f});
    CHECK(static_cast<double>(-world.body(disc)->linear_velocity().y) ==
          Approx(std::sqrt(2 * mass * 10 / 1.2)).epsilon(0.01));
}

TEST_CASE("still air stops a plank that spins, and never turns it back") {
    World world({.gravity_m_s2 = {}});
    const BodyId plank = add(world, {.angular_velocity_rad_s = 50}, Box{2, 0.05f});
    float before = 50;
    for (int i = 0; i < 600; ++i) {
        blow_for(world, kDt_s, {.density_kg_m2 = 100});
        const float now = world.body(plank)->angular_velocity();
        REQUIRE(now >= 0);
        REQUIRE(now <= before);
        before = now;
    }
    CHECK(before < 0.2f);
    CHECK(length(world.body(plank)->linear_velocity()) < 0.01f);
}

TEST_CASE("a breeze leaves sleepers asleep and lets what it cannot move fall asleep") {
    World world;
    add_ground(world);
    const BodyId box = add(world, {.position_m = {0, 0.5}}, Box{0.5f, 0.5f}, {.density_kg_m2 = 1000});
    const WindDef breeze{.velocity_m_s = {1, 0}};
    blow_for(world, 3, breeze);
    CHECK_FALSE(world.body(box)->is_awake());
    world.apply_wind(box, breeze, kStep_s).value();
    CHECK(world.body(box)->is_awake());
}

TEST_CASE("wind minds the filter, and moves dynamic bodies only") {
    World world({.gravity_m_s2 = {}});
    const BodyId spared = add(world, {.position_m = {-2, 0}}, Circle{}, {.filter = {.categories = 2}});
    const BodyId blown = add(world, {.position_m = {2, 0}}, Circle{});
    const BodyId driven = add(world, {.type = BodyType::Kinematic, .position_m = {0, -2}}, Circle{});
    const WindDef wind{.velocity_m_s = {10, 0}, .filter = {.mask = 1}};
    world.apply_wind(driven, wind, kStep_s).value();
    blow_for(world, 0.1, wind);
    CHECK(world.body(blown)->linear_velocity().x > 0);
    CHECK(world.body(spared)->linear_velocity() == Vec2{});
    CHECK(world.body(driven)->linear_velocity() == Vec2{});
}

TEST_CASE("bad winds are refused") {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    World world;
    const auto message = [&](const WindDef& def, float dt_s = kStep_s) {
        const auto result = world.apply_wind(def, dt_s);
        return result ? "no error" : result.error().message;
    };
    using Catch::Matchers::Contains;
    CHECK_THAT(message({.velocity_m_s = {kNaN, 0}}), Contains("wind.velocity_m_s"));
    CHECK_THAT(message({.velocity_m_s = {1e30f, 0}}), Contains("wind.velocity_m_s"));
    CHECK_THAT(message({.density_kg_m2 = -1}), Contains("wind.density_kg_m2 is -1"));
    CHECK_THAT(message({.drag = kNaN}), Contains("wind.drag is nan"));
    CHECK_THAT(message({.lift = -1}), Contains("wind.lift is -1"));
    CHECK_THAT(message({}, 0), Contains("step.dt_s is 0"));
    const auto null_body = world.apply_wind(BodyId{}, {}, kStep_s);
    CHECK_THAT(null_body.error().message, Contains("null"));
}

}  // namespace cairn::physics
