// Bodies that move so far in a step that they could pass through others. Their way is looked at before the
// step: boxes cover it, and a pair that will meet gets its contact from the place where it meets. The solver
// then stops them there, in the substep in which it happens, against static, kinematic and dynamic bodies
// alike. What passes all the same is put back by fast_guard.h.
// Hasty bodies are slower, but would be deep in others before a contact is made. Their contacts come ahead,
// too, and nobody needs to guard them. Slower bodies that could reach something that sleeps before the solver
// sees it have their way covered too, so that the sleeper wakes in the step in which it is reached.
#pragma once

#include <cairn/physics/tuning.h>

#include "continuous/sweep.h"
#include "world/world_state.h"

namespace cairn::physics {

/// Of what is solid about the thinnest shape: moving further than this in a step is fast.
inline constexpr float kFastShare = 0.5f;

/// m. What would be deeper in another shape than this, before its contact acts, gets its contact ahead.
inline constexpr float kSurprise_m = 2 * tuning::kLinearSlop_m;

/// Moving further than this in a step is hasty: contacts see the rest.
inline constexpr float kCalmWay_m = tuning::kSpeculativeDistance_m + kSurprise_m;

/// Stage: the boxes of fast bodies, and of those that rouse sleepers, cover the way of the coming step. The
/// fast bodies are noted in `fast`, and what all awake ones are expected to do in `advances`.
void cover_fast_ways(Stores& stores, Vec2 gravity_m_s2, float dt_s, StepScratch& scratch, TaskPool& tasks);

/// The same for rows that came since, of bodies that woke.
void extend_advances(Stores& stores, Vec2 gravity_m_s2, float dt_s, StepScratch& scratch);

/// Whether two bodies could meet within the step, or pass through each other, as far as that can be told
/// without their shapes.
bool could_meet(const Advance& a, const Advance& b, const AxisGap& seen, float dt_s);

/// Whether one of two that are about to touch, with this normal, goes over a corner of the other: it stays
/// before a side for the whole step, and what is about to touch is the end of that side. On the next floor,
/// flush with this one, it would be met as if that stood in its way.
bool goes_over_corner(const Stores& stores, const ContactRecord& contact, Vec2 gravity_m_s2, Vec2 normal,
                      float dt_s);

/// The contact of a pair that is apart now but meets within the step, as seen from now; false when it does
/// not.
bool predict_contact(const Stores& stores, const ContactRecord& contact, const AxisGap& seen,
                     Vec2 gravity_m_s2, float dt_s, ContactInput& input);

}  // namespace cairn::physics
