// Heaps of boxes that fell as they liked: edges on edges, corners on edges, boxes borne on one side. They
// come to rest. The bounds are what another engine of the same method (soft contacts, four substeps) keeps in
// such heaps: it sleeps after 200 to 660 steps, and changes velocities by .04 to .13 mm/s a step (rms) until
// then. And what moves as a whole: columns that slump, towers that glide
// (docs/adr/029-both-points-at-once.md).
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
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

constexpr float kStone_m = 0.25f;  // radius

// Forty hexagons in a column, which slumps. Their places are off sideways by up to the scatter.
void add_column_of_stones(World& world, double scatter_m, std::uint64_t seed) {
    const ShapeDef gravel{.material = {.friction = 0.5f}};
    add_ground(world, gravel);
    std::array<Vec2, 6> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] =
            rotate(Rotation::from_angle(static_cast<double>(i) * std::numbers::pi / 3), {kStone_m, 0});
    Random random(seed);
    for (int row = 0; row < 10; ++row) {
        for (int column = 0; column < 4; ++column) {
            const double x = 2.05 * double{kStone_m} * (column + 0.5 * (row % 2) - 2);
            const double y = double{kStone_m} * (1 + 1.8 * row);
            add(world, {.position_m = {x + random.real(-scatter_m, scatter_m), y}},
                Polygon{.points_m = corners}, gravel);
        }
    }
}

// Mean height over mean distance from the middle.
double slope_of_stones(const World& world) {
    double height = 0, middle = 0, width = 0, count = 0;
    for (const BodyId id : world.bodies()) {
        if (world.body(id)->type() != BodyType::Dynamic) continue;
        height += world.body(id)->position().y - double{kStone_m} * std::sqrt(0.75);
        middle += world.body(id)->position().x;
        ++count;
    }
    for (const BodyId id : world.bodies()) {
        if (world.body(id)->type() != BodyType::Dynamic) continue;
        width += std::fabs(world.body(id)->position().x - middle / count);
    }
    return height / width;
}

double mean_slope(int columns, double scatter_m, int steps_per_s) {
    double sum = 0;
    for (int seed = 0; seed < columns; ++seed) {
        World world;
        add_column_of_stones(world, scatter_m, static_cast<std::uint64_t>(seed));
        run_for(world, 5, 1.0f / static_cast<float>(steps_per_s));
        sum += slope_of_stones(world);
    }
    return sum / columns;
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

// Off by up to a centimetre each slumps in its own way, by slopes that scatter by .035: the mean of so many
// is known to .006, and what is told apart here is a sixth of the slope.
TEST_CASE("columns of stones slump to the slope that steps of a quarter give") {
    const double usual = mean_slope(32, 1e-2, 60);
    const double fine = mean_slope(32, 1e-2, 240);
    CAPTURE(usual, fine);
    CHECK(usual == Approx(fine).margin(0.03));
}

// What glides evenly is in balance. Boxes of 20 cm: wider ones stand even where no estimate of their loads is
// trusted, since soft contacts bear them; these lean by 4 cm then at .03 m/s, and fall at .1 and more.
TEST_CASE("a tower that glides on ice stays upright") {
    constexpr int kStoreys = 30;
    constexpr double kHalf_m = 0.1;
    for (const float speed_m_s : {0.03f, 0.1f, 0.3f, 1.0f}) {
        World world({.enable_sleep = false});
        add_ground(world, {.material = {.friction = 0}});
        Random random(7);
        std::vector<BodyId> boxes;
        for (int i = 0; i < kStoreys; ++i) {
            const Position at{random.real(-0.2, 0.2) * kHalf_m, kHalf_m * (2 * i + 1)};
            boxes.push_back(add(world, {.position_m = at, .linear_velocity_m_s = {speed_m_s, 0}},
                                Box{static_cast<float>(kHalf_m), static_cast<float>(kHalf_m)}));
        }
        const auto width_m = [&] {
            return world.body(boxes.back())->position().x - world.body(boxes.front())->position().x;
        };
        const double before_m = width_m();
        run_for(world, 20);
        CAPTURE(speed_m_s);
        CHECK(width_m() == Approx(before_m).margin(0.005));
        CHECK(world.body(boxes.back())->position().y == Approx(kHalf_m * (2 * kStoreys - 1)).margin(0.005));
    }
}

}  // namespace cairn::physics
