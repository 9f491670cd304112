// What swept over another body all the same is turned back. The guard of fast bodies follows the centres of
// shapes; the centre of a rod passes nothing while its arms go through what stands beside it.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

/// Stage at the end of the step: a long body that turned far, and of which a shape got over the middle of
/// another one, or another one over the middle of it, is put back to where the two met. It keeps its
/// velocity, so that the next step sees them meet. Not where a joint holds it to something that moves.
void hold_sweeping_bodies(Stores& stores, StepScratch& scratch);

/// Whether a joint holds a body to something that moves: put back or moved on it would be torn off that, and
/// drawn through others by its joint.
bool hangs_on_what_moves(const Stores& stores, int body);

/// Whether a kinematic body that sweeps, or is fast, carries the other, which is dynamic, with it: by two
/// shapes of theirs.
bool is_carried(const Stores& stores, int shape, int paddle_shape);

/// Stage before it: what a kinematic body swept over, which nothing turns back, is carried in front of it. It
/// keeps its velocity, too. Not what a joint holds to something that moves either.
void carry_swept_bodies(Stores& stores, StepScratch& scratch);

}  // namespace cairn::physics
