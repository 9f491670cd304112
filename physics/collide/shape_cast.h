// A convex shape that moves straight, without turning, against one that stands.
#pragma once

#include <optional>

#include "collide/minkowski.h"

namespace cairn::physics {

/// In the frame of the fixed shape.
struct LocalShapeHit {
    float fraction = 0;  // of the translation; 0 when the shapes overlap at the start
    float overlap = 0;   // at the start: how far the moving shape must go to leave the other, else 0
    Vec2 normal;         // unit, out of the fixed shape; of an overlap, the direction of the shortest way out
    Vec2 point;          // on the surface of the fixed shape
};

/// The first touch; nothing when the shapes do not meet, or touch at the start and part.
/// Exact but for the rounding of float: about 1e-7 of the distances and sizes.
std::optional<LocalShapeHit> cast_shape(const Convex& fixed, const Convex& moving,
                                        const RelativePose& moving_in_fixed, Vec2 translation);

}  // namespace cairn::physics
