// The convex hull of a few points.
#pragma once

#include <span>

#include <cairn/physics/math.h>
#include <cairn/physics/result.h>
#include <cairn/physics/shape.h>

namespace cairn::physics {

struct Hull {
    std::array<Vec2, kMaxPolygonVertices> points{};  // anticlockwise
    int count = 0;
};

/// Points closer than the linear slop to each other, or to the line through their neighbours, are left out.
/// Errors: points that are not finite, fewer than 3 corners left, more than kMaxPolygonVertices corners.
Result<Hull> make_hull(std::span<const Vec2> points);

}  // namespace cairn::physics
