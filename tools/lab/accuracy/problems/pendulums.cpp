// Problems 7 and 8: one pendulum, whose period is an elliptic integral, and bars hung from each other,
// against an integration in double.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "accuracy/problem.h"
#include "reference/pendulum.h"

namespace cairn::lab {
namespace {

using physics::BodyType;
using physics::Box;
using physics::Circle;
using physics::ShapeDef;

constexpr double kGravity_m_s2 = 10;
constexpr double kLength_m = 1;
constexpr double kRadius_m = 0.1;
constexpr double kQuarter = std::numbers::pi / 2;
const ShapeDef kMeetsNothing{.filter = {.categories = 2, .mask = 0}};

// A disc, level with its pin: 90 degrees from hanging down.
BodyRef add_pendulum(Rig& rig) {
    const BodyRef hook = rig.add_body({.type = BodyType::Static});
    const BodyRef bob =
        rig.add({.position_m = {kLength_m, 0}}, Circle{{}, static_cast<float>(kRadius_m)}, kMeetsNothing);
    rig.pin(hook, bob, {0, 0});
    return bob;
}

// Angle from hanging down.
double angle_of(const Motion& m) {
    return std::atan2(m.position_m.x, -m.position_m.y);
}

std::vector<double> pendulum_errors(const Setting& setting) {
    const auto rig = rig_of(setting);
    const BodyRef bob = add_pendulum(*rig);
    const double inertia_m2 = kRadius_m * kRadius_m / 2;  // about its centre, per kg
    const double reduced_m = kLength_m + inertia_m2 / kLength_m;
    double first_s = -1, last_s = -1, before = angle_of(rig->motion(bob)), joint_error = 0, energy_error = 0;
    int crossings = 0;
    const int steps = setting.steps(60);
    for (int i = 1; i <= steps; ++i) {
        rig->step(setting.dt_s);
        const Motion m = rig->motion(bob);
        const double angle = angle_of(m);
        if (before > 0 && angle <= 0) {
            last_s = (i - angle / (angle - before)) * static_cast<double>(setting.dt_s);
            if (first_s < 0) {
                first_s = last_s;
            } else {
                ++crossings;
            }
        }
        before = angle;
        joint_error = std::max(joint_error, rig->joint_error_m() / kLength_m);
        const double w = m.angular_velocity_rad_s;
        const double energy =
            0.5 * (speed(m) * speed(m) + inertia_m2 * w * w) + kGravity_m_s2 * m.position_m.y;
        energy_error = std::max(energy_error, std::fabs(energy) / (kGravity_m_s2 * kLength_m));
    }
    const double exact = reference::pendulum_period_s(reduced_m, kGravity_m_s2, kQuarter);
    return {crossings > 0 ? std::fabs((last_s - first_s) / crossings / exact - 1)
                          : std::numeric_limits<double>::quiet_NaN(),
            energy_error, joint_error};
}

constexpr double kBar_m = 1;
constexpr double kBarWidth_m = 0.1;

std::vector<BodyRef> add_bars(Rig& rig, int count) {
    std::vector<BodyRef> bars;
    BodyRef last = rig.add_body({.type = BodyType::Static});
    for (int i = 0; i < count; ++i) {
        const BodyRef bar =
            rig.add({.position_m = {kBar_m * (i + 0.5), 0}},
                    Box{static_cast<float>(kBar_m / 2), static_cast<float>(kBarWidth_m / 2)}, kMeetsNothing);
        rig.pin(last, bar, {kBar_m * i, 0});
        bars.push_back(bar);
        last = bar;
    }
    return bars;
}

std::vector<double> hung_bars_errors(const Setting& setting, int count) {
    const auto rig = rig_of(setting);
    const std::vector<BodyRef> bars = add_bars(*rig, count);
    reference::HungBars exact;
    exact.count = count;
    exact.inertia_kg_m2 = (kBar_m * kBar_m + kBarWidth_m * kBarWidth_m) / 12;
    exact.gravity_m_s2 = kGravity_m_s2;
    reference::State state(2 * static_cast<std::size_t>(count));
    std::fill(state.begin(), state.begin() + count, kQuarter);
    const auto f = [&](double, const reference::State& y) { return exact.derivative(y); };
    constexpr int kSamples = 20;
    double worst = 0, t = 0;
    const int steps = setting.steps(2.0 / kSamples);
    for (int sample = 0; sample < kSamples; ++sample) {
        for (int i = 0; i < steps; ++i) rig->step(setting.dt_s);
        const double next = t + steps * static_cast<double>(setting.dt_s);
        state = reference::integrate(f, std::move(state), t, next);
        t = next;
        const std::vector<Position> places = exact.centers(state);
        for (std::size_t i = 0; i < bars.size(); ++i) {
            const double off = distance(rig->motion(bars[i]).center_m, places[i]) / (count * kBar_m);
            if (!(off <= worst)) worst = off;
        }
    }
    return {worst};
}

void add_hung_bars(std::vector<Problem>& problems, const std::string& name, int count) {
    problems.push_back(
        {.number = 8,
         .name = name,
         .metrics = {{"position", "of the whole length"}},
         .errors = [count](const Setting& setting) { return hung_bars_errors(setting, count); },
         .timed_s = 2,
         .timed_scene = [count](Rig& rig) -> BeforeStep { return add_bars(rig, count), nullptr; }});
}

}  // namespace

void add_pendulums(std::vector<Problem>& problems) {
    problems.push_back(
        {.number = 7,
         .name = "pendulum",
         .metrics = {{"period", "of the period"}, {"energy", "of m g L"}, {"joint", "of the length"}},
         .errors = pendulum_errors,
         .timed_s = 10,
         .timed_scene = [](Rig& rig) -> BeforeStep { return add_pendulum(rig), nullptr; }});
    add_hung_bars(problems, "double_pendulum", 2);
    add_hung_bars(problems, "five_pendulum", 5);
}

}  // namespace cairn::lab
