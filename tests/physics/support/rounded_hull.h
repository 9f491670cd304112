// A second implementation of convex geometry, for comparison with the module's: brute force over all
// features, in double. Slow and plain on purpose.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "collide/manifold.h"

namespace cairn::physics::test {

struct Point {
    double x = 0;
    double y = 0;

    friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
    friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
    friend Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
};

inline double dot(Point a, Point b) {
    return a.x * b.x + a.y * b.y;
}
inline double cross(Point a, Point b) {
    return a.x * b.y - a.y * b.x;
}
inline double norm(Point a) {
    return std::sqrt(dot(a, a));
}
inline Point to_point(Vec2 a) {
    return {static_cast<double>(a.x), static_cast<double>(a.y)};
}

/// The points of a core (1: circle, 2: capsule, else anticlockwise polygon), rounded by a radius.
struct RoundedHull {
    std::vector<Point> core;
    double radius = 0;

    [[nodiscard]] int count() const { return static_cast<int>(core.size()); }
    [[nodiscard]] Point at(int i) const { return core[i % count()]; }
};

inline RoundedHull rounded_hull(const Convex& shape, const RelativePose& pose = {}) {
    RoundedHull hull;
    hull.radius = static_cast<double>(shape.radius());
    const auto c = static_cast<double>(pose.q.c);
    const auto s = static_cast<double>(pose.q.s);
    for (int i = 0; i < shape.count(); ++i) {
        const Point p = to_point(shape.point(i));
        hull.core.push_back(to_point(pose.p) + Point{c * p.x - s * p.y, s * p.x + c * p.y});
    }
    return hull;
}

inline Point nearest_on_segment(Point p, Point a, Point b) {
    const Point d = b - a;
    const double whole = dot(d, d);
    const double t = whole > 0 ? std::clamp(dot(p - a, d) / whole, 0.0, 1.0) : 0;
    return a + t * d;
}

inline bool is_inside_core(const RoundedHull& hull, Point p) {
    if (hull.count() < 3) return false;
    for (int i = 0; i < hull.count(); ++i) {
        if (cross(hull.at(i + 1) - hull.at(i), p - hull.at(i)) < 0) return false;
    }
    return true;
}

/// Distance of a point from the surface; negative inside. Exact outside of the core's edges, and inside the
/// core up to the edges' straight offset, which is all that a rounded hull has there.
inline double signed_distance(const RoundedHull& hull, Point p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < hull.count(); ++i)
        nearest = std::min(nearest, norm(p - nearest_on_segment(p, hull.at(i), hull.at(i + 1))));
    return (is_inside_core(hull, p) ? -nearest : nearest) - hull.radius;
}

struct Separation {
    double distance = 0;  // between the surfaces; negative when they overlap
    Point normal;         // from a to b
    bool cores_overlap = false;
};

inline bool cores_meet(const RoundedHull& a, const RoundedHull& b) {
    for (const Point p : b.core) {
        if (is_inside_core(a, p)) return true;
    }
    for (const Point p : a.core) {
        if (is_inside_core(b, p)) return true;
    }
    for (int i = 0; i < a.count(); ++i) {
        for (int j = 0; j < b.count(); ++j) {
            const Point p = a.at(i);
            const Point q = a.at(i + 1);
            const Point r = b.at(j);
            const Point s = b.at(j + 1);
            const bool crosses_b = cross(q - p, r - p) * cross(q - p, s - p) < 0;
            const bool crosses_a = cross(s - r, p - r) * cross(s - r, q - r) < 0;
            if (crosses_a && crosses_b) return true;
        }
    }
    return false;
}

/// For cores that overlap: over all edges of both, the direction in which the least push parts the cores.
inline Separation least_push(const RoundedHull& a, const RoundedHull& b) {
    Separation best{-std::numeric_limits<double>::infinity(), {}, true};
    const auto try_edges_of = [&](const RoundedHull& of, const RoundedHull& other, double sign) {
        for (int i = 0; i < of.count() && of.count() > 1; ++i) {
            const Point edge = of.at(i + 1) - of.at(i);
            const Point out = (1 / norm(edge)) * Point{edge.y, -edge.x};
            double nearest = std::numeric_limits<double>::infinity();
            for (const Point p : other.core) nearest = std::min(nearest, dot(out, p - of.at(i)));
            if (nearest > best.distance) best = {nearest, sign * out, true};
        }
    };
    try_edges_of(a, b, 1);
    try_edges_of(b, a, -1);
    best.distance -= a.radius + b.radius;
    return best;
}

/// m. Far above the rounding of double, far below that of float.
inline constexpr double kTouching_m = 1e-12;

inline Separation separation(const RoundedHull& a, const RoundedHull& b) {
    if (cores_meet(a, b)) return least_push(a, b);
    Separation best{std::numeric_limits<double>::infinity(), {}, false};
    const auto take = [&](Point on_a, Point on_b) {
        const double distance = norm(on_b - on_a);
        if (distance < best.distance) best = {distance, (1 / distance) * (on_b - on_a), false};
    };
    for (int i = 0; i < a.count(); ++i) {
        for (const Point p : b.core) take(nearest_on_segment(p, a.at(i), a.at(i + 1)), p);
    }
    for (int j = 0; j < b.count(); ++j) {
        for (const Point p : a.core) take(p, nearest_on_segment(p, b.at(j), b.at(j + 1)));
    }
    // Cores that touch, or cross in a corner.
    const bool has_edges = a.count() > 1 || b.count() > 1;
    if (has_edges && best.distance < kTouching_m) return least_push(a, b);
    best.distance -= a.radius + b.radius;
    return best;
}

}  // namespace cairn::physics::test
