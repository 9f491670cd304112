// The distance joint as rod, spring, rope and stop.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/precise.h"

namespace cairn::physics {
namespace {

using namespace test;

// A ball below a fixed point, hung on a joint.
struct Hung {
    World world;
    BodyId hook;
    BodyId ball;
    JointId joint;

    Hung(DistanceJointDef def, Position place, const WorldDef& world_def = {.enable_sleep = false})
        : world(world_def) {
        hook = world.create_body({.type = BodyType::Static}).value();
        ball = add(world, {.position_m = place}, Circle{{}, 0.25f}, {.density_kg_m2 = 5});
        def.body_a = hook;
        def.body_b = ball;
        joint = world.create_joint(def).value();
    }
    [[nodiscard]] double length() const { return d(world.joint(joint)->current_length()); }
    [[nodiscard]] double mass() const { return d(world.body(ball)->mass()); }
};

}  // namespace

TEST_CASE("a rod keeps its length while it swings") {
    Hung rod({.length_m = 2}, {2, 0});
    double error = 0;
    for (int i = 0; i < 600; ++i) {
        rod.world.step(kStep_s).value();
        error = std::max(error, std::fabs(rod.length() - 2));
    }
    CHECK(error < 0.005);
}

TEST_CASE("a rod under load pulls with the weight, a rod that stands pushes with it") {
    Hung hanging({.length_m = 2}, {0, -2});
    run_for(hanging.world, 1);
    CHECK(d(hanging.world.joint(hanging.joint)->reaction_force().y) ==
          Approx(10 * hanging.mass()).epsilon(1e-3));
    CHECK(hanging.length() == Approx(2).margin(1e-3));
    Hung standing({.length_m = 2}, {0, 2});
    run_for(standing.world, 1);
    CHECK(d(standing.world.joint(standing.joint)->reaction_force().y) ==
          Approx(10 * standing.mass()).epsilon(1e-3));
    CHECK(standing.length() == Approx(2).margin(1e-3));
}

TEST_CASE("a rod brings a body that is too far to its length") {
    Hung rod({.length_m = 1}, {0, -1.2});
    run_for(rod.world, 2);
    CHECK(rod.length() == Approx(1).margin(1e-3));
    rod.world.joint(rod.joint)->set_length(1.5f).value();
    run_for(rod.world, 2);
    CHECK(rod.length() == Approx(1.5).margin(1e-3));
}

TEST_CASE("a spring under a weight is stretched by m g / k") {
    for (const float frequency : {1.0f, 3.0f, 6.0f}) {
        Hung spring({.length_m = 2, .enable_spring = true, .frequency_hz = frequency, .damping_ratio = 1},
                    {0, -2});
        run_for(spring.world, 20 / d(frequency));
        const double w = 2 * kPiD * d(frequency);
        INFO(frequency << " Hz");
        CHECK(spring.length() - 2 == Approx(10 / (w * w)).epsilon(1e-2));
    }
}

TEST_CASE("a spring swings with its frequency, and a damped one comes to rest") {
    for (const float frequency : {0.5f, 1.0f, 2.0f}) {
        Hung spring({.length_m = 2, .enable_spring = true, .frequency_hz = frequency}, {0, -2.3},
                    {.gravity_m_s2 = {}, .enable_sleep = false});
        std::vector<double> crossings;
        double before = spring.length() - 2;
        for (int i = 1; crossings.size() < 5; ++i) {
            REQUIRE(i < 3000);
            spring.world.step(kStep_s).value();
            const double now = spring.length() - 2;
            if (before > 0 && now <= 0) crossings.push_back((i - 1 + before / (before - now)) / 60);
            before = now;
        }
        INFO(frequency << " Hz");
        CHECK(4 / (crossings.back() - crossings.front()) == Approx(d(frequency)).epsilon(1e-2));
    }
    Hung critical({.length_m = 2, .enable_spring = true, .frequency_hz = 1, .damping_ratio = 1}, {0, -2.3},
                  {.gravity_m_s2 = {}, .enable_sleep = false});
    for (int i = 0; i < 300; ++i) {
        critical.world.step(kStep_s).value();
        // Critical damping does not swing through.
        CHECK(critical.length() > 2 - 1e-4);
    }
    CHECK(critical.length() == Approx(2).margin(1e-4));
}

TEST_CASE("a critically damped spring follows x0 (1 + w t) e^(-w t)") {
    Hung spring({.length_m = 2, .enable_spring = true, .frequency_hz = 1, .damping_ratio = 1}, {0, -2.3},
                {.gravity_m_s2 = {}, .enable_sleep = false});
    const double w = 2 * kPiD;
    for (int i = 1; i <= 60; ++i) {
        spring.world.step(kStep_s).value();
        const double t = i / 60.0;
        // Implicit Euler is of first order: over a time of 1 / w it errs by about w h / 2 of the start.
        CHECK(spring.length() - 2 == Approx(0.3 * (1 + w * t) * std::exp(-w * t)).margin(0.3 * w / 240 / 2));
    }
}

TEST_CASE("a rope hangs loose below its length and holds at its length") {
    // A spring that is as good as absent, between 0 and 1.5 m.
    Hung rope({.length_m = 1, .enable_spring = true, .frequency_hz = 0.01f, .max_length_m = 1.5f}, {0, -0.5});
    // Free fall to the end of the rope takes sqrt(2 / 10) s.
    step_times(rope.world, 20);
    const double t = 20.0 / 60;
    CHECK(rope.length() == Approx(0.5 + 5 * t * t).epsilon(0.02));
    double longest = 0;
    for (int i = 0; i < 300; ++i) {
        rope.world.step(kStep_s).value();
        longest = std::max(longest, rope.length());
    }
    CHECK(longest < 1.5 + 0.005);
    CHECK(rope.length() == Approx(1.5).margin(2e-3));
    CHECK(d(rope.world.joint(rope.joint)->reaction_force().y) == Approx(10 * rope.mass()).epsilon(5e-3));
}

TEST_CASE("a spring is not pressed shorter than its least length") {
    Hung strut({.length_m = 1, .enable_spring = true, .frequency_hz = 0.5f, .min_length_m = 0.8f}, {0, 1});
    double shortest = 2;
    for (int i = 0; i < 300; ++i) {
        strut.world.step(kStep_s).value();
        shortest = std::min(shortest, strut.length());
    }
    CHECK(shortest > 0.8 - 0.005);
    CHECK(strut.length() == Approx(0.8).margin(2e-3));
}

TEST_CASE("a spring can become a rod, and a rod a spring") {
    Hung joint({.length_m = 2, .enable_spring = true, .frequency_hz = 1, .damping_ratio = 1}, {0, -2});
    run_for(joint.world, 5);
    CHECK(joint.length() > 2.2);
    joint.world.joint(joint.joint)->set_spring(false, 1, 1).value();
    run_for(joint.world, 5);
    CHECK(joint.length() == Approx(2).margin(1e-3));
    joint.world.joint(joint.joint)->set_spring(true, 1, 1).value();
    run_for(joint.world, 5);
    CHECK(joint.length() > 2.2);
}

TEST_CASE("two masses on a rod keep their momentum, and turn about their common centre") {
    World world({.gravity_m_s2 = {}, .enable_sleep = false});
    const BodyId a = add(world, {.position_m = {-1, 0}, .linear_velocity_m_s = {0, 3}}, Circle{{}, 0.25f});
    const BodyId b = add(world, {.position_m = {1, 0}, .linear_velocity_m_s = {0, -3}}, Circle{{}, 0.25f});
    const JointId joint =
        world.create_joint(DistanceJointDef{.body_a = a, .body_b = b, .length_m = 2}).value();
    run_for(world, 1);
    const Vec2 sum = world.body(a)->linear_velocity() + world.body(b)->linear_velocity();
    CHECK(length(sum) < 1e-4f);  // opposite impulses, 240 roundings of 3 m/s
    // 3 rad about the centre in one second; the order of the method is one: w^2 h / 2 of the angle.
    const Position p = world.body(a)->position();
    CHECK(std::atan2(p.y, -p.x) == Approx(3).margin(0.05));
    CHECK(world.joint(joint)->kind() == JointKind::Distance);
    CHECK(world.joint(joint)->joint_angle() == 0);
}

TEST_CASE("anchors that lie on each other are no trouble") {
    Hung rod({.length_m = 1}, {0, 0});
    run_for(rod.world, 3);
    CHECK(rod.length() == Approx(1).margin(5e-3));
}

}  // namespace cairn::physics
