// Case 16: springs far stiffer than a step can resolve. A spring of w rad/s sags by g / w^2 under its load.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "torture/case.h"

namespace cairn::lab {
namespace {

using physics::BodyType;
using physics::Circle;

constexpr double kRest_m = 1;
constexpr double kPull_m = 0.1;  // how far it is stretched at first
constexpr double kGravity_m_s2 = 10;

// The largest distance from rest, and where the load hangs in the mean over the second half.
struct Swing {
    double farthest_m = 0;
    double mean_sag_m = 0;
};

Swing swing(Trial& trial, double frequency_hz, float damping_ratio, double pull_m) {
    Rig& rig = trial.rig({.enable_sleep = false});
    const BodyRef hook = rig.add_body({.type = BodyType::Static});
    const BodyRef load = rig.add({.position_m = {0, -kRest_m - pull_m}}, Circle{{}, 0.5f});
    rig.spring(hook, load, {0, 0}, {0, -kRest_m - pull_m}, kRest_m, static_cast<float>(frequency_hz),
               damping_ratio);
    Swing found;
    int samples = 0;
    rig.run(10, kStep_s, [&](double t) {
        const double sag = -kRest_m - rig.motion(load).position_m.y;
        if (!(std::fabs(sag) <= found.farthest_m)) found.farthest_m = std::fabs(sag);
        if (t > 5) {
            found.mean_sag_m += sag;
            ++samples;
        }
    });
    found.mean_sag_m /= samples;
    return found;
}

void stiff_springs(Trial& trial) {
    const double nyquist_hz = 0.5 / static_cast<double>(kStep_s);
    double farthest = 0, worst_sag = 0;
    for (const double times : {1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0}) {
        const double frequency_hz = times * nyquist_hz;
        const double omega = 2 * std::numbers::pi * frequency_hz;
        const double sag = kGravity_m_s2 / (omega * omega);
        for (const float damping_ratio : {0.0f, 0.1f, 1.0f}) {
            farthest = std::max(farthest, swing(trial, frequency_hz, damping_ratio, kPull_m).farthest_m);
        }
        // At rest the damping does nothing: the sag is that of any damping.
        const double error = std::fabs(swing(trial, frequency_hz, 1, 0).mean_sag_m - sag);
        worst_sag = std::max(worst_sag, error / std::max(0.02 * sag, 1e-6));
    }
    // Bounded: gravity adds to what the pull gave, less than a tenth of it at the lowest frequency.
    trial.at_most("swing_m", farthest, 1.1 * kPull_m);
    trial.at_most("sag_error_of_allowed", worst_sag, 1);  // max(2 %, 1 um)
}

}  // namespace

void add_springs(std::vector<Case>& cases) {
    cases.push_back({"16", "springs of 1 to 1,000 times the Nyquist frequency", true, stiff_springs});
}

}  // namespace cairn::lab
