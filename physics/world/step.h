// One step of a world.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

void step_world(WorldState& world, float dt_s);

}  // namespace cairn::physics
