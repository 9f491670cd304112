// Eight pairs of boxes at once. The same method as boxes.cpp, with selections where that branches.
#pragma once

#include <cstdint>

#include "base/lanes.h"

namespace cairn::physics {

/// How two bodies lie to each other. Rotations are those of the bodies.
struct alignas(32) PoseLanes {
    Lanes<float> dx;  // from the centre of mass of a to that of b, m
    Lanes<float> dy;
    Lanes<float> cos_a;
    Lanes<float> sin_a;
    Lanes<float> cos_b;
    Lanes<float> sin_b;
};

/// Boxes with their sides along the axes of their bodies.
struct alignas(32) BoxLanes {
    Lanes<float> half_ax;
    Lanes<float> half_ay;
    Lanes<float> half_bx;
    Lanes<float> half_by;
    Lanes<float> offset_ax;  // of the box's centre from the centre of mass, in the body's frame
    Lanes<float> offset_ay;
    Lanes<float> offset_bx;
    Lanes<float> offset_by;
};

inline constexpr std::int32_t kNoFeature = -1;

struct alignas(32) ManifoldPointLanes {
    Lanes<float> x;  // from the centre of mass of a, in world axes
    Lanes<float> y;
    Lanes<float> separation;
    Lanes<std::int32_t> id;  // kNoFeature: there is no such point
};

/// Manifolds in world axes; the first point is used when any is.
struct alignas(32) ManifoldLanes {
    Lanes<float> normal_x;  // unit, from a to b; where there are no points, an axis along which `gap` is seen
    Lanes<float> normal_y;
    std::array<ManifoldPointLanes, 2> points;
    Lanes<float> gap;  // a lower bound of the distance when positive
};

/// Points within reach_m. The result has a bit for each lane that only the general routine can decide.
unsigned collide_box_lanes(const PoseLanes& poses, const BoxLanes& boxes, float reach_m, ManifoldLanes& out);

}  // namespace cairn::physics
