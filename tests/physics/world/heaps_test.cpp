// Heaps of boxes that fell as they liked: edges on edges, corners on edges, boxes borne on one side. They
// come to rest. The bounds are what another engine of the same method (soft contacts, four substeps) keeps in
// such heaps: it sleeps after 200 to 660 steps, and changes velocities by .04 to .13 mm/s a step (rms) until
// then.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr int kBoxes = 200;
constexpr int kHeaps = 6;

// Rows of boxes dropped into a bin, level or turned as chance has it. Level ones land as columns.
void add_heap(World& world, int seed, bool turned) {
    const double half_width = 0.6 * std::sqrt(double{kBoxes});
    constexpr double kSpacing_m = 1.1;
    const int columns = static_cast<int>(2 * half_width / kSpacing_m);
    add_ground(world);
    for (const double side : {-1.0, 1.0})
        add(world, {.type = BodyType::Static, .position_m = {side * (half_width + 1), 50}}, Box{1, 50});
    Random random(static_cast<std::uint64_t>(seed));
    const bool square = seed % 2 != 0;
    for (int i = 0; i < kBoxes; ++i) {
        const double half = random.real(0.2, 0.45);
        const double height = square ? half : half * random.real(0.5, 1);
        add(world,
            {.position_m = {-half_width + 0.6 + kSpacing_m * (i % columns), 0.6 + kSpacing_m * (i / columns)},
             .angle_rad = turned ? random.real(-3, 3) : 0.0},
            Box{static_cast<float>(half), static_cast<float>(height)});
    }
}

std::vector<Vec2> velocities(const World& world) {
    std::vector<Vec2> all;
    for (const BodyId id : world.bodies()) all.push_back(world.body(id)->linear_velocity());
    return all;
}

// m/s, rms over all bodies and steps.
double change_of_velocity(World& world, int steps) {
    double sum = 0;
    std::vector<Vec2> before = velocities(world);
    for (int i = 0; i < steps; ++i) {
        step_times(world, 1);
        const std::vector<Vec2> now = velocities(world);
        for (std::size_t k = 0; k < now.size(); ++k)
            sum += static_cast<double>(length_squared(now[k] - before[k]));
        before = now;
    }
    return std::sqrt(sum / (steps * static_cast<double>(before.size())));
}

}  // namespace

TEST_CASE("heaps of boxes fall asleep") {
    for (const bool turned : {false, true}) {
        for (int seed = 0; seed < kHeaps; ++seed) {
            CAPTURE(turned, seed);
            World world;
            add_heap(world, seed, turned);
            int steps = 0;
            for (; steps < 1200 && world.awake_body_count() > 0; ++steps) step_times(world, 1);
            CAPTURE(steps);
            CHECK(world.awake_body_count() == 0);
        }
    }
}

TEST_CASE("heaps of boxes that are kept awake do not jitter") {
    for (const bool turned : {false, true}) {
        std::vector<double> jitter_m_s;
        for (int seed = 0; seed < kHeaps; ++seed) {
            World world({.enable_sleep = false});
            add_heap(world, seed, turned);
            run_for(world, 20);
            jitter_m_s.push_back(change_of_velocity(world, 60));
        }
        std::sort(jitter_m_s.begin(), jitter_m_s.end());
        CAPTURE(turned, jitter_m_s);
        // Now and then one trembles for long.
        CHECK(jitter_m_s[kHeaps / 2] < 1e-5);
        CHECK(jitter_m_s[kHeaps - 2] < 1e-3);
    }
}

TEST_CASE("columns of boxes that fall onto each other stand as they fell, and sleep") {
    for (int seed = 0; seed < kHeaps; ++seed) {
        World world;
        add_heap(world, seed, false);
        std::vector<double> x_m;
        for (const BodyId id : world.bodies()) x_m.push_back(world.body(id)->position().x);
        run_for(world, 5);
        std::size_t i = 0;
        for (const BodyId id : world.bodies()) {
            CAPTURE(seed, i);
            REQUIRE(world.body(id)->position().x == Approx(x_m[i++]).margin(1e-4));
            REQUIRE(std::fabs(world.body(id)->angle()) < 1e-4);
        }
        CHECK(world.awake_body_count() == 0);
    }
}

}  // namespace cairn::physics
