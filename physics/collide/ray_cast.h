// A ray against one convex shape.
#pragma once

#include <optional>
#include <span>

#include "collide/convex.h"

namespace cairn::physics {

struct LocalRayHit {
    float fraction = 0;
    Vec2 normal;
};

/// First entry into the shape (of a chain's segment: from its front), all in the body's frame; nothing when
/// the ray starts inside or passes by.
std::optional<LocalRayHit> cast_ray(const Convex& shape, Vec2 origin, Vec2 translation);

/// The same for any convex outline rounded by a radius, seen from outside: points anticlockwise, and the
/// outward unit normal of the edge that begins at each.
std::optional<LocalRayHit> cast_ray_at_outline(std::span<const Vec2> points, std::span<const Vec2> normals,
                                               float radius, Vec2 origin, Vec2 translation);

}  // namespace cairn::physics
