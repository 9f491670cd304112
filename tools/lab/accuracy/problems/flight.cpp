// Problems 1, 2, 14 and 15: bodies that nothing touches.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "accuracy/problem.h"

namespace cairn::lab {
namespace {

using physics::Box;
using physics::Circle;

constexpr double kGravity_m_s2 = 10;
constexpr Vec2 kNoGravity{0, 0};

// 1: y = v t - g t^2 / 2.
BodyRef throw_ball(Rig& rig) {
    return rig.add({.linear_velocity_m_s = {3, 4}}, Circle{{}, 0.5f});
}

std::vector<double> ballistic_errors(const Setting& setting) {
    const auto error_after = [&](double duration_s) {
        const auto rig = rig_of(setting);
        const BodyRef ball = throw_ball(*rig);
        rig->run(duration_s, setting.dt_s);
        const double t = setting.steps(duration_s) * static_cast<double>(setting.dt_s);
        const double fall = 0.5 * kGravity_m_s2 * t * t;
        return distance(rig->motion(ball).position_m, {3 * t, 4 * t - fall}) / fall;
    };
    return {error_after(1), error_after(10)};
}

// 2: v = v0 e^(-c t).
constexpr double kDamping_1_s = 1;

BodyRef throw_damped_ball(Rig& rig) {
    return rig.add({.linear_velocity_m_s = {4, 0}, .linear_damping_1_s = static_cast<float>(kDamping_1_s)},
                   Circle{{}, 0.5f});
}

std::vector<double> damping_errors(const Setting& setting) {
    const auto rig = rig_of(setting, kNoGravity);
    const BodyRef ball = throw_damped_ball(*rig);
    rig->run(2, setting.dt_s);
    const double t = setting.steps(2) * static_cast<double>(setting.dt_s);
    return {std::fabs(speed(rig->motion(ball)) / (4 * std::exp(-kDamping_1_s * t)) - 1)};
}

// 14: theta = w t.
BodyRef spin_bar(Rig& rig, double omega_rad_s) {
    return rig.add({.angular_velocity_rad_s = static_cast<float>(omega_rad_s)}, Box{0.5f, 0.05f});
}

std::vector<double> spin_errors(const Setting& setting) {
    double angle_error = 0, momentum_error = 0;
    for (const double omega : {1.0, 10.0, 100.0, 1000.0}) {
        const auto rig = rig_of(setting, kNoGravity);
        const BodyRef bar = spin_bar(*rig, omega);
        const double before = rig->angular_momentum_kg_m2_s();
        rig->run(10, setting.dt_s);
        const double angle = omega * setting.steps(10) * static_cast<double>(setting.dt_s);
        const Motion m = rig->motion(bar);
        const double off = wrapped(std::atan2(m.s, m.c) - angle);
        angle_error = std::max(angle_error, std::fabs(off) / angle);
        momentum_error = std::max(momentum_error, std::fabs(rig->angular_momentum_kg_m2_s() / before - 1));
    }
    return {angle_error, momentum_error};
}

// 15: an ellipse of eccentricity 1/2, from its far end; the pull is applied as a force before each step.
constexpr double kAxis_m = 5;     // half the long one
constexpr double kPeriod_s = 10;  // 2 pi sqrt(a^3 / mu)
constexpr double kEccentricity = 0.5;
constexpr double kMu =
    4 * std::numbers::pi * std::numbers::pi * kAxis_m * kAxis_m * kAxis_m / (kPeriod_s * kPeriod_s);

BodyRef add_planet(Rig& rig) {
    const double far = kAxis_m * (1 + kEccentricity);
    const double v = std::sqrt(kMu * (2 / far - 1 / kAxis_m));
    return rig.add({.position_m = {far, 0}, .linear_velocity_m_s = {0, static_cast<float>(v)}},
                   Circle{{}, 0.1f});
}

void pull(Rig& rig, BodyRef planet, double mass_kg) {
    const Position p = rig.motion(planet).position_m;
    const double r = std::hypot(p.x, p.y), k = -kMu * mass_kg / (r * r * r);
    rig.engine().apply_force(planet, {static_cast<float>(k * p.x), static_cast<float>(k * p.y)});
}

std::vector<double> kepler_errors(const Setting& setting) {
    constexpr int kOrbits = 10;
    const auto rig = rig_of(setting, kNoGravity);
    const BodyRef planet = add_planet(*rig);
    const double mass = rig->engine().mass(planet).mass_kg;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    std::array<double, 3> r{};
    double angle_before = 0, precession = 0, turned = 0;
    int far_ends = 0;
    const int steps = setting.steps(2 * kOrbits * kPeriod_s);  // orbits may grow
    for (int i = 0; i < steps && far_ends < kOrbits; ++i) {
        pull(*rig, planet, mass);
        rig->step(setting.dt_s);
        const Motion m = rig->motion(planet);
        const double radius = std::hypot(m.position_m.x, m.position_m.y);
        const double energy = 0.5 * speed(m) * speed(m) - kMu / radius;
        low = std::min(low, energy);
        high = std::max(high, energy);
        const double angle = std::atan2(m.position_m.y, m.position_m.x);
        const double step_angle = wrapped(angle - angle_before);
        turned += step_angle;
        angle_before = angle;
        r = {r[1], r[2], radius};
        if (turned > 2 * std::numbers::pi * far_ends + 3 && r[1] > r[0] && r[1] >= r[2]) {
            // The far end lies between samples: where the parabola through them is highest.
            const double bend = r[0] - 2 * r[1] + r[2], slope = 0.5 * (r[2] - r[0]);
            ++far_ends;
            precession = (turned - step_angle - slope / bend * step_angle) / far_ends - 2 * std::numbers::pi;
        }
    }
    const double exact_energy = -kMu / (2 * kAxis_m);
    const double never = std::numeric_limits<double>::quiet_NaN();
    return {far_ends == kOrbits ? std::fabs(precession) / (2 * std::numbers::pi) : never,
            (high - low) / std::fabs(exact_energy)};
}

}  // namespace

void add_flight(std::vector<Problem>& problems) {
    problems.push_back({.number = 1,
                        .name = "ballistic",
                        .metrics = {{"after_1_s", "of the fall"}, {"after_10_s", "of the fall"}},
                        .errors = ballistic_errors,
                        .timed_s = 10,
                        .timed_scene = [](Rig& rig) -> BeforeStep { return throw_ball(rig), nullptr; }});
    problems.push_back(
        {.number = 2,
         .name = "damping",
         .metrics = {{"speed", "of the speed"}},
         .errors = damping_errors,
         .timed_s = 10,
         .timed_gravity_m_s2 = kNoGravity,
         .timed_scene = [](Rig& rig) -> BeforeStep { return throw_damped_ball(rig), nullptr; }});
    problems.push_back({.number = 14,
                        .name = "free_spin",
                        .metrics = {{"angle", "of the angle"}, {"momentum", "of the momentum"}},
                        .errors = spin_errors,
                        .timed_s = 10,
                        .timed_gravity_m_s2 = kNoGravity,
                        .timed_scene = [](Rig& rig) -> BeforeStep { return spin_bar(rig, 100), nullptr; }});
    problems.push_back({.number = 15,
                        .name = "kepler",
                        .metrics = {{"precession", "turns per orbit"}, {"energy_band", "of the energy"}},
                        .errors = kepler_errors,
                        .timed_s = kPeriod_s,
                        .timed_gravity_m_s2 = kNoGravity,
                        .timed_scene = [](Rig& rig) -> BeforeStep {
                            const BodyRef planet = add_planet(rig);
                            const double mass = rig.engine().mass(planet).mass_kg;
                            return [planet, mass](Rig& each) { pull(each, planet, mass); };
                        }});
}

}  // namespace cairn::lab
