// Integration of motions on their own, without a world.
#include "integrator/integrate.h"

#include <catch2/catch.hpp>

namespace cairn::physics {

TEST_CASE("free flight leaves constrained bodies alone, and substeps leave free ones alone") {
    Motion motions[2];
    motions[0].v = motions[1].v = {1, 2};
    motions[1].constrained = true;
    const Drive drives[2] = {{.acceleration = {0, -10}}, {.acceleration = {0, -10}}};

    fly_freely(motions, drives, 0.5f);
    CHECK(motions[0].v == Vec2{1, -3});
    CHECK(motions[0].dp == Vec2{0.5f, -0.25f});
    CHECK(motions[1].v == Vec2{1, 2});
    CHECK(motions[1].dp == Vec2{});

    integrate_velocities(motions, drives, 0.25f);
    CHECK(motions[0].v == Vec2{1, -3});
    CHECK(motions[1].v == Vec2{1, -0.5f});
    integrate_positions(motions, 0.25f);
    CHECK(motions[0].dp == Vec2{0.5f, -0.25f});
    CHECK(motions[1].dp == Vec2{0.25f, -0.125f});
}

TEST_CASE("one stride of free flight follows the parabola exactly") {
    Motion body;
    body.v = {3, 4};
    const Drive drive{.acceleration = {0, -10}};
    fly_freely({&body, 1}, {&drive, 1}, 1);
    // Every number here is one that float holds.
    CHECK(body.dp == Vec2{3, -1});
    CHECK(body.v == Vec2{3, -6});
}

TEST_CASE("a torque turns a free body by half its angular acceleration times time squared") {
    Motion body;
    Drive drive;
    drive.angular_acceleration = 2;
    fly_freely({&body, 1}, {&drive, 1}, 0.5f);
    CHECK(body.w == 1);
    CHECK(static_cast<double>(body.dq.angle_rad()) == Approx(0.25).epsilon(1e-6));  // rounding of cos and sin
}

TEST_CASE("damping takes the same share of the velocity in one stride as in many substeps") {
    Drive drive;
    drive.linear_damping = 2;
    drive.angular_damping = 3;
    Motion strider;
    strider.v = {8, 0};
    strider.w = 4;
    Motion stepper = strider;
    stepper.constrained = true;
    fly_freely({&strider, 1}, {&drive, 1}, 0.5f);
    for (int i = 0; i < 8; ++i) integrate_velocities({&stepper, 1}, {&drive, 1}, 0.0625f);
    // Eight multiplications, each rounded: 8 * 2^-24 = 5e-7 relative.
    CHECK(static_cast<double>(strider.v.x) == Approx(8 * std::exp(-1.0)).epsilon(1e-6));
    CHECK(static_cast<double>(stepper.v.x) == Approx(8 * std::exp(-1.0)).epsilon(1e-6));
    CHECK(static_cast<double>(strider.w) == Approx(4 * std::exp(-1.5)).epsilon(1e-6));
    CHECK(static_cast<double>(stepper.w) == Approx(4 * std::exp(-1.5)).epsilon(1e-6));
}

}  // namespace cairn::physics
