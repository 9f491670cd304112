// How far joints are from what they should do, found from where bodies are and how they move, and from
// nothing that the solver remembers.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

/// The largest there is of each sort.
struct JointErrors {
    float error_m = 0;
    float error_rad = 0;
    float residual_m_s = 0;  // speeds at which errors grow: see WorldReport
    float residual_rad_s = 0;
    double elastic_energy_j = 0;  // the sum of all
};

JointErrors measure_joints(const Stores& stores);

}  // namespace cairn::physics
