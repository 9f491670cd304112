// Impacts that go through what touches, against the laws of impact.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "physics/support/making.h"
#include "physics/support/pieces.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr float kRadius_m = 0.5f;

struct Ball {
    double mass_kg;
    double speed_m_s;
};

// A row of touching discs in the order in which they stand, made in another.
std::vector<BodyId> add_row(World& world, const std::vector<Ball>& balls, bool backwards,
                            const Material& material) {
    std::vector<BodyId> ids(balls.size());
    for (std::size_t n = 0; n < balls.size(); ++n) {
        const std::size_t i = backwards ? balls.size() - 1 - n : n;
        // What moves starts a little apart.
        const double x =
            2.0 * static_cast<double>(kRadius_m) * static_cast<double>(i) - 0.05 * balls[i].speed_m_s;
        const double area_m2 = M_PI / 4;
        ids[i] =
            add(world,
                {.position_m = {x, 0.5}, .linear_velocity_m_s = {static_cast<float>(balls[i].speed_m_s), 0}},
                Circle{{}, kRadius_m},
                {.density_kg_m2 = static_cast<float>(balls[i].mass_kg / area_m2), .material = material});
    }
    return ids;
}

// Neighbours that close in bounce off each other, in any order, until none do.
std::vector<double> after_impacts(std::vector<Ball> balls, double e) {
    for (bool any = true; any;) {
        any = false;
        for (std::size_t i = 0; i + 1 < balls.size(); ++i) {
            Ball& a = balls[i];
            Ball& b = balls[i + 1];
            const double closing = a.speed_m_s - b.speed_m_s;
            if (closing <= 1e-9) continue;
            const double impulse = (1 + e) * closing / (1 / a.mass_kg + 1 / b.mass_kg);
            a.speed_m_s -= impulse / a.mass_kg;
            b.speed_m_s += impulse / b.mass_kg;
            any = true;
        }
    }
    std::vector<double> speeds;
    for (const Ball& ball : balls) speeds.push_back(ball.speed_m_s);
    return speeds;
}

}  // namespace

TEST_CASE("of a cradle as many balls leave as came, with their speed, on the floor too") {
    for (const bool backwards : {false, true}) {
        for (const float gravity_m_s2 : {0.0f, 10.0f}) {
            for (std::size_t coming = 1; coming <= 3; ++coming) {
                World world({.gravity_m_s2 = {0, -gravity_m_s2}});
                if (gravity_m_s2 > 0) add_ground(world, {.material = {.friction = 0, .restitution = 1}});
                std::vector<Ball> balls(coming, {1, 4});
                balls.resize(coming + 5, {1, 0});
                const std::vector<BodyId> row =
                    add_row(world, balls, backwards, {.friction = 0, .restitution = 1});
                run_for(world, 0.5);
                INFO(coming << " balls" << (backwards ? " backwards" : "") << ", gravity " << gravity_m_s2);
                for (std::size_t i = 0; i < row.size(); ++i) {
                    const double expected = i < 5 ? 0 : 4;
                    CHECK(world.body(row[i])->linear_velocity().x == Approx(expected).margin(1e-4));
                    CHECK(std::fabs(world.body(row[i])->linear_velocity().y) < 1e-3f);
                }
                // As far off as if it had happened at once: 0.05 s to go, and then as they left.
                const double x = 2.0 * static_cast<double>(kRadius_m) * static_cast<double>(row.size() - 1);
                CHECK(world.body(row.back())->position().x == Approx(x + 4 * 0.45).margin(2e-3));
            }
        }
    }
}

TEST_CASE("a row of unequal balls leaves as impacts of neighbours in turn have it") {
    Random random(5);
    for (int run = 0; run < 20; ++run) {
        World world({.gravity_m_s2 = {}, .restitution_speed_m_s = 0});
        std::vector<Ball> balls{{random.real(0.5, 4), 5}};
        // Ever lighter: then each is hit once, and the order of the impacts is not in question.
        for (int i = 1; i < 6; ++i) balls.push_back({balls.back().mass_kg * random.real(0.3, 0.9), 0});
        const std::vector<double> expected = after_impacts(balls, 1);
        const std::vector<BodyId> row =
            add_row(world, balls, run % 2 == 1, {.friction = 0, .restitution = 1});
        run_for(world, 0.5);
        INFO("run " << run);
        for (std::size_t i = 0; i < row.size(); ++i)
            CHECK(world.body(row[i])->linear_velocity().x == Approx(expected[i]).margin(1e-3));
    }
}

