// Moving bodies on: by substeps when constraints act on them, in one exact stride when none does.
// Source: semi-implicit Euler for the substeps; constant acceleration for the stride.
#pragma once

#include <span>

#include "base/motion.h"

namespace cairn::physics {

/// v += h a, then damped by e^(-c h). Constrained bodies only.
void integrate_velocities(std::span<Motion> motions, std::span<const Drive> drives, float h_s);

/// dp += h v, dq turned by h w. Constrained bodies only.
void integrate_positions(std::span<Motion> motions, float h_s);

/// The whole step at once for bodies without constraints: x += dt (v + v')/2, exact under constant
/// acceleration.
void fly_freely(std::span<Motion> motions, std::span<const Drive> drives, float dt_s);

}  // namespace cairn::physics
