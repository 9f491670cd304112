// The books that the lab keeps about a world agree with formulas, and notice what should not be.
#include "rig.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace cairn::lab {
namespace {

using physics::BodyType;
using physics::Box;
using physics::Circle;

const EngineKind kCairn = measure::cairn();

}  // namespace

TEST_CASE("the energy of bodies and springs is that of the formulas") {
    Rig rig(kCairn, {.gravity_m_s2 = {0, -10}, .enable_sleep = false});
    const BodyRef hook = rig.add_body({.type = BodyType::Static});
    const BodyRef box = rig.add(
        {.position_m = {3, 0}, .linear_velocity_m_s = {3, 4}, .angular_velocity_rad_s = 2}, Box{1, 0.5f});
    rig.spring(hook, box, {0, 0}, {3, 0}, 2.5, 1, 0);
    const double mass = 2, inertia = mass * (4 + 1) / 12, omega = 2 * std::numbers::pi;
    CHECK(rig.energy_j() ==
          Approx(0.5 * mass * 25 + 0.5 * inertia * 4 + 0.5 * mass * omega * omega * 0.5 * 0.5));
    CHECK(rig.momentum_kg_m_s().x == Approx(6));
    CHECK(rig.angular_momentum_kg_m2_s() == Approx(mass * 3 * 4 + inertia * 2));
}

TEST_CASE("what falls freely keeps its energy, and its height counts from where it began") {
    Rig rig(kCairn, {});
    const BodyRef ball = rig.add({.position_m = {0, 1000}}, Circle{{}, 0.5f});
    const double before = rig.energy_j();
    rig.run(2);
    CHECK(rig.motion(ball).vy_m_s == Approx(-20));
    // The disc turns 20^2 / 2 J for each kg of it from potential to kinetic energy.
    CHECK(std::fabs(rig.energy_j() - before) < 1e-3 * 200 * std::numbers::pi / 4);
    CHECK(rig.energy_excess() < 1e-3);
    CHECK(rig.finite());
}

TEST_CASE("energy from nowhere is found, as a share of what the scene holds") {
    Rig rig(kCairn, {.gravity_m_s2 = {0, 0}});
    const BodyRef ball = rig.add({.linear_velocity_m_s = {1, 0}}, Circle{{}, 0.5f});
    rig.run(0.5);
    CHECK(rig.energy_excess() < 1e-6);
    rig.engine().set_linear_velocity(ball, {2, 0});
    rig.run(0.5);
    CHECK(rig.energy_excess() == Approx(0.75));  // 4 in place of 1, of 4
}

TEST_CASE("work that was allowed is no excess, and new books forget what was done by hand") {
    Rig allowed(kCairn, {.gravity_m_s2 = {0, 0}});
    BodyRef ball = allowed.add({.linear_velocity_m_s = {1, 0}}, Circle{{}, 0.5f});
    allowed.step();
    allowed.allow_work(1.5 * std::numbers::pi / 4);
    allowed.engine().set_linear_velocity(ball, {2, 0});
    allowed.run(0.5);
    CHECK(allowed.energy_excess() < 1e-6);

    Rig restarted(kCairn, {.gravity_m_s2 = {0, 0}});
    ball = restarted.add({.linear_velocity_m_s = {1, 0}}, Circle{{}, 0.5f});
    restarted.step();
    restarted.engine().set_linear_velocity(ball, {2, 0});
    restarted.begin_books();
    restarted.run(0.5);
    CHECK(restarted.energy_excess() < 1e-6);
}

TEST_CASE("the joint error is the distance between the two points of a pin") {
    Rig rig(kCairn, {.gravity_m_s2 = {0, 0}});
    const BodyRef hook = rig.add_body({.type = BodyType::Static});
    const BodyRef bar = rig.add({.position_m = {1, 0}}, Box{1, 0.1f});
    rig.pin(hook, bar, {0, 0});
    CHECK(rig.joint_error_m() < 1e-7);
    rig.engine().set_transform(bar, {1.3, 0.4}, 0);
    CHECK(rig.joint_error_m() == Approx(0.5));
}

TEST_CASE("a weld is made where its bodies stand, whatever their angles") {
    Rig rig(kCairn, {.gravity_m_s2 = {0, 0}, .enable_sleep = false});
    const BodyRef wall = rig.add({.type = BodyType::Static, .angle_rad = 0.3}, Box{0.5f, 0.5f});
    const BodyRef bar = rig.add({.position_m = {1, 0}, .angle_rad = -1.1}, Box{0.5f, 0.1f});
    rig.weld(wall, bar, {0.5, 0});
    rig.run(0.5);
    CHECK(rig.motion(bar).s == Approx(std::sin(-1.1)).epsilon(1e-5));
}

TEST_CASE("digests tell worlds apart that ended alike") {
    const auto digest = [](double speed) {
        Rig rig(kCairn, {.gravity_m_s2 = {0, 0}});
        const BodyRef ball =
            rig.add({.linear_velocity_m_s = {static_cast<float>(speed), 0}}, Circle{{}, 0.5f});
        rig.run(0.5);
        rig.engine().set_transform(ball, {0, 0}, 0);
        rig.engine().set_linear_velocity(ball, {0, 0});
        return rig.digest();
    };
    CHECK(digest(1) == digest(1));
    CHECK(digest(1) != digest(2));
}

}  // namespace cairn::lab
