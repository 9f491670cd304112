// Cases 43 and 44: what sleeps wakes when something falls on it, and when what it stands on goes.
#include <algorithm>
#include <optional>

#include <cairn/physics/tuning.h>

#include "torture/case.h"

namespace cairn::lab {
namespace {

using physics::Box;

// A row of boxes that sleep; a slab of 10^6 kg falls 1 m onto them.
void heavy_landing(Trial& trial) {
    Rig& rig = trial.rig();
    rig.add_ground();
    std::vector<BodyRef> row;
    for (int i = 0; i < 5; ++i) row.push_back(rig.add({.position_m = {1.5 * i - 3, 0.5}}, Box{0.5f, 0.5f}));
    rig.run(2);
    trial.require("they_slept", rig.all_asleep());
    const BodyRef slab = rig.add({.position_m = {0, 2.5}}, Box{4, 0.5f}, {.density_kg_m2 = 1e6f / 4});
    rig.begin_books();
    bool woke_on_contact = true;
    std::optional<double> touched_s;
    double highest_m = 0, penetration = 0;
    rig.run(10, kStep_s, [&](double t) {
        // Touching: a gap that the solver cannot close any more within the step.
        const double gap = rig.motion(slab).position_m.y - 0.5 - 1;
        if (gap <= 0 && !touched_s) touched_s = t;
        // From then on, until they may sleep again.
        const bool must_be_awake =
            touched_s && t - *touched_s < physics::tuning::kTimeToSleep_s - kStep_s / 2;
        for (const BodyRef box : row) {
            if (must_be_awake && !rig.motion(box).awake) woke_on_contact = false;
        }
        penetration = std::max(penetration, rig.max_penetration_m());
        highest_m = std::max(highest_m, rig.motion(slab).position_m.y);
    });
    double sunk = 0;
    for (const BodyRef box : row) sunk = std::max(sunk, 0.5 - rig.motion(box).position_m.y);
    trial.require("woke_on_contact", touched_s && woke_on_contact);
    trial.at_most("sunk_m", sunk, slop_m(1));
    trial.at_most("slab_sunk_m", 1.5 - rig.motion(slab).position_m.y, 2 * slop_m(1));
    trial.at_most("slab_rose_to_m", highest_m, 2.5 + slop_m(1));
    trial.note("deepest_m", penetration);
}

void support_removed(Trial& trial) {
    Rig& rig = trial.rig();
    rig.add_ground();
    std::vector<BodyRef> boxes;
    for (int i = 0; i < 5; ++i) boxes.push_back(rig.add({.position_m = {0, i + 0.5}}, Box{0.5f, 0.5f}));
    rig.run(3);
    trial.require("they_slept", rig.all_asleep());
    rig.remove(boxes.front());
    rig.begin_books();
    rig.step();
    int awake = 0;
    double slowest = 1e9;
    for (std::size_t i = 1; i < boxes.size(); ++i) {
        awake += rig.motion(boxes[i]).awake ? 1 : 0;
        slowest = std::min(slowest, -rig.motion(boxes[i]).vy_m_s);
    }
    trial.at_least("awake_after_one_step", awake, 4);
    trial.at_least("falling_at_m_s", slowest, 0.5 * 10 / 60);
    rig.run(5);
    trial.at_most("landed_at_m", rig.motion(boxes[1]).position_m.y, 0.5 + slop_m(1));
}

}  // namespace

void add_sleepers(std::vector<Case>& cases) {
    cases.push_back({"43", "10^6 kg land on sleepers", true, heavy_landing});
    cases.push_back({"44", "support of a sleeping stack is removed", true, support_removed});
}

}  // namespace cairn::lab
