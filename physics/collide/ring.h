// Convex polygons with any number of corners, in double: what shapes are while they are being cut.
// Invariant: corners run anticlockwise. The two parts of a cut share its end points bit for bit, so that they
// neither overlap nor gape. Source: half-plane clipping, Sutherland and Hodgman 1974.
#pragma once

#include <optional>
#include <vector>

#include "collide/convex.h"

namespace cairn::physics {

struct RingPoint {
    double x = 0;
    double y = 0;

    friend constexpr bool operator==(const RingPoint&, const RingPoint&) = default;
    friend constexpr RingPoint operator+(RingPoint a, RingPoint b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr RingPoint operator-(RingPoint a, RingPoint b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr RingPoint operator*(double s, RingPoint a) { return {s * a.x, s * a.y}; }
};

constexpr double dot(RingPoint a, RingPoint b) {
    return a.x * b.x + a.y * b.y;
}
constexpr double cross(RingPoint a, RingPoint b) {
    return a.x * b.y - a.y * b.x;
}
inline double length(RingPoint a) {
    return std::sqrt(dot(a, a));
}
inline RingPoint to_ring_point(Vec2 a) {
    return {static_cast<double>(a.x), static_cast<double>(a.y)};
}
inline Vec2 to_vec2(RingPoint a) {
    return {static_cast<float>(a.x), static_cast<float>(a.y)};
}

using Ring = std::vector<RingPoint>;

/// A line that is walked along: it has a left and a right side.
struct DirectedLine {
    RingPoint origin;
    RingPoint direction;  // unit

    /// Positive on the left.
    [[nodiscard]] double distance(RingPoint p) const { return cross(direction, p - origin); }
    [[nodiscard]] double along(RingPoint p) const { return dot(direction, p - origin); }
    [[nodiscard]] DirectedLine reversed() const { return {origin, -1.0 * direction}; }
    /// Moved to its left.
    [[nodiscard]] DirectedLine shifted(double by) const {
        return {origin + by * RingPoint{-direction.y, direction.x}, direction};
    }
};

struct Interval {
    double low = 0;
    double high = 0;
};

/// The outline of a shape that has an area. Arcs become chords from point to point of the arc, so the ring
/// lies within the shape. A disc becomes 12 corners, the end of a capsule 4 to 6 chords.
Ring ring_of(const Convex& shape);

double area(const Ring& ring);
/// The width of the narrowest slot that lets the ring through; 0 for one without an area.
double least_width(const Ring& ring);
bool contains(const Ring& ring, RingPoint point);
/// Of the outline and not of the inside.
RingPoint nearest_on_outline(const Ring& ring, RingPoint point);

/// The bounds of a ring, which has a corner at least.
struct RingBox {
    RingPoint lower;
    RingPoint upper;
};
RingBox box_of(const Ring& ring);
RingBox merged(const RingBox& a, const RingBox& b);
/// Whether they are no more than `gap` apart.
bool overlap(const RingBox& a, const RingBox& b, double gap);

/// What lies to the left of the line, empty when that has no area. To the right: left of the reversed line.
Ring left_part(const Ring& ring, const DirectedLine& line);
/// From where to where along the line the ring comes within `reach` of it; nothing when it does not.
std::optional<Interval> interval_near(const Ring& ring, const DirectedLine& line, double reach);

/// As shapes of at most kMaxPolygonVertices corners: one, or several side by side; none for a sliver that can
/// be no shape.
std::vector<Convex> shapes_of(const Ring& ring);

}  // namespace cairn::physics
