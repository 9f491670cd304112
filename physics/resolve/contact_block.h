// Eight contacts side by side, as the SIMD kernels read them.
// Invariant: no body stands in two lanes of blocks of one colour, except the rows that nobody writes; unused
// lanes point to a dummy row with zero mass. Arms are scaled as in base/motion.h; the tangent is the normal
// turned clockwise.
#pragma once

#include <array>
#include <cstdint>

#include <cairn/physics/math.h>

namespace cairn::physics {

inline constexpr int kBlockLanes =
    8;  // wider registers gain nothing: the limit is memory; narrower ones take two rounds

inline constexpr int kNoBlock = -1;

template <class T>
using Lanes = std::array<T, kBlockLanes>;

struct alignas(32) ContactBlockPoint {
    Lanes<float> arm_a;  // k_a (r_a x n)
    Lanes<float> arm_b;
    Lanes<float> mass;              // effective, along the normal; 0 in unused points
    Lanes<float> start_separation;  // m, at the start of the step
    Lanes<float> separation;        // m, now: kept by the relaxing pass for the next biased one
    Lanes<float> static_impulse;    // N s, the estimate for rest
    Lanes<float> impulse;           // N s, of one substep
};

/// A manifold of up to two points between two bodies, with one friction row midway between the points: on the
/// line of a manifold all points have the same tangential arm.
struct alignas(32) ContactBlock {
    Lanes<std::int32_t> a;  // rows; static contacts have no a
    Lanes<std::int32_t> b;
    Lanes<float> normal_x;
    Lanes<float> normal_y;
    std::array<ContactBlockPoint, 2> points;
    Lanes<float> tangent_arm_a;
    Lanes<float> tangent_arm_b;
    Lanes<float> tangent_mass;
    Lanes<float> friction;
    Lanes<float> friction_impulse;
    // Touched only when `reports` is set: what impacts gave over the whole step.
    std::array<Lanes<float>, 2> total_impulse;
    bool reports = false;
    // Which contacts these are, and the next block of the same colour and kind.
    Lanes<std::int32_t> contact;
    int used = 0;  // lanes
    int next = kNoBlock;
};

}  // namespace cairn::physics
