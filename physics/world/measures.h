// What can be asked about a world as a whole, for benchmarks, tests and tools; nothing here is part of a
// step.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

Counts count_objects(const Stores& stores);
float max_penetration_m(const Stores& stores);
/// Settles masses, and changes nothing else.
WorldReport make_report(WorldState& world);

}  // namespace cairn::physics
