// Joints within a step: from records to constraints, and back.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

struct StepTime;

/// Stage: the constraint of each active joint, in the order of `active`.
void prepare_joints(Stores& stores, const StepTime& time, StepScratch& scratch);

/// Stage: impulses to start the next step from, angles with their turns, and reactions.
void store_joint_impulses(JointStore& joints, const StepTime& time, const StepScratch& scratch);

/// Stage: what was loaded beyond its strength is destroyed, and told.
void break_joints(Stores& stores, const StepScratch& scratch, Events& events);

}  // namespace cairn::physics
