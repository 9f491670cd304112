// Bodies that met something within the step and were turned aside there. A corner that hits off the centre
// leaves a body half of its speed and makes it spin; on what is left of the step it flies on through what it
// met, and past the end of that, as a short wall, it has often drifted too far aside for the straight way
// from the start of the step to its end to tell. So such ways are followed in two pieces.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

/// Notes where the bodies of a predicted contact are expected to be when they meet.
void expect_bends(const Stores& stores, const ContactInput& input, float dt_s, StepScratch& scratch);

/// Stage after hold_fast_bodies: what went on through something after it had met that, or something else, is
/// put back to the side on which it was. It keeps its velocity, so that the next step sees them meet again.
/// Costs nothing where no predicted contact acts.
void hold_bent_ways(Stores& stores, StepScratch& scratch, float dt_s, TaskPool& tasks);

}  // namespace cairn::physics
