// Joints within a step: from records to constraints, and back.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

struct StepTime;

/// Stage: the constraint of each swept joint, in the order of `swept`, and where those in lanes are.
void prepare_joints(Stores& stores, const StepTime& time, StepScratch& scratch, TaskPool& tasks);

/// Stage: impulses to start the next step from, angles with their turns, and reactions, of swept joints.
void store_joint_impulses(JointStore& joints, const StepTime& time, const StepScratch& scratch);

/// Stage: what was loaded beyond its strength is destroyed, and told.
void break_joints(Stores& stores, StepScratch& scratch, Events& events);

}  // namespace cairn::physics
