// Stages after the substeps: what was lost to infinity is halted; bodies take their new places, boxes follow,
// rest times are kept.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

/// Bodies whose motion became infinite or NaN, or led beyond kFarthest_m, are where they were, stand, and are
/// noted in `quarantined`. For all stages from here on: events tell of places, and there is none at infinity.
void halt_lost_bodies(const BodyStore& bodies, StepScratch& scratch, std::vector<BodyId>& quarantined,
                      TaskPool& tasks);

/// Stage: contacts and joints of what was halted forget what they gave to it, which may be no number.
void forget_halted(Stores& stores, std::span<const BodyId> halted);

/// Stage: bodies take their new places. Those that were hurled so far that they could have passed through
/// others, though nobody expected it, join the fast ones.
void finalize_bodies(Stores& stores, StepScratch& scratch, float dt_s, bool sleep_enabled, TaskPool& tasks);

/// The box of a shape in the broad phase.
void set_fat_box(Stores& stores, int shape, const Aabb& box);

/// The same for boxes that were written already, by threads: they become known.
void tell_fat_box(Stores& stores, int shape);
/// scratch.untold_boxes. Those of bodies that have a way (place_flag::kHasWay) go along it for so long; 0:
/// none does.
void tell_fat_boxes(Stores& stores, StepScratch& scratch, float way_s, TaskPool& tasks);

/// How far the inner box may move in any direction without leaving the outer one.
float clearance(const Aabb& outer, const Aabb& inner);

/// Brings the boxes of a body's shapes up to its place; boxes that the shape has left are made anew.
void update_boxes(Stores& stores, int body);
/// Makes all of them anew, for boxes that have become too large. On several threads, each with bodies of its
/// own: shapes whose boxes are yet to be told are appended.
void renew_boxes(Stores& stores, int body, std::vector<int>& untold);

}  // namespace cairn::physics
