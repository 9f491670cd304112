// Rest within a step.
#include "base/rest.h"

#include "base/ample.h"

namespace cairn::physics {
namespace {

// Before the first substep, and damped: the velocity without contacts, less the kick.
VelocityRow before_first_substep(const Motions& motions, int i) {
    VelocityRow row = motions.without_contacts[i];
    const VelocityRow& kick = motions.kick[i];
    const VelocityRow kept = motions.kept.empty() ? VelocityRow{{1, 1}, 1, 1} : motions.kept[i];
    row.v.x -= kept.v.x * kick.v.x;
    row.v.y -= kept.v.y * kick.v.y;
    row.w -= kept.w * kick.w;
    return row;
}

bool is_still(const VelocityRow& row) {
    return is_still(row.v, row.w, row.inverse_mass);
}

}  // namespace

int count_still(const Motions& motions, int first, int last) {
    int still = 0;
    for (int i = first; i < last; ++i) still += is_still(motions.velocity[i]) ? 1 : 0;
    return still;
}

void begin_rest(Motions& motions, int still_rows) {
    if (2 * still_rows < motions.size()) {
        motions.resting.clear();
        return;
    }
    assign_amply(motions.resting, static_cast<std::size_t>(motions.size()), kNotAtRest);
    motions.resting[kWorldRow] = kAtRest;
}

int note_rest(Motions& motions, float h_s, int first, int last) {
    const float per_s = 1 / h_s;
    const auto rests = [&](int i) {
        if (motions.resting[i] != kNotAtRest) return motions.resting[i] == kAtRest;
        if (motions.mover[i] != Mover::Substeps) return false;
        const VelocityRow& now = motions.velocity[i];
        const PoseRow& pose = motions.pose[i];
        // What moves as it likes does so however slowly.
        if (now.inverse_mass == 0) return now.v == Vec2{} && now.w == 0;
        return is_still(now) && is_still(per_s * pose.d, per_s * pose.theta, now.inverse_mass) &&
               is_still(before_first_substep(motions, i));
    };
    int not_at_rest = 0;
    for (int i = first; i < last; ++i) {
        if (motions.mover[i] == Mover::Flight) continue;
        if (!rests(i)) {
            ++not_at_rest;
            continue;
        }
        motions.resting[i] = kAtRest;
        motions.pose[i].d = {};
        motions.pose[i].theta = 0;
    }
    return not_at_rest;
}

}  // namespace cairn::physics
