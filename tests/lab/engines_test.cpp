// The engines behind the common interface mean the same by it: checked with formulas that need no accuracy.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "engine.h"

namespace cairn::measure {
namespace {

using physics::BodyType;
using physics::Box;
using physics::Circle;

std::vector<EngineKind> kinds() {
    std::vector<EngineKind> all{cairn()};
    all.insert(all.end(), peers().begin(), peers().end());
    return all;
}

}  // namespace

TEST_CASE("every engine gives a box the mass and inertia of the formulas") {
    for (const EngineKind& kind : kinds()) {
        CAPTURE(kind.name);
        const auto engine = kind.make({});
        const BodyRef box = engine->add({}, Box{1, 0.5f}, {.density_kg_m2 = 3});
        const BodyRef wall = engine->add({.type = BodyType::Static}, Box{1, 1});
        CHECK(engine->mass(box).mass_kg == Approx(6));
        CHECK(engine->mass(box).inertia_kg_m2 == Approx(6 * (4 + 1) / 12.0));
        CHECK(engine->mass(wall).mass_kg == 0);
        CHECK(engine->mass(wall).inertia_kg_m2 == 0);
    }
}

TEST_CASE("every engine puts bodies where it is told, and moves them as it is told") {
    for (const EngineKind& kind : kinds()) {
        CAPTURE(kind.name);
        const auto engine = kind.make({.gravity_m_s2 = {0, 0}});
        const BodyRef disc = engine->add({}, Circle{{}, 0.5f});
        engine->set_transform(disc, {3, 4}, std::numbers::pi / 2);
        engine->set_linear_velocity(disc, {1, -2});
        engine->set_angular_velocity(disc, 0.5f);
        const Motion placed = engine->motion(disc);
        CHECK(placed.position_m.x == 3);
        CHECK(placed.center_m.y == Approx(4));
        CHECK(placed.c == Approx(0).margin(1e-6));
        CHECK(placed.s == Approx(1));
        for (int i = 0; i < 60; ++i) engine->step(1.0f / 60);
        const Motion moved = engine->motion(disc);
        CHECK(moved.position_m.x == Approx(4).epsilon(1e-4));
        CHECK(moved.position_m.y == Approx(2).epsilon(1e-4));
        CHECK(moved.angular_velocity_rad_s == Approx(0.5));
        CHECK(std::atan2(-moved.c, moved.s) == Approx(0.5).epsilon(1e-4));  // beyond a quarter turn
    }
}

TEST_CASE("a force acts during one step") {
    for (const EngineKind& kind : kinds()) {
        CAPTURE(kind.name);
        const auto engine = kind.make({.gravity_m_s2 = {0, 0}});
        const BodyRef box = engine->add({}, Box{0.5f, 0.5f}, {.density_kg_m2 = 2});
        engine->apply_force(box, {6, 0});
        for (int i = 0; i < 3; ++i) engine->step(0.1f);
        CHECK(engine->motion(box).vx_m_s == Approx(0.3));
    }
}

TEST_CASE("a spring sags as far as its frequency says, a rod and a weld hold") {
    for (const EngineKind& kind : kinds()) {
        CAPTURE(kind.name);
        const auto engine = kind.make({.enable_sleep = false});
        const BodyRef hook = engine->add_body({.type = BodyType::Static});
        const BodyRef hung = engine->add({.position_m = {0, -1}}, Circle{{}, 0.1f});
        const BodyRef held = engine->add({.position_m = {2, -1}}, Circle{{}, 0.1f});
        const BodyRef welded = engine->add({.position_m = {-1, 0}}, Box{0.5f, 0.5f});
        engine->add_distance(hook, hung,
                             {.length_m = 1, .enable_spring = true, .frequency_hz = 1, .damping_ratio = 1});
        engine->add_distance(hook, held, {.local_anchor_a_m = {2, 0}, .length_m = 1});
        engine->add_weld(hook, welded, {.local_anchor_a_m = {-0.5f, 0}, .local_anchor_b_m = {0.5f, 0}});
        for (int i = 0; i < 600; ++i) engine->step(1.0f / 60);
        const double omega = 2 * std::numbers::pi;
        CHECK(engine->position(hung).y == Approx(-1 - 10 / (omega * omega)).epsilon(0.01));
        CHECK(engine->position(held).y == Approx(-1).epsilon(0.01));
        CHECK(engine->position(welded).x == Approx(-1).epsilon(0.01));
        CHECK(engine->motion(welded).s == Approx(0).margin(0.02));
    }
}

}  // namespace cairn::measure
