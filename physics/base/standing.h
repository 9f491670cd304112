// Which bodies stand within a step, though awake. What the first substep leaves where it is would be left
// there by the others too: its contacts push as hard as its weight pulls, to the last digits. So it stays
// where it was, and the passes of the other substeps leave out contacts between such bodies, until something
// disturbs one of them (docs/adr/021-rest.md). Invariant: whether a contact is left out depends on its two
// bodies alone.
// What stands rests if the first substep did nothing to its velocity but to round it. It is stopped
// altogether, and contacts between such bodies take back the impulses that they had, so that a step leaves
// all of it to the bit as it was.
#pragma once

#include "base/motion.h"

namespace cairn::physics {

/// A body is still while no point of it is faster than this, and one that a contact gives more than this
/// within a pass does not stand any more. A pyramid of a hundred layers settles by up to 3 um/s for a second,
/// in the last digits of what its lowest contacts bear, and trembles by a tenth of that later. It is 2.4 mm
/// in ten minutes: motion this slow is stopped where something is touched, and what speeds a body up acts
/// once a step until it is faster.
inline constexpr float kStillSpeed_m_s = 4e-6f;

inline bool is_still(Vec2 v, float rim_m_s) {
    return dot(v, v) + rim_m_s * rim_m_s <= kStillSpeed_m_s * kStillSpeed_m_s;
}
/// Of a row as it is now.
inline bool is_still(const Motions& motions, int i) {
    return is_still(motions.velocity[i].v, motions.rim[i] * motions.velocity[i].w);
}

/// What rows are like when a step begins.
struct Stillness {
    int still = 0;        // rows
    bool creeps = false;  // a body of infinite mass is still, but moves: what it carries must go with it
};

/// Before the first substep, of rows from first up to, and without, last: notes which are still.
Stillness note_still(Motions& motions, int first, int last);

/// After that, for all rows: what stands is looked for where at least half of the rows are still and none
/// creeps; otherwise `standing` is empty.
void begin_standing(Motions& motions, const Stillness& all);

/// Rows that take all substeps in any case: what is told of them is summed over all.
inline void keep_moving(Motions& motions, int row) {
    if (row != kWorldRow) motions.standing[row] = kMovesAnyway;
}

/// Of rows on which anything acts: how many do not stand, and how many rest.
struct Standing {
    int moving = 0;
    int resting = 0;
};

/// After the first substep, of h_s: notes who stands, of the rows from first up to, and without, last, and
/// puts it back to where it was. That is who was still before, is still after it and has not been moved
/// either, as what is pushed out of an overlap is; and on whom nothing but contacts in lanes acts. Bodies of
/// infinite mass only when they do not move at all.
Standing note_standing(Motions& motions, float h_s, int first, int last);
/// When it is known which of them rest.
void stop_resting(Motions& motions, int first, int last);

}  // namespace cairn::physics
