// Axis-aligned boxes in world coordinates, in float. Invariant: made from doubles they are rounded outward,
// so a box always contains what it was made for, however far from the origin.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <cairn/physics/math.h>

namespace cairn::physics {

struct Aabb {
    Vec2 lower{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
    Vec2 upper{-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
};

/// The next float towards minus infinity, which stays as it is. Inline, unlike std::nextafter.
inline float next_below(float f) {
    if (f == 0) return -std::numeric_limits<float>::denorm_min();
    if (!(f > -std::numeric_limits<float>::infinity())) return f;
    const auto bits = std::bit_cast<std::int32_t>(f);
    return std::bit_cast<float>(f > 0 ? bits - 1 : bits + 1);
}

inline float round_down(double x) {
    const float f = static_cast<float>(x);
    return static_cast<double>(f) > x ? next_below(f) : f;
}

inline float round_up(double x) {
    return -round_down(-x);
}

/// The box from lower to upper, both relative to origin.
inline Aabb make_aabb(Position origin, Vec2 lower, Vec2 upper) {
    const Position low = origin + lower;
    const Position high = origin + upper;
    return {{round_down(low.x), round_down(low.y)}, {round_up(high.x), round_up(high.y)}};
}

/// By coordinate.
inline Vec2 smallest(Vec2 a, Vec2 b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y)};
}
inline Vec2 largest(Vec2 a, Vec2 b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y)};
}

inline Aabb merged(const Aabb& a, const Aabb& b) {
    return {smallest(a.lower, b.lower), largest(a.upper, b.upper)};
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
