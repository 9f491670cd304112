// Explosions against closed forms for discs and boxes, and against symmetry.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "physics/support/making.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using namespace test;

Vec2 momentum(const World& world, BodyId body) {
    return world.body(body)->mass() * world.body(body)->linear_velocity();
}

double inertia(const World& world, BodyId body) {
    return static_cast<double>(world.body(body)->mass_data().inertia_kg_m2);
}

}  // namespace

TEST_CASE("a disc gets the impulse times its diameter, outward, and is not turned") {
    for (const double origin : {0.0, 1e7}) {
        World world({.gravity_m_s2 = {}});
        const BodyId disc = add(world, {.position_m = {origin + 1.2, 1.6}, .angle_rad = 1}, Circle{{}, 0.5f});
        world.explode({.center_m = {origin, 0}, .radius_m = 3, .impulse_ns_m = 7}).value();
        const Vec2 p = momentum(world, disc);
        CHECK(static_cast<double>(p.x) == Approx(7 * 1 * 0.6).epsilon(1e-5));
        CHECK(static_cast<double>(p.y) == Approx(7 * 1 * 0.8).epsilon(1e-5));
        CHECK(world.body(disc)->angular_velocity() == Approx(0).margin(1e-4));
    }
}

TEST_CASE("a box gets the impulse times the side that faces the explosion") {
    World world({.gravity_m_s2 = {}});
    const BodyId facing = add(world, {.position_m = {2, 0}}, Box{0.5f, 0.75f});
    const BodyId cornered =
        add(world, {.position_m = {0, 2}, .angle_rad = static_cast<double>(kPi) / 4}, Box{0.5f, 0.5f});
    world.explode({.center_m = {0, 0}, .radius_m = 4, .impulse_ns_m = 2}).value();
    CHECK(static_cast<double>(momentum(world, facing).x) == Approx(2 * 1.5).epsilon(1e-5));
    CHECK(momentum(world, facing).y == Approx(0).margin(1e-5));
    // Of the square that stands on a corner, the diagonal.
    CHECK(static_cast<double>(momentum(world, cornered).y) == Approx(2 * std::sqrt(2.0)).epsilon(1e-5));
}

TEST_CASE("a plank that is met at one end is turned as the pressure on its side says") {
    World world({.gravity_m_s2 = {}});
    const BodyId plank = add(world, {}, Box{4, 0.1f});
    world.explode({.center_m = {3, -1}, .radius_m = 1.5f, .falloff_m = 0, .impulse_ns_m = 5}).value();
    // On the lower side, 0.9 m away, the half chord of the circle is sqrt(1.5^2 - 0.9^2) = 1.2: from x = 1.8
    // to the end at 4. Pieces are 1 m long, and count by their middles: those of 2, 3 and 4.
    const double low = 2 - 0.0;
    const double impulse = 5 * (4 - low);
    CHECK(static_cast<double>(momentum(world, plank).y) == Approx(impulse));
    CHECK(static_cast<double>(world.body(plank)->angular_velocity()) * inertia(world, plank) ==
          Approx(impulse * 3).epsilon(1e-4));
}

TEST_CASE("the impulse fades linearly with the distance of the surface") {
    const auto push_at = [](double distance) {
        World world({.gravity_m_s2 = {}});
        const BodyId wall = add(world, {.position_m = {distance + 0.5, 0}}, Box{0.5f, 0.05f});
        world.explode({.radius_m = 2, .falloff_m = 4, .impulse_ns_m = 10}).value();
        return static_cast<double>(momentum(world, wall).x);
    };
    CHECK(push_at(1) == Approx(1).epsilon(1e-4));
    CHECK(push_at(3) == Approx(0.75).epsilon(1e-3));
    CHECK(push_at(5) == Approx(0.25).epsilon(1e-3));
    CHECK(push_at(6.1) == 0);
}

TEST_CASE("in a symmetric arrangement the impulses add up to nothing") {
    World world({.gravity_m_s2 = {}});
    std::vector<BodyId> bodies;
    for (int i = 0; i < 12; ++i) {
        const double angle = static_cast<double>(kPi) / 6 * i;
        const Position place{2 * deterministic::cos(angle), 2 * deterministic::sin(angle)};
        const Geometry geometry = i % 2 == 0 ? Geometry{Box{0.3f, 0.2f, {}, 0, 0.1f}}
                                             : Geometry{Capsule{{-0.2f, 0}, {0.2f, 0}, 0.1f}};
        bodies.push_back(add(world, {.position_m = place, .angle_rad = angle + (i % 2) * 0.3}, geometry));
    }
    world.explode({.radius_m = 1.5f, .falloff_m = 2, .impulse_ns_m = 10}).value();
    Vec2 sum;
    float all = 0;
    for (const BodyId body : bodies) {
        sum += momentum(world, body);
        all += length(momentum(world, body));
    }
    CHECK(all > 10);
    CHECK(length(sum) < 1e-5f * all);
}

