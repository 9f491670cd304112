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

/// Left out are points closer to another than the linear slop or a thousandth of the whole size, and corners
/// that stand out from the line of their neighbours by less than 1e-4 of its length. Errors: points that are
/// not finite, fewer than 3 corners left, more than kMaxPolygonVertices corners.
Result<Hull> make_hull(std::span<const Vec2> points);

}  // namespace cairn::physics
