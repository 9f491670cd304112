// Structures that stand, awake, in worlds in which rest is looked for within a step; beside worlds in which
// it is not, since most of their bodies fly about elsewhere.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/scenes.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr int kBase = 12;
constexpr int kBoxes = kBase * (kBase + 1) / 2;

// Discs far above that drift, without weight, and meet nothing.
void add_drifters(World& world, int count) {
    for (int i = 0; i < count; ++i) {
        add(world,
            {.position_m = {10.0 * i, 1'000},
             .linear_velocity_m_s = {0, 1},
             .gravity_scale = 0,
             .allow_sleep = false},
            Circle{{}, 0.5f});
    }
}

// The boxes of a pyramid, and a ball that comes to it along the ground after half a second.
struct Pyramid {
    World world{WorldDef{.enable_sleep = false}};
    std::vector<BodyId> bodies;

    explicit Pyramid(bool looks_for_rest, float ball_speed_m_s = 0) {
        add_ground(world);
        for (int row = 0; row < kBase; ++row) {
            for (int i = 0; i < kBase - row; ++i) {
                const Position at{i + 0.5 * row, 0.5 + row};
                bodies.push_back(add(world, {.position_m = at}, Box{0.5f, 0.5f}));
            }
        }
        if (ball_speed_m_s > 0) {
            const double x = -1 - 0.5 * static_cast<double>(ball_speed_m_s);
            bodies.push_back(add(world, {.position_m = {x, 0.5}, .linear_velocity_m_s = {ball_speed_m_s, 0}},
                                 Circle{{}, 0.5f}, {.density_kg_m2 = 3, .material = {.friction = 0}}));
        }
        if (!looks_for_rest) add_drifters(world, 2 * kBoxes);
    }

    [[nodiscard]] std::vector<Position> positions() const {
        std::vector<Position> all;
        for (const BodyId id : bodies) all.push_back(world.body(id)->position());
        return all;
    }
};

double farthest_apart(const Pyramid& a, const Pyramid& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        const Vec2 apart = a.world.body(a.bodies[i])->position() - b.world.body(b.bodies[i])->position();
        most = std::max(most, static_cast<double>(length(apart)));
    }
    return most;
}

double greatest_difference_of_speed(const Pyramid& a, const Pyramid& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        const Vec2 apart =
            a.world.body(a.bodies[i])->linear_velocity() - b.world.body(b.bodies[i])->linear_velocity();
        most = std::max(most, static_cast<double>(length(apart)));
    }
    return most;
}

}  // namespace

TEST_CASE("a pyramid that stands does not move by a bit, and stands where one does that is solved in full") {
    Pyramid pyramid(true);
    Pyramid in_full(false);
    run_for(pyramid.world, 2);
    run_for(in_full.world, 2);
    const std::vector<Position> before = pyramid.positions();
    run_for(pyramid.world, 20);
    run_for(in_full.world, 20);
    CHECK(pyramid.positions() == before);
    CHECK(pyramid.world.counts().awake_bodies == kBoxes);
    CHECK(farthest_apart(pyramid, in_full) < 1e-6);
}

TEST_CASE("a platform that hardly moves takes what stands on it along") {
    World world(WorldDef{.enable_sleep = false});
    const float speed_m_s = 1e-6f;
    const BodyId platform = add(
        world, {.type = BodyType::Kinematic, .position_m = {0, -0.5}, .linear_velocity_m_s = {0, speed_m_s}},
        Box{5, 0.5f});
    std::vector<BodyId> boxes;
    for (int i = 0; i < 4; ++i) boxes.push_back(add(world, {.position_m = {0, 0.5 + i}}, Box{0.5f, 0.5f}));
    const double time_s = 600;
    run_for(world, time_s);
    const double way = time_s * static_cast<double>(speed_m_s);
    CHECK(world.body(platform)->position().y == Approx(-0.5 + way).margin(1e-6));
    // It is pushed, and rests on what pushes it within the slop.
    for (int i = 0; i < 4; ++i)
        CHECK(world.body(boxes[i])->position().y == Approx(0.5 + i + way).margin(1e-4));
}

TEST_CASE("a blow goes through a pyramid at rest as through one that is solved in full") {
    for (const float speed_m_s : {0.1f, 1.0f, 10.0f}) {
        INFO("a ball of " << speed_m_s << " m/s");
        Pyramid pyramid(true, speed_m_s);
        Pyramid in_full(false, speed_m_s);
        const BodyId ball = pyramid.bodies.back();
        bool is_hit = false;
        int steps_after = 0;
        for (int step = 0; step < 60 && steps_after < 8; ++step) {
            step_times(pyramid.world, 1);
            step_times(in_full.world, 1);
            is_hit = is_hit || pyramid.world.body(ball)->linear_velocity().x < 0.9f * speed_m_s;
            steps_after += is_hit ? 1 : 0;
        }
        CHECK(steps_after == 8);
        // Kicks below 2e-6 m/s are what may be left out.
        CHECK(greatest_difference_of_speed(pyramid, in_full) < 1e-4 * static_cast<double>(speed_m_s));
    }
}

}  // namespace cairn::physics
