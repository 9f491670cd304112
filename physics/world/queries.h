// Questions to the world, answered from the trees. All are const and free of hidden state, so that any number
// of threads may ask at once. Lists are in a fixed order, whatever the tree: by distance or fraction, then by
// shape.
#pragma once

#include <optional>
#include <vector>

#include "world/world_state.h"

namespace cairn::physics {

std::optional<RayHit> cast_ray_closest(const Stores& stores, Position origin_m, Vec2 translation_m,
                                       const QueryFilter& filter);
std::vector<RayHit> cast_ray_all(const Stores& stores, Position origin_m, Vec2 translation_m,
                                 const QueryFilter& filter);

std::optional<ShapeHit> cast_shape_closest(const Stores& stores, const Convex& shape, const Transform& start,
                                           Vec2 translation_m, const QueryFilter& filter);
std::vector<ShapeHit> cast_shape_all(const Stores& stores, const Convex& shape, const Transform& start,
                                     Vec2 translation_m, const QueryFilter& filter);

std::optional<ShapeId> shape_at(const Stores& stores, Position point_m, const QueryFilter& filter);
std::vector<ShapeId> shapes_overlapping(const Stores& stores, const Convex& shape, const Transform& pose,
                                        const QueryFilter& filter);
std::vector<ShapeId> shapes_in_box(const Stores& stores, Position lower_m, Position upper_m,
                                   const QueryFilter& filter);

std::optional<SurfacePoint> closest_point(const Stores& stores, Position point_m, float radius_m,
                                          const QueryFilter& filter);
std::vector<SurfacePoint> closest_points(const Stores& stores, Position point_m, float radius_m,
                                         const QueryFilter& filter);
std::vector<CollisionPlane> collision_planes(const Stores& stores, const Convex& shape, const Transform& pose,
                                             float reach_m, const QueryFilter& filter);

}  // namespace cairn::physics
