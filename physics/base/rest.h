// Which bodies are at rest within a step, though awake. What the first substep leaves where it is would be
// left there by the others too: its contacts push as hard as its weight pulls, to the last digits. So it
// stays where it was, and the passes of the other substeps leave out contacts between such bodies, until
// something disturbs one of them (docs/adr/021-rest.md). Invariant: what is left out would have changed no
// velocity by more than some kStillSpeed_m_s.
#pragma once

#include "base/motion.h"

namespace cairn::physics {

/// A body is still that is slower than this, and one that gets a kick of more is not at rest any more. What
/// stands trembles by a tenth of it. Ten times more, which is 1 mm in ten minutes, would be seen as creep.
inline constexpr float kStillSpeed_m_s = 2e-6f;

/// Whether it is no faster, all of it within its radius of gyration.
inline bool is_still(Vec2 v, float scaled_w, float inverse_mass) {
    return dot(v, v) + inverse_mass * scaled_w * scaled_w <= kStillSpeed_m_s * kStillSpeed_m_s;
}

/// How many rows are still, of those from first up to, and without, last.
[[nodiscard]] int count_still(const Motions& motions, int first, int last);

/// Before the first substep: rest is looked for if at least half of the rows are still.
void begin_rest(Motions& motions, int still_rows);

/// Rows that take all substeps in any case, after begin_rest: what is told of them is summed over all.
inline void keep_from_rest(Motions& motions, int row) {
    if (row != kWorldRow) motions.resting[row] = kNeverAtRest;
}

/// After the first substep, of h_s: notes who is at rest, of the rows from first up to, and without, last,
/// and puts it back to where it was. That is who was still before, is still after it and has not been moved
/// either, as what is pushed out of an overlap is; and on whom nothing but contacts in lanes acts. Kinematic
/// bodies only when they stand. The result is how many of those on whom anything acts are not at rest.
int note_rest(Motions& motions, float h_s, int first, int last);

}  // namespace cairn::physics