TEST_CASE(
    "at the break of a rack momentum is kept, energy does not grow, and none is lost without friction") {
    for (const float friction : {0.0f, 0.3f}) {
        for (const float e : {0.6f, 1.0f}) {
            World world({.gravity_m_s2 = {}, .restitution_speed_m_s = 0.1f});
            const ShapeDef ball{.material = {.friction = friction, .restitution = e}};
            std::vector<BodyId> bodies{add(world, {.position_m = {-3, 0.21}, .linear_velocity_m_s = {9, 0}},
                                           Circle{{}, kRadius_m}, ball)};
            for (int i = 0; i < 5; ++i) {
                for (int j = 0; j <= i; ++j) {
                    bodies.push_back(add(world, {.position_m = {i * std::sqrt(0.75), j - 0.5 * i}},
                                         Circle{{}, kRadius_m}, ball));
                }
            }
            const Totals before = totals(world, bodies);
            run_for(world, 0.4);
            const Totals after = totals(world, bodies);
            INFO("friction " << friction << ", e " << e);
            CHECK(after.momentum_x == Approx(before.momentum_x).margin(1e-5 * before.momentum_x));
            CHECK(after.momentum_y == Approx(before.momentum_y).margin(1e-5 * before.momentum_x));
            // Arms are those of the start of the step.
            CHECK(after.angular_momentum == Approx(before.angular_momentum).epsilon(0.06));
            CHECK(after.kinetic_energy <= before.kinetic_energy * 1.001);
            if (friction == 0 && e == 1)
                CHECK(after.kinetic_energy == Approx(before.kinetic_energy).epsilon(0.01));
            CHECK(world.body(bodies.back())->linear_velocity().x > 1);  // all of it is on its way
        }
    }
}

// In large worlds with few impacts groups are grown at once, in others heaps are sorted out before.
TEST_CASE(
    "a cradle is the same alone, beside a pyramid at rest, and beside a heap that is hit in each step") {
    for (const bool with_pyramid : {false, true}) {
        for (const bool with_heap : {false, true}) {
            INFO((with_pyramid ? "pyramid, " : "") << (with_heap ? "heap" : ""));
            World world({.gravity_m_s2 = {}, .enable_sleep = false});
            const Material elastic{.friction = 0, .restitution = 1};
            const std::vector<Ball> balls{{1, 4}, {1, 0}, {1, 0}, {1, 0}, {1, 0}};
            const std::vector<BodyId> row = add_row(world, balls, false, elastic);
            for (int i = 0; with_pyramid && i < 30; ++i) {
                for (int j = i; j < 30; ++j)
                    add(world, {.position_m = {100 + 0.5 * i + (j - i), 1.0 * i}}, Box{0.5f, 0.5f});
            }
            for (int i = 0; with_heap && i < 15; ++i) {
                for (int j = 0; j < 15; ++j)
                    add(world, {.position_m = {-100 + 1.0 * i, 1.0 * j}}, Circle{{}, kRadius_m},
                        {.material = elastic});
                add(world, {.position_m = {-100 + 1.0 * i, -3.0 - i}, .linear_velocity_m_s = {0, 10}},
                    Circle{{}, kRadius_m}, {.material = elastic});
            }
            run_for(world, 0.5);
            for (std::size_t i = 0; i < row.size(); ++i) {
                CHECK(world.body(row[i])->linear_velocity().x == Approx(i < 4 ? 0 : 4).margin(1e-4));
                CHECK(world.body(row[i])->linear_velocity().y == Approx(0).margin(1e-4));
            }
        }
    }
}

}  // namespace cairn::physics
