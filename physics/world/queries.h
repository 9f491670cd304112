// Questions to the world, answered from the trees.
#pragma once

#include <optional>

#include "world/world_state.h"

namespace cairn::physics {

std::optional<RayHit> cast_ray_closest(const Stores& stores, Position origin_m, Vec2 translation_m,
                                       const QueryFilter& filter);
std::optional<ShapeId> shape_at(const Stores& stores, Position point_m, const QueryFilter& filter);

}  // namespace cairn::physics
