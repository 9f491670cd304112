// Making, changing and removing joints. Callers have checked every number and handle.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

/// Takes in what the definition leaves to be found: the length of a pulley's rope, what a gear keeps.
int create_joint(WorldState& world, JointDef def);
/// For another definition of the same kind, with the same bodies. Wakes both.
void redefine_joint(WorldState& world, int joint, JointDef def);
/// Its end on side 0 (a) or 1 (b) holds to another body from now on; it keeps all that it remembers.
void rehang_joint(Stores& stores, int joint, int side, int body);
/// Wakes both bodies. Gears on the joint go with it.
void destroy_joint(Stores& stores, int joint);
void wake_joint_bodies(Stores& stores, int joint);

/// Whether a joint has anything to solve.
bool takes_part(const JointRecord& joint);
/// Whether it has in this step: while one of its bodies is awake, and one that it can move if there is any.
bool acts(const BodyStore& bodies, const JointRecord& joint);

}  // namespace cairn::physics
