// What all directly solved structures of a step work on.
#pragma once

#include <span>

#include "base/motion.h"
#include "resolve/contact_constraint.h"
#include "resolve/joints/joint_constraint.h"

namespace cairn::physics {

struct DirectScene {
    std::span<JointConstraint> joints;
    std::span<ContactConstraint> contacts;
    Motions& motions;
    std::span<const Drive> drives;
    ContactRules rules;
    float h_s = 0;
};

}  // namespace cairn::physics
