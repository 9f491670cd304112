// Making and removing joints. Callers have checked every number and handle.
#pragma once

#include <variant>

#include "world/world_state.h"

namespace cairn::physics {

int create_joint(WorldState& world, std::variant<RevoluteJointDef, DistanceJointDef> def);
/// Wakes both bodies.
void destroy_joint(Stores& stores, int joint);
void wake_joint_bodies(Stores& stores, int joint);

}  // namespace cairn::physics