TEST_CASE("a centre inside a shape pushes it out the short way") {
    World world({.gravity_m_s2 = {}});
    const BodyId box = add(world, {}, Box{1, 0.5f});
    world.explode({.center_m = {0.1, -0.4}, .radius_m = 3, .impulse_ns_m = 1}).value();
    CHECK(static_cast<double>(momentum(world, box).y) == Approx(2).epsilon(1e-5));
    CHECK(momentum(world, box).x == Approx(0).margin(1e-5));
}

TEST_CASE("an explosion moves dynamic bodies only, wakes them, and minds the filter") {
    World world({.gravity_m_s2 = {}});
    const BodyId asleep = add(world, {.position_m = {2, 0}, .awake = false}, Circle{});
    const BodyId spared = add(world, {.position_m = {-2, 0}}, Circle{}, {.filter = {.categories = 2}});
    const BodyId fixed = add(world, {.type = BodyType::Static, .position_m = {0, 2}}, Circle{});
    const BodyId driven = add(world, {.type = BodyType::Kinematic, .position_m = {0, -2}}, Circle{});
    world.explode({.filter = {.mask = 1}}).value();
    CHECK(world.body(asleep)->is_awake());
    CHECK(world.body(asleep)->linear_velocity().x > 0);
    for (const BodyId body : {spared, fixed, driven}) CHECK(world.body(body)->linear_velocity() == Vec2{});
}

TEST_CASE("shapes of the shelter's categories keep an explosion from what is behind them") {
    World world({.gravity_m_s2 = {}});
    const BodyId behind = add(world, {.position_m = {3, 0}}, Box{0.4f, 0.4f});
    const BodyId beside = add(world, {.position_m = {-3, 0}}, Box{0.4f, 0.4f});
    const BodyId half = add(world, {.position_m = {0, 3}}, Box{0.4f, 0.4f});
    add(world, {.type = BodyType::Static, .position_m = {1.5, 0}}, Box{0.2f, 2},
        {.filter = {.categories = 4}});
    add(world, {.type = BodyType::Static, .position_m = {1, 2}}, Box{1, 0.1f}, {.filter = {.categories = 4}});
    world.explode({.radius_m = 5, .impulse_ns_m = 1, .shelter = 4}).value();
    CHECK(world.body(behind)->linear_velocity() == Vec2{});
    CHECK(static_cast<double>(momentum(world, beside).x) == Approx(-0.8).epsilon(1e-4));
    CHECK(static_cast<double>(momentum(world, half).y) == Approx(0.4).epsilon(1e-4));
    CHECK(world.body(half)->angular_velocity() < 0);  // pushed up at its left
}

TEST_CASE("bodies of several shapes get the impulses of all, about their common centre") {
    World world({.gravity_m_s2 = {}});
    const BodyId dumbbell = world.create_body({.position_m = {2, 0}}).value();
    world.create_shape(dumbbell, Circle{{0, 1}, 0.5f}).value();
    world.create_shape(dumbbell, Circle{{0, -1}, 0.5f}).value();
    world.explode({.radius_m = 5, .impulse_ns_m = 1}).value();
    // Two diameters, each along (2, +-1) / sqrt 5.
    CHECK(static_cast<double>(momentum(world, dumbbell).x) == Approx(2 * 2 / std::sqrt(5.0)).epsilon(1e-5));
    CHECK(momentum(world, dumbbell).y == Approx(0).margin(1e-5));
    CHECK(world.body(dumbbell)->angular_velocity() == Approx(0).margin(1e-5));
}

TEST_CASE("bad explosions are refused") {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    World world;
    const auto message = [&](const ExplosionDef& def) {
        const auto result = world.explode(def);
        return result ? "no error" : result.error().message;
    };
    using Catch::Matchers::Contains;
    CHECK_THAT(message({.center_m = {std::numeric_limits<double>::infinity(), 0}}),
               Contains("explosion.center_m"));
    CHECK_THAT(message({.radius_m = -1}), Contains("explosion.radius_m is -1"));
    CHECK_THAT(message({.radius_m = 1e30f}), Contains("at most 1e9 m"));
    CHECK_THAT(message({.falloff_m = kNaN}), Contains("explosion.falloff_m is nan"));
    CHECK_THAT(message({.impulse_ns_m = kNaN}), Contains("explosion.impulse_ns_m is nan"));
}

}  // namespace cairn::physics
