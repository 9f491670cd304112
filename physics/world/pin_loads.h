// Loads of pins in large structures with loops, which nobody solves directly (docs/adr/017-pin-loads.md).
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

struct StepTime;

/// Stage: what the pins of such structures would bear if everything stood still, once for each that is new or
/// has lost a joint. New pins start with it as their impulse.
void estimate_pin_loads(Stores& stores, Vec2 gravity_m_s2, const StepTime& time, DirectGroups& groups);

/// Pins at the same bodies bear something else from now on.
void forget_loads_around(Stores& stores, int joint);

}  // namespace cairn::physics
