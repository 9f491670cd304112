// Cases 23, 25, 37 and 38: bullets, spins, gravity beyond measure and none, and balls that never cease to
// bounce.
#include <algorithm>
#include <array>
#include <cmath>

#include "torture/case.h"

namespace cairn::lab {
namespace {

using physics::BodyType;
using physics::Box;
using physics::Circle;
using physics::ShapeDef;

void bullets(Trial& trial) {
    constexpr int kPhases = 1000;
    constexpr double kSpeed_m_s = 1e4, kWall_m = 0.01, kRadius_m = 0.01;
    int misses = 0;
    for (int i = 0; i < kPhases; ++i) {
        Rig& rig = trial.rig({.gravity_m_s2 = {0, 0}});
        rig.add({.type = BodyType::Static, .position_m = {kWall_m / 2, 0}},
                Box{static_cast<float>(kWall_m / 2), 10});
        // Somewhere within the way of one step before the wall, a whole step further away.
        const double way = kSpeed_m_s * static_cast<double>(kStep_s);
        const BodyRef bullet = rig.add({.position_m = {-way * (1 + (i + 0.5) / kPhases), 0},
                                        .linear_velocity_m_s = {static_cast<float>(kSpeed_m_s), 0}},
                                       Circle{{}, static_cast<float>(kRadius_m)});
        rig.run(6.0 / 60);
        if (!(rig.motion(bullet).position_m.x < kWall_m / 2)) ++misses;
    }
    trial.at_most("misses_of_1000", misses, 0);
}

void spinning_bar(Trial& trial) {
    constexpr float kSpin_rad_s = 1e3f;
    const auto drift_of = [](Rig& rig, double duration_s) {
        const double before = rig.angular_momentum_kg_m2_s();
        double worst = 0;
        rig.run(duration_s, kStep_s, [&](double) {
            worst = std::max(worst, std::fabs(rig.angular_momentum_kg_m2_s() / before - 1));
        });
        return worst;
    };
    Rig& free = trial.rig({.gravity_m_s2 = {0, 0}, .enable_sleep = false});
    free.add({.angular_velocity_rad_s = kSpin_rad_s}, Box{0.5f, 0.05f});
    trial.at_most("free_drift", drift_of(free, 10), 0.001);

    Rig& hitting = trial.rig({.gravity_m_s2 = {0, 0}, .enable_sleep = false});
    hitting.add({.angular_velocity_rad_s = kSpin_rad_s}, Box{0.5f, 0.05f});
    const BodyRef other =
        hitting.add({.position_m = {0.3, 1.5}, .linear_velocity_m_s = {0, -2}}, Box{0.5f, 0.05f});
    trial.at_most("hitting_drift", drift_of(hitting, 2), 0.001);
    trial.at_least("other_speed_m_s", speed(hitting.motion(other)), 2.01);  // it was hit
}

void heavy_and_no_gravity(Trial& trial) {
    Rig& heavy = trial.rig({.gravity_m_s2 = {0, -1e4f}});
    heavy.add_ground();
    for (int i = 0; i < 5; ++i) heavy.add({.position_m = {0, i + 0.5}}, Box{0.5f, 0.5f});
    double penetration = 0;
    heavy.run(10, kStep_s, [&](double) { penetration = std::max(penetration, heavy.max_penetration_m()); });
    trial.at_most("penetration_m", penetration, 5 * slop_m(1));

    Rig& none = trial.rig({.gravity_m_s2 = {0, 0}, .enable_sleep = false});
    const std::array velocities{Vec2{1, 0.3f}, Vec2{-0.7f, 0.11f}, Vec2{0.001f, -2}};
    for (std::size_t i = 0; i < velocities.size(); ++i) {
        none.add({.position_m = {10000.0 * static_cast<double>(i), 0},
                  .linear_velocity_m_s = velocities[i],
                  .angular_velocity_rad_s = 3},
                 Box{0.5f, 0.25f});
    }
    const Vec2 before = none.momentum_kg_m_s();
    none.run(3600);
    const Vec2 after = none.momentum_kg_m_s();
    trial.at_most("momentum_drift", static_cast<double>(length(after - before) / length(before)), 1e-6);
}

void endless_bounces(Trial& trial) {
    constexpr double kHeight_m = 0.25;
    constexpr double kBounces = 1e5;
    const ShapeDef elastic{.material = {.friction = 0, .restitution = 1}};
    Rig& rig = trial.rig({.enable_sleep = false});
    rig.add_ground(0, elastic);
    const double radius_m = 0.1;
    const BodyRef ball =
        rig.add({.position_m = {0, kHeight_m + radius_m}}, Circle{{}, static_cast<float>(radius_m)}, elastic);
    const double period_s = 2 * std::sqrt(2 * kHeight_m / 10);
    int bounces = 0;
    double vy = 0;
    const auto energy_per_kg = [&] {
        const Motion m = rig.motion(ball);
        return 10 * (m.position_m.y - radius_m) + 0.5 * m.vy_m_s * m.vy_m_s;
    };
    rig.run(kBounces * period_s, kStep_s, [&](double) {
        const double now = rig.motion(ball).vy_m_s;
        if (vy < 0 && now > 0) ++bounces;
        vy = now;
    });
    trial.at_most("energy_error", std::fabs(energy_per_kg() / (10 * kHeight_m) - 1), 0.01);
    trial.at_most("bounces_error", std::fabs(bounces / kBounces - 1), 0.01);
    if (!trial.is_cairn()) return;
    Rig& other = trial.rig();
    const BodyRef body = other.add_body({});
    trial.require("restitution_of_1.5_is_an_error",
                  !other.engine().cairn_world()->create_shape(physics::BodyId::from_bits(body.bits), Circle{},
                                                              {.material = {.restitution = 1.5f}}));
}

}  // namespace

void add_fast_motion(std::vector<Case>& cases) {
    cases.push_back({"23", "bullet of 10^4 m/s against a wall of 1 cm, 1,000 phases", true, bullets});
    cases.push_back({"25", "bar at 10^3 rad/s, free and hitting another", true, spinning_bar});
    cases.push_back({"37", "gravity of 10^4 m/s2; none for an hour", true, heavy_and_no_gravity});
    cases.push_back({"38", "10^5 elastic bounces; a restitution of 1.5", true, endless_bounces});
}

}  // namespace cairn::lab
