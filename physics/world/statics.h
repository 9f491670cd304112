// What each contact would bear if everything stood still: an estimate, made once per step from the top down.
// A soft contact gives way under load by F/(m w^2); about a statics estimate it gives way only under what the
// estimate misses, so stacks neither sink nor buckle under their own weight.
#pragma once

#include "world/prepare.h"

namespace cairn::physics {

/// Stage: sets `static_impulse` of the points of all contacts of this step, N s per substep; 0 where nothing
/// can be said.
void estimate_statics(Stores& stores, Vec2 gravity_m_s2, const StepTime& time, StepScratch& scratch,
                      TaskPool& tasks);

}  // namespace cairn::physics
