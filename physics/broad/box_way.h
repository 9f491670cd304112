// Boxes that move along straight ways. The box holds where a thing is, where it will be, and all between: so
// the boxes of two that move side by side overlap far more than the things could ever touch.
#pragma once

#include <algorithm>

#include "base/aabb.h"

namespace cairn::physics {

/// How much the boxes of a and b must overlap at the lower side of a and the upper side of b for the two to
/// meet, less than 0; by axis, from their ways along it. Seen from b, a moves by the difference of the ways.
inline float least_overlap(float way_a, float way_b) {
    return (std::min(way_a, 0.0f) - std::max(way_b, 0.0f)) - std::min(way_a - way_b, 0.0f);
}

/// Whether two things keep apart on their ways, though their boxes overlap. Which one is named first does not
/// matter, to the last bit; with ways beyond all measure the answer is no.
inline bool keep_apart(const Aabb& a, Vec2 way_a, const Aabb& b, Vec2 way_b) {
    return a.lower.x - b.upper.x > least_overlap(way_a.x, way_b.x) ||
           b.lower.x - a.upper.x > least_overlap(way_b.x, way_a.x) ||
           a.lower.y - b.upper.y > least_overlap(way_a.y, way_b.y) ||
           b.lower.y - a.upper.y > least_overlap(way_b.y, way_a.y);
}

}  // namespace cairn::physics
