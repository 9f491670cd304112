// How far apart two convex shapes are.
#pragma once

#include "collide/manifold.h"

namespace cairn::physics {

struct Distance {
    float distance =
        0;         // of the surfaces; 0 when the cores overlap, and negative when only the rounding does
    Vec2 normal;   // unit, from a to b; (0, 0) when the cores overlap, and then the rest means nothing
    Vec2 point_a;  // the nearest points of the cores
    Vec2 point_b;
    int vertex_a = 0;  // corners that take part: they name the feature
    int vertex_b = 0;
};

/// In the frame of A. A guess at the normal, of any length, saves rounds where it is about right.
Distance distance_between(const Convex& a, const Convex& b, const RelativePose& b_in_a, Vec2 guess = {-1, 0});

}  // namespace cairn::physics
