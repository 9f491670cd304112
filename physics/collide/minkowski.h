// Everything that can be asked about two convex shapes, asked about one point instead.
// The Minkowski difference F - M of a fixed and a moving shape is the set of translations that make M overlap
// F. It is convex, and rounded by both radii: so the distance of the shapes, or the depth of their overlap,
// is that of the origin from it; and a shape cast is a ray cast. Both are exact, without iteration.
// Invariant: points run anticlockwise; normals[i] is the outward unit normal of the edge from point i to i
// + 1. Source: de Berg et al., "Computational Geometry", 3rd ed. 2008, 13.3 (merging the edges by angle).
#pragma once

#include <array>

#include "collide/manifold.h"

namespace cairn::physics {

/// In the frame of the fixed shape.
struct MinkowskiDifference {
    std::array<Vec2, 2 * kMaxPolygonVertices> points;
    std::array<Vec2, 2 * kMaxPolygonVertices> normals;
    int count = 0;
    float radius = 0;

    [[nodiscard]] int next(int i) const { return i + 1 < count ? i + 1 : 0; }
};

MinkowskiDifference minkowski_difference(const Convex& fixed, const Convex& moving,
                                         const RelativePose& moving_in_fixed);

/// How far the moving shape is from the fixed one.
struct Clearance {
    float distance = 0;  // of the surfaces; negative: how far the moving shape must go to leave the other
    Vec2 normal;         // unit, the direction of the shortest way out of the fixed shape
};

/// Exact for overlaps too, but for overlapping circles about one point, which part upward.
Clearance clearance(const MinkowskiDifference& difference);

/// Where the shapes meet that are this far apart, on the surface of the fixed one; of two edges that lie
/// along each other, the middle of where they do.
Vec2 meeting_point(const Convex& fixed, const Convex& moving, const RelativePose& moving_in_fixed,
                   const Clearance& clearance);

}  // namespace cairn::physics
