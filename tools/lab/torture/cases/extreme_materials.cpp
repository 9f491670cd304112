// Case 39: friction of 0 and of 10^6.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "torture/case.h"

namespace cairn::lab {
namespace {

using physics::BodyType;
using physics::Box;
using physics::ShapeDef;

void no_friction(Trial& trial) {
    const ShapeDef ice{.material = {.friction = 0}};
    Rig& rig = trial.rig({.enable_sleep = false});
    rig.add_ground(0, ice);
    const BodyRef resting = rig.add({.position_m = {0, 0.5}}, Box{0.5f, 0.5f}, ice);
    const BodyRef sliding =
        rig.add({.position_m = {5, 0.5}, .linear_velocity_m_s = {1, 0}}, Box{0.5f, 0.5f}, ice);
    rig.run(10);
    trial.at_most("resting_drift_m", std::fabs(rig.motion(resting).position_m.x), 1e-4);
    trial.at_most("sliding_error_m", std::fabs(rig.motion(sliding).position_m.x - 15), 1e-3);
    trial.at_most("sliding_turned_rad", std::fabs(rig.motion(sliding).s), 1e-3);
}

// On a slope of 45 degrees.
void all_friction(Trial& trial) {
    const ShapeDef glue{.material = {.friction = 1e6f}};
    const double tilt = 0.25 * std::numbers::pi;
    Rig& rig = trial.rig({.enable_sleep = false});
    rig.add({.type = BodyType::Static, .angle_rad = tilt}, Box{20, 0.5f}, glue);
    // Twice as long as high, so that it cannot tip over its lower edge.
    const Position start{-std::sin(tilt), std::cos(tilt)};
    const BodyRef box = rig.add({.position_m = start, .angle_rad = tilt}, Box{1, 0.5f}, glue);
    double fastest = 0;
    rig.run(10, kStep_s, [&](double t) {
        if (t > 1) fastest = std::max(fastest, speed(rig.motion(box)));
    });
    trial.at_most("stuck_drift_m", distance(rig.motion(box).position_m, start), 1e-3);
    trial.at_most("jitter_m_s", fastest, 1e-3);
}

}  // namespace

void add_extreme_materials(std::vector<Case>& cases) {
    cases.push_back({"39", "friction of 0 and of 10^6", true, [](Trial& trial) {
                         no_friction(trial);
                         all_friction(trial);
                     }});
}

}  // namespace cairn::lab
