// A ray against one convex shape.
#pragma once

#include <optional>

#include "collide/convex.h"

namespace cairn::physics {

struct LocalRayHit {
    float fraction = 0;
    Vec2 normal;
};

/// First entry into the shape, all in the body's frame; nothing when the ray starts inside or passes by.
std::optional<LocalRayHit> cast_ray(const Convex& shape, Vec2 origin, Vec2 translation);

}  // namespace cairn::physics
