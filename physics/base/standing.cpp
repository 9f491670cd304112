// Standing within a step.
#include "base/standing.h"

#include <cmath>

namespace cairn::physics {
namespace {

// Whether what contacts added to the velocity in the first substep is what forces took, but for rounding.
bool is_only_rounded(const Motions& motions, int row) {
    const VelocityRow& now = motions.velocity[row];
    const VelocityRow& without_contacts = motions.without_contacts[row];
    VelocityRow given = motions.kick[row];
    if (!motions.kept.empty()) {
        const VelocityRow& kept = motions.kept[row];
        given = {{kept.v.x * given.v.x, kept.v.y * given.v.y}, kept.w * given.w, given.inverse_mass};
    }
    const Vec2 v = (now.v - without_contacts.v) + given.v;
    const float w = (now.w - without_contacts.w) + given.w;
    return length(v) + motions.rim[row] * std::fabs(w) <= motions.rounding_m_s[row];
}

}  // namespace

Stillness note_still(Motions& motions, int first, int last) {
    Stillness found;
    for (int i = first; i < last; ++i) {
        const VelocityRow& row = motions.velocity[i];
        const bool still = is_still(motions, i);
        motions.standing[i] = still ? kMoves : kMovesAnyway;
        found.still += still ? 1 : 0;
        found.creeps |= still && row.inverse_mass == 0 && (row.v != Vec2{} || row.w != 0);
    }
    return found;
}

void begin_standing(Motions& motions, const Stillness& all) {
    if (2 * all.still < motions.size() || all.creeps) {
        motions.standing.clear();
    } else {
        motions.standing[kWorldRow] = kRests;
    }
}

Standing note_standing(Motions& motions, float h_s, int first, int last) {
    const float per_s = 1 / h_s;
    const auto has_stood = [&](int i) {
        if (motions.standing[i] != kMoves) return stands(motions.standing[i]);
        if (motions.mover[i] != MovedBy::Substeps || !is_still(motions, i)) return false;
        const PoseRow& pose = motions.pose[i];
        return is_still(per_s * pose.d, per_s * motions.rim[i] * pose.theta);
    };
    Standing found;
    for (int i = first; i < last; ++i) {
        if (motions.mover[i] == MovedBy::Flight) continue;
        if (!has_stood(i)) {
            ++found.moving;
            continue;
        }
        motions.standing[i] = kStands;
        motions.pose[i].d = {};
        motions.pose[i].theta = 0;
        if (!is_only_rounded(motions, i)) continue;
        motions.standing[i] = kRests;
        ++found.resting;
    }
    return found;
}

void stop_resting(Motions& motions, int first, int last) {
    for (int i = first; i < last; ++i) {
        if (motions.mover[i] == MovedBy::Flight || motions.standing[i] != kRests) continue;
        motions.velocity[i].v = {};
        motions.velocity[i].w = 0;
    }
}

}  // namespace cairn::physics
