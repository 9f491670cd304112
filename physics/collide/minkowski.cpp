// The difference by merging edges, and the distance of the origin from it.
#include "collide/minkowski.h"

#include <algorithm>
#include <limits>

namespace cairn::physics {
namespace {

struct Corners {
    std::array<Vec2, kMaxPolygonVertices> points;
    int count = 0;

    // The corner `i` after the lowest one; of equally low ones, after the leftmost.
    [[nodiscard]] Vec2 operator[](int i) const { return points[(lowest + i) % count]; }
    void start_at_lowest() {
        const auto lower = [](Vec2 a, Vec2 b) { return a.y < b.y || (a.y == b.y && a.x < b.x); };
        lowest = static_cast<int>(std::min_element(points.begin(), points.begin() + count, lower) -
                                  points.begin());
    }
    int lowest = 0;
};

Corners corners(const Convex& shape) {
    Corners result;
    result.points = shape.outline.points_m;
    result.count = shape.count();
    result.start_at_lowest();
    return result;
}

// Of the moving shape mirrored in the origin; a half turn, so still anticlockwise.
Corners mirrored_corners(const Convex& shape, const RelativePose& pose) {
    Corners result;
    result.count = shape.count();
    for (int i = 0; i < shape.count(); ++i) result.points[i] = -(pose.p + rotate(pose.q, shape.point(i)));
    result.start_at_lowest();
    return result;
}

// Whether an edge turns less than another, counted from the direction (1, 0) round to it again.
bool turns_less(Vec2 a, Vec2 b) {
    const auto is_second_half = [](Vec2 edge) { return edge.y < 0 || (edge.y == 0 && edge.x < 0); };
    if (is_second_half(a) != is_second_half(b)) return is_second_half(b);
    return cross(a, b) >= 0;
}

// The ends of a core in a direction: two when an edge of it faces that way.
struct Extreme {
    Vec2 a;
    Vec2 b;
    bool is_edge = false;
};

template <class Point>
Extreme extreme(int count, Vec2 direction, Point&& point) {
    int best = 0;
    for (int i = 1; i < count; ++i) {
        if (dot(point(i), direction) > dot(point(best), direction)) best = i;
    }
    Extreme result{point(best), point(best), false};
    // Edges that lean by less than this count as lying along each other.
    constexpr float kLean = 1e-3f;
    for (const int other : {(best + 1) % count, (best + count - 1) % count}) {
        const Vec2 edge = point(other) - point(best);
        if (other == best || -dot(edge, direction) > kLean * length(edge)) continue;
        return {point(best), point(other), true};
    }
    return result;
}

}  // namespace

MinkowskiDifference minkowski_difference(const Convex& fixed, const Convex& moving,
                                         const RelativePose& moving_in_fixed) {
    const Corners f = corners(fixed);
    const Corners m = mirrored_corners(moving, moving_in_fixed);
    MinkowskiDifference result;
    result.radius = fixed.radius() + moving.radius();
    // From the lowest corner round: whichever outline's next edge turns less comes next. A single point has
    // no edges, and two points have one there and one back.
    const int edges_f = f.count > 1 ? f.count : 0;
    const int edges_m = m.count > 1 ? m.count : 0;
    int i = 0;
    int j = 0;
    result.points[result.count++] = f[0] + m[0];
    while (i < edges_f || j < edges_m) {
        const Vec2 edge_f = f[i + 1] - f[i];
        const Vec2 edge_m = m[j + 1] - m[j];
        const bool take_f = j == edges_m || (i < edges_f && turns_less(edge_f, edge_m));
        result.normals[result.count - 1] = normalized(right_perp(take_f ? edge_f : edge_m));
        (take_f ? i : j) += 1;
        if (i < edges_f || j < edges_m) result.points[result.count++] = f[i] + m[j];
    }
    return result;
}

Clearance clearance(const MinkowskiDifference& d) {
    float deepest = -std::numeric_limits<float>::infinity();  // height above the edge's line, for inside
    Vec2 deepest_normal{0, 1};
    float nearest =
        std::numeric_limits<float>::infinity();  // to a corner or the front of an edge, for outside
    Vec2 nearest_normal;
    float boundary = std::numeric_limits<float>::infinity();  // to any part of any edge
    for (int i = 0; i < d.count; ++i) {
        const float corner = length(d.points[i]);
        if (corner < nearest) {
            nearest = corner;
            nearest_normal = normalized(-d.points[i]);
        }
        // A single point, or two that rounding has made one, have no direction between them.
        if (d.count == 1 || d.normals[i] == Vec2{}) continue;
        const float height = -dot(d.points[i], d.normals[i]);
        const float along = -dot(d.points[i], left_perp(d.normals[i]));
        const bool is_beside = along >= 0 && along <= length(d.points[d.next(i)] - d.points[i]);
        if (is_beside) boundary = std::min(boundary, std::fabs(height));
        if (is_beside && height >= 0 && height <= nearest) {
            nearest = height;
            nearest_normal = d.normals[i];
        }
        if (height > deepest) {
            deepest = height;
            deepest_normal = d.normals[i];
        }
    }
    // Past the end of a difference without area (two parallel rods) the origin is behind no edge, yet
    // outside: inside, the depth is the distance from the boundary too.
    const bool is_inside = d.count > 2 && deepest < 0 && std::min(boundary, nearest) <= -2 * deepest;
    if (is_inside) return {deepest - d.radius, deepest_normal};
    return {nearest - d.radius, nearest_normal == Vec2{} ? deepest_normal : nearest_normal};
}

Vec2 meeting_point(const Convex& fixed, const Convex& moving, const RelativePose& moving_in_fixed,
                   const Clearance& clearance) {
    const Vec2 normal = clearance.normal;
    const Vec2 to_fixed = -(moving.radius() + clearance.distance) * normal;
    const auto of_moving = [&](int i) {
        return moving_in_fixed.p + rotate(moving_in_fixed.q, moving.point(i));
    };
    const Extreme f = extreme(fixed.count(), normal, [&](int i) { return fixed.point(i); });
    if (!f.is_edge) return f.a + fixed.radius() * normal;
    const Extreme m = extreme(moving.count(), -normal, of_moving);
    if (!m.is_edge) return m.a + to_fixed;
    const Vec2 tangent = left_perp(normal);
    const auto from_a = [&](Vec2 p) { return dot(p - f.a, tangent); };
    const float low = std::max(std::min(0.0f, from_a(f.b)), std::min(from_a(m.a), from_a(m.b)));
    const float high = std::min(std::max(0.0f, from_a(f.b)), std::max(from_a(m.a), from_a(m.b)));
    return f.a + 0.5f * (low + high) * tangent + fixed.radius() * normal;
}

}  // namespace cairn::physics
