// Standing within a step.
#include "base/standing.h"

namespace cairn::physics {

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
        motions.standing[kWorldRow] = kStands;
    }
}

int note_standing(Motions& motions, float h_s, int first, int last) {
    const float per_s = 1 / h_s;
    const auto stands = [&](int i) {
        if (motions.standing[i] != kMoves) return motions.standing[i] == kStands;
        if (motions.mover[i] != MovedBy::Substeps || !is_still(motions, i)) return false;
        const PoseRow& pose = motions.pose[i];
        return is_still(per_s * pose.d, per_s * motions.rim[i] * pose.theta);
    };
    int moving = 0;
    for (int i = first; i < last; ++i) {
        if (motions.mover[i] == MovedBy::Flight) continue;
        if (!stands(i)) {
            ++moving;
            continue;
        }
        motions.standing[i] = kStands;
        motions.pose[i].d = {};
        motions.pose[i].theta = 0;
    }
    return moving;
}

}  // namespace cairn::physics
