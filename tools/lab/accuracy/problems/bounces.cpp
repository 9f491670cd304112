// Problem 3: a ball bounces; h_n = e^(2n) h_0.
#include <algorithm>
#include <array>
#include <cmath>

#include "accuracy/problem.h"

namespace cairn::lab {
namespace {

using physics::Circle;
using physics::ShapeDef;

constexpr double kRadius_m = 0.1;

BodyRef drop_ball(Rig& rig, double height_m, double restitution) {
    const ShapeDef rubber{.material = {.friction = 0, .restitution = static_cast<float>(restitution)}};
    rig.add_ground(0, rubber);
    return rig.add({.position_m = {0, height_m + kRadius_m}}, Circle{{}, static_cast<float>(kRadius_m)},
                   rubber);
}

// Of the first `count` bounces, from the samples around each top.
std::vector<double> heights(const Setting& setting, double height_m, double restitution, std::size_t count,
                            double most_s) {
    const auto rig = rig_of(setting);
    const BodyRef ball = drop_ball(*rig, height_m, restitution);
    std::vector<double> found;
    std::array<double, 3> y{height_m, height_m, height_m};
    bool rising = false;
    const int steps = setting.steps(most_s);
    for (int i = 0; i < steps && found.size() < count; ++i) {
        rig->step(setting.dt_s);
        y = {y[1], y[2], rig->motion(ball).position_m.y - kRadius_m};
        if (y[2] > y[1]) {
            rising = true;
        } else if (rising) {
            found.push_back(apex(y[0], y[1], y[2]));
            rising = false;
        }
    }
    return found;
}

std::vector<double> bounce_errors(const Setting& setting) {
    constexpr double kHeight_m = 2, kRestitution = 0.8;
    const double never = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> five = heights(setting, kHeight_m, kRestitution, 5, 20);
    double height_error = five.size() == 5 ? 0 : never;
    for (std::size_t n = 0; n < five.size(); ++n) {
        const double exact = kHeight_m * std::pow(kRestitution, 2.0 * static_cast<double>(n + 1));
        height_error = std::max(height_error, std::fabs(five[n] / exact - 1));
    }
    if (five.size() < 5) height_error = never;
    const std::vector<double> hundred = heights(setting, 1, 1, 100, 200);
    return {height_error, hundred.size() == 100 ? std::fabs(hundred.back() - 1) : never};
}

}  // namespace

void add_bounces(std::vector<Problem>& problems) {
    problems.push_back({.number = 3,
                        .name = "bounce",
                        .metrics = {{"heights", "of each height"}, {"energy_100", "of the energy"}},
                        .errors = bounce_errors,
                        .timed_s = 10,
                        .timed_scene = [](Rig& rig) -> BeforeStep { return drop_ball(rig, 1, 1), nullptr; }});
}

}  // namespace cairn::lab
