// Stages around the substeps: what stands and rests, in a world (base/standing.h, world/resting.h).
#pragma once

#include <span>

#include "base/standing.h"
#include "world/prepare.h"

namespace cairn::physics {

/// Stage, before the first substep and after kicks and statics are known: begins to look for what stands, and
/// tells how much of a change is rounding and what rests already.
void begin_standing(const Stillness& all, Vec2 gravity_m_s2, const StepTime& time, const ContactRules& rules,
                    StepScratch& scratch, TaskPool& tasks);

/// Marks rows that are left as they are because all of them rest.
void leave_resting(Motions& motions, std::span<const RowRange> ranges);

/// Stage, after the last substep.
void note_resting(int substeps, StepScratch& scratch);

}  // namespace cairn::physics
