// Boxes that move along straight ways. The box holds where a thing is, where it will be, and all between: so
// the boxes of two that move side by side overlap far more than the things could ever touch.
#pragma once

#include <algorithm>

#include "base/aabb.h"

namespace cairn::physics {

/// Where that which moves is when it sets out.
inline Aabb start_of(const Aabb& box, Vec2 way) {
    const Vec2 backward{std::min(way.x, 0.0f), std::min(way.y, 0.0f)};
    const Vec2 forward{std::max(way.x, 0.0f), std::max(way.y, 0.0f)};
    return {box.lower - backward, box.upper - forward};
}

/// Whether two things keep apart on their ways, though their boxes overlap: along an axis the gap between
/// them is open when they set out, and as one is seen from the other it does not close. Which one is named
/// first does not matter, to the last bit; with ways beyond all measure the answer is no.
inline bool keep_apart(const Aabb& a, Vec2 way_a, const Aabb& b, Vec2 way_b) {
    const Aabb start_a = start_of(a, way_a);
    const Aabb start_b = start_of(b, way_b);
    const auto along = [](float lower_a, float upper_a, float lower_b, float upper_b, float opening) {
        return (lower_a - upper_b) + std::min(opening, 0.0f) > 0 ||
               (lower_b - upper_a) - std::max(opening, 0.0f) > 0;
    };
    return along(start_a.lower.x, start_a.upper.x, start_b.lower.x, start_b.upper.x, way_a.x - way_b.x) ||
           along(start_a.lower.y, start_a.upper.y, start_b.lower.y, start_b.upper.y, way_a.y - way_b.y);
}

}  // namespace cairn::physics
