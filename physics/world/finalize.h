// Stage after the substeps: bodies take their new places, boxes follow, rest times are kept.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

void finalize_bodies(Stores& stores, const StepScratch& scratch, float dt_s, bool sleep_enabled);

/// Brings the boxes of a body's shapes up to its place; boxes that the shape has left are made anew.
void update_boxes(Stores& stores, int body);

}  // namespace cairn::physics
