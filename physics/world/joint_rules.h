// The rules for definitions of joints.
#pragma once

#include "base/check.h"
#include "world/world_state.h"

namespace cairn::physics {

/// Numbers, handles, and how they go together. The bodies of a gear are those of its joints.
check::Fault validate(const JointDef& def, const Stores& stores);

/// "revolute_joint", and so on.
const char* name_of(JointKind kind);

/// The bodies that a definition joins, or that a gear's joints move. Handles must be valid.
struct JointBodies {
    int a = kNone;
    int b = kNone;
};
JointBodies bodies_of(const JointDef& def, const Stores& stores);

JointStrength strength_of(const JointDef& def);

}  // namespace cairn::physics
