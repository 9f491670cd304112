// Sleeping and waking. Bodies that fell asleep together wake together; sleeping bodies leave the hot rows and
// cost nothing.
#pragma once

#include <span>

#include "world/world_state.h"

namespace cairn::physics {

/// Wakes the body and all that fell asleep with it; restarts the rest time of a body that is awake.
void wake_body(Stores& stores, int body);

/// Wakes what touches the body or is jointed to it, not the body itself.
void wake_neighbours(Stores& stores, int body);

/// Wakes what is jointed to the body.
void wake_jointed(Stores& stores, int body);

/// Puts bodies to sleep as one group.
void put_to_sleep(Stores& stores, std::span<const int> bodies);

/// The step's stage: islands whose bodies have all been at rest long enough fall asleep.
void sleep_islands(Stores& stores, std::uint64_t step_count, StepScratch& scratch);

/// At once, whatever the bodies do: the awake body and its island.
void put_island_to_sleep(Stores& stores, StepScratch& scratch, int body);

}  // namespace cairn::physics
