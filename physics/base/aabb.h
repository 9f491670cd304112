// Axis-aligned boxes in world coordinates, in float. Invariant: made from doubles they are rounded outward,
// so a box always contains what it was made for, however far from the origin.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/physics/math.h>

namespace cairn::physics {

struct Aabb {
    Vec2 lower{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
    Vec2 upper{-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
};

inline float round_down(double x) {
    const float f = static_cast<float>(x);
    return static_cast<double>(f) > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}

inline float round_up(double x) {
    const float f = static_cast<float>(x);
    return static_cast<double>(f) < x ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

/// The box from lower to upper, both relative to origin.
inline Aabb make_aabb(Position origin, Vec2 lower, Vec2 upper) {
    const Position low = origin + lower;
    const Position high = origin + upper;
    return {{round_down(low.x), round_down(low.y)}, {round_up(high.x), round_up(high.y)}};
}

inline Aabb merged(const Aabb& a, const Aabb& b) {
    return {{std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y)},
            {std::max(a.upper.x, b.upper.x), std::max(a.upper.y, b.upper.y)}};
}

inline bool overlap(const Aabb& a, const Aabb& b) {
    return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y &&
           b.lower.y <= a.upper.y;
}

inline bool contains(const Aabb& outer, const Aabb& inner) {
    return outer.lower.x <= inner.lower.x && outer.lower.y <= inner.lower.y &&
           inner.upper.x <= outer.upper.x && inner.upper.y <= outer.upper.y;
}

/// Half the perimeter: the chance that a random line meets the box, and so the cost that the tree keeps low.
inline float half_perimeter(const Aabb& a) {
    return (a.upper.x - a.lower.x) + (a.upper.y - a.lower.y);
}

inline Aabb grown(const Aabb& a, float margin) {
    return {{a.lower.x - margin, a.lower.y - margin}, {a.upper.x + margin, a.upper.y + margin}};
}

}  // namespace cairn::physics
