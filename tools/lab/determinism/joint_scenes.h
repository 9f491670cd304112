// A scene for each kind of joint, in the variants that take another way through the solver.
#pragma once

#include <vector>

#include "scene.h"

namespace cairn::lab {

/// In the order of physics::JointKind, and one of joints that break. Names begin with "joint_".
std::vector<bench::Scene> joint_scenes();

}  // namespace cairn::lab
