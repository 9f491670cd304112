// Integration of motions on their own, without a world.
#include "integrator/integrate.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

namespace cairn::physics {
namespace {

// One substep's change of all velocities.
void push(Motions& motions, std::span<const Drive> drives, float h_s, bool afresh) {
    const auto is_damped = [](const Drive& d) { return d.linear_damping != 0 || d.angular_damping != 0; };
    const auto size = static_cast<std::size_t>(motions.size());
    motions.kick.resize(size);
    motions.kept.resize(std::ranges::any_of(drives, is_damped) ? size : 0);
    prepare_kicks(motions, drives, h_s, 0, motions.size());
    integrate_velocities(motions, afresh, 0, motions.size());
}

}  // namespace

TEST_CASE("free flight leaves constrained bodies alone, and substeps leave free ones alone") {
    Motions motions;
    motions.add({1, 2}, 0, 1, 1);
    motions.add({1, 2}, 0, 1, 1);
    motions.mover[1] = MovedBy::Substeps;
    const Drive falls{.acceleration = {0, -10}, .gravity_scale = 1};
    const std::array drives{falls, falls};

    fly_freely(motions, drives, {0, -10}, 0.5f, 0);
    CHECK(motions.velocity[0].v == Vec2{1, -3});
    CHECK(motions.pose[0].d == Vec2{0.5f, -0.25f});
    CHECK(motions.velocity[1].v == Vec2{1, 2});
    CHECK(motions.pose[1].d == Vec2{});

    push(motions, drives, 0.25f, true);
    CHECK(motions.velocity[0].v == Vec2{1, -3});
    CHECK(motions.velocity[1].v == Vec2{1, -0.5f});
    integrate_positions(motions, 0.25f);
    CHECK(motions.pose[0].d == Vec2{0.5f, -0.25f});
    CHECK(motions.pose[1].d == Vec2{0.25f, -0.125f});
}

TEST_CASE("one stride of free flight follows the parabola exactly") {
    Motions motions;
    motions.add({3, 4}, 0, 1, 1);
    fly_freely(motions, std::array{Drive{.acceleration = {0, -10}, .gravity_scale = 1}}, {0, -10}, 1, 0);
    // Every number here is one that float holds.
    CHECK(motions.pose[0].d == Vec2{3, -1});
    CHECK(motions.velocity[0].v == Vec2{3, -6});
}

TEST_CASE("in one stride a force is a kick at the start, on top of the parabola") {
    Motions motions;
    motions.add({3, 4}, 0, 1, 1);
    motions.add({3, 4}, 0, 1, 1);
    motions.lock(1, kLockedY);
    const Drive forced{.acceleration = {2, -10}, .gravity_scale = 1};
    const Drive held{.acceleration = {2, 0}, .gravity_scale = 1};
    fly_freely(motions, std::array{forced, held}, {0, -10}, 1, 0);
    CHECK(motions.pose[0].d == Vec2{5, -1});
    CHECK(motions.velocity[0].v == Vec2{5, -6});
    CHECK(motions.pose[1].d == Vec2{5, 4});
}

TEST_CASE("a torque turns a free body by half its angular acceleration times time squared") {
    Motions motions;
    motions.add({}, 0, 1, 0.25f);  // an inertia of 4, so that the scale of angular rows counts
    fly_freely(motions, std::array{Drive{.angular_acceleration = 2}}, {}, 0.5f, 0);
    CHECK(motions.spin(0) == 1);
    CHECK(motions.angle(0) == 0.25f);
}

TEST_CASE("damping takes the same share of the velocity in one stride as in many substeps") {
    Motions motions;
    motions.add({8, 0}, 4, 1, 1);
    motions.add({8, 0}, 4, 1, 1);
    motions.mover[1] = MovedBy::Substeps;
    const Drive drive{.linear_damping = 2, .angular_damping = 3};
    const std::array drives{drive, drive};
    fly_freely(motions, drives, {}, 0.5f, 0);
    for (int i = 0; i < 8; ++i) push(motions, drives, 0.0625f, i == 0);
    for (int body = 0; body < 2; ++body) {
        // Eight multiplications, each rounded: 8 * 2^-24 = 5e-7 relative.
        CHECK(static_cast<double>(motions.velocity[body].v.x) == Approx(8 * std::exp(-1.0)).epsilon(1e-6));
        CHECK(static_cast<double>(motions.spin(body)) == Approx(4 * std::exp(-1.5)).epsilon(1e-6));
    }
}

TEST_CASE("what contacts added in one substep is given again in the next, and what joints added is not") {
    Motions motions;
    motions.add({0, 0}, 0, 1, 1);
    motions.mover[0] = MovedBy::Turning;
    const std::array drives{Drive{.acceleration = {0, -16}}};
    push(motions, drives, 0.25f, true);
    CHECK(motions.velocity[0].v == Vec2{0, -4});

    motions.velocity[0].v += Vec2{1, 2};  // a contact
    begin_joints(motions, 0, 1);
    motions.velocity[0].v += Vec2{0, 8};
    end_joints(motions, 0, 1);
    CHECK(motions.velocity[0].v == Vec2{1, 6});

    push(motions, drives, 0.25f, false);
    CHECK(motions.velocity[0].v == Vec2{2, 4});  // (1, 6) + (0, -4) + (1, 2)
}

}  // namespace cairn::physics
