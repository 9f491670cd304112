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

/// The greatest float that is not above x. Without branches: whether the nearest float is above is as good as
/// random, and processors guess it wrong every other time.
inline float round_down(double x) {
    const auto nearest = static_cast<float>(x);
    const auto bits = std::bit_cast<std::int32_t>(nearest);
    const std::int32_t is_above = static_cast<double>(nearest) > x ? 1 : 0;
    const std::int32_t away_from_zero =
        (bits >> 31) | 1;  // of positive numbers, the reverse of negative ones
    return std::bit_cast<float>(bits - is_above * away_from_zero);
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
