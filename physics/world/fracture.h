// From a plan to bodies: the pieces take the place of the body that falls apart.
#pragma once

#include <vector>

#include "world/fracture_plan.h"

namespace cairn::physics {

/// Makes the pieces, hands joints and sensors over to them, and destroys the body. The plan has two pieces at
/// least. The result is the pieces' slots, in the order of the plan.
std::vector<int> divide_body(WorldState& world, int body, const FracturePlan& plan);

/// The error when the world has no room for the pieces.
check::Fault validate_room(const Stores& stores, const FracturePlan& plan);

}  // namespace cairn::physics
