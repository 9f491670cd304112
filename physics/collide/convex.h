// The one form in which all shapes collide: the convex hull of 1 (circle), 2 (capsule, segment) or 3 to 8
// points (polygon), rounded by a radius. Invariant: points run anticlockwise; normals[i] is the outward unit
// normal of the edge from point i to point i + 1. Capsules and segments have two edges, there and back.
// Behind the last point and normal the first ones are repeated, so that shapes of unlike counts can be seen
// side by side.
// A segment of a chain keeps behind its two points the far end of the segment before and of the one after,
// and behind its two normals theirs.
#pragma once

#include <array>
#include <optional>

#include <cairn/physics/math.h>
#include <cairn/physics/result.h>
#include <cairn/physics/shape.h>

#include "base/aabb.h"

namespace cairn::physics {

struct Convex {
    bool owns_end = false;  // of a chain segment: no other one answers for its end point
    bool is_box = false;    // sharp-cornered, with its sides along the axes of the body's frame
    Vec2 centroid;
    Vec2 half_size;  // of a box; its centre is the centroid
    Outline outline;
    std::array<Vec2, kMaxPolygonVertices> normals{};

    [[nodiscard]] int count() const { return outline.count; }
    [[nodiscard]] int next(int i) const { return i + 1 < outline.count ? i + 1 : 0; }
    [[nodiscard]] const Vec2& point(int i) const { return outline.points_m[i]; }
    [[nodiscard]] float radius() const { return outline.radius_m; }
    [[nodiscard]] bool is_chained() const { return outline.kind == ShapeKind::ChainSegment; }
    [[nodiscard]] bool is_line() const { return outline.kind == ShapeKind::Segment || is_chained(); }
};

/// Checks the description and brings it into this form. Errors name the field, the value and the rule.
Result<Convex> make_convex(const Geometry& geometry);

/// The segment of a chain from a to b, solid on the right of that way. `before` and `after` are the far ends
/// of its neighbours; a missing one makes a free end, as if the chain turned squarely behind itself there.
Convex make_chain_segment(std::optional<Vec2> before, Vec2 a, Vec2 b, std::optional<Vec2> after);

/// Whether all that follows from the points is what it would be made to be, in all bits: what was written
/// down elsewhere may say anything. The kind and the number of points are such as go together.
bool is_consistent(const Convex& shape);

/// Bounds of the shape, turned, about the origin of its body.
struct Extents {
    Vec2 lower;
    Vec2 upper;
};
Extents extents(const Convex& shape, Rotation q);

/// Bounds in the world.
Aabb bounds(const Convex& shape, const Transform& xf);

/// Largest distance of the shape from a point, both in the body's frame.
float farthest_distance(const Convex& shape, Vec2 from);

/// Radius of the largest disc about the centroid that lies in the shape.
float inner_radius(const Convex& shape);

/// Whether a point in the body's frame lies in the shape.
bool contains_point(const Convex& shape, Vec2 point);

}  // namespace cairn::physics
