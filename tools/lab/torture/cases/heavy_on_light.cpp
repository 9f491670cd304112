// Cases 1 to 4: heavy bodies on light ones. Sweeping solvers carry a load down one contact a sweep, and
// converge the slower the larger the ratio of the masses.
#include <algorithm>
#include <cmath>

#include "torture/case.h"

namespace cairn::lab {
namespace {

using physics::Box;

constexpr double kSmall_m = 1;
constexpr double kBig_m = 2;
constexpr double kDuration_s = 10;
constexpr double kStill_m_s = 0.01;

struct Criterion {
    double ratio = 1;       // of the masses
    double most_slops = 1;  // of penetration
    double settle_s = 0;    // after that time nothing moves; 0: only nothing is thrown out
};

// The big box begins `gap_m` above the small one, `aside_m` beside its middle.
void big_on_small(Trial& trial, const Criterion& criterion, const std::string& how, double gap_m,
                  double aside_m) {
    Rig& rig = trial.rig();
    rig.add_ground();
    const BodyRef small = rig.add({.position_m = {0, kSmall_m / 2}}, Box{kSmall_m / 2, kSmall_m / 2});
    const double density = criterion.ratio * kSmall_m * kSmall_m / (kBig_m * kBig_m);
    const double height_m = kSmall_m + kBig_m / 2;
    const BodyRef big = rig.add({.position_m = {aside_m, height_m + gap_m}}, Box{kBig_m / 2, kBig_m / 2},
                                {.density_kg_m2 = static_cast<float>(density)});
    double penetration = 0, last_motion_s = 0, farthest = 0;
    rig.run(kDuration_s, kStep_s, [&](double t) {
        penetration = std::max(penetration, rig.max_penetration_m());
        if (rig.max_speed_m_s() > kStill_m_s) last_motion_s = t;
        farthest = std::max({farthest, std::fabs(rig.motion(small).center_m.x),
                             std::fabs(rig.motion(big).center_m.x - aside_m)});
    });
    const double slop = slop_m(kSmall_m);
    trial.at_most(how + "_penetration_m", penetration, criterion.most_slops * slop);
    // Both contacts show in how far the upper box came down; one that went through has no contact any more.
    trial.at_most(how + "_sunk_m", height_m - rig.motion(big).center_m.y, 2 * criterion.most_slops * slop);
    trial.at_most(how + "_sideways_m", farthest, kSmall_m / 2);
    if (criterion.settle_s > 0) {
        trial.at_most(how + "_settled_after_s", last_motion_s, criterion.settle_s);
    } else {
        trial.note(how + "_settled_after_s", last_motion_s);
    }
}

void big_on_small(Trial& trial, const Criterion& criterion) {
    big_on_small(trial, criterion, "placed", 0, 0);
    big_on_small(trial, criterion, "dropped", 0.1, 0.1);
}

void alternating(Trial& trial) {
    constexpr int kBoxes = 10;
    Rig& rig = trial.rig();
    rig.add_ground();
    std::vector<BodyRef> boxes;
    for (int i = 0; i < kBoxes; ++i) {
        boxes.push_back(rig.add({.position_m = {0.02 * (i % 3), i + 0.5}}, Box{0.5f, 0.5f},
                                {.density_kg_m2 = i % 2 == 0 ? 1.0f : 100.0f}));
    }
    double penetration = 0;
    rig.run(60, kStep_s, [&](double) { penetration = std::max(penetration, rig.max_penetration_m()); });
    double sideways = 0, drop = 0;
    for (int i = 0; i < kBoxes; ++i) {
        const Motion m = rig.motion(boxes[static_cast<std::size_t>(i)]);
        sideways = std::max(sideways, std::fabs(m.center_m.x));
        drop = std::max(drop, i + 0.5 - m.center_m.y);
    }
    // It stands: no box has left the one below it, or gone into it by a tenth of its height.
    trial.at_most("sideways_m", sideways, 0.25);
    trial.at_most("drop_m", drop, 0.1 * kBoxes);
    trial.at_most("penetration_m", penetration, 0.1);
}

}  // namespace

void add_heavy_on_light(std::vector<Case>& cases) {
    cases.push_back({"1", "big box on a small one, 100 : 1", true, [](Trial& trial) {
                         big_on_small(trial, {1e2, 1, 2});
                     }});
    cases.push_back({"2", "big box on a small one, 10^4 : 1", true, [](Trial& trial) {
                         big_on_small(trial, {1e4, 2, 3});
                     }});
    cases.push_back({"3", "big box on a small one, 10^6 : 1", true, [](Trial& trial) {
                         big_on_small(trial, {1e6, 5, 0});
                     }});
    cases.push_back({"4", "10 boxes alternating 100 : 1 stand 60 s", true, alternating});
}

}  // namespace cairn::lab
