// Eight contacts side by side, as the SIMD kernels read them.
// Invariant: no body that moves stands in two lanes of blocks of one colour; unused lanes point to the row of
// the world and have arms, masses and impulses of zero. Arms are scaled as in base/motion.h; the tangent is
// the normal turned clockwise.
#pragma once

#include <cstdint>

#include "base/lanes.h"

namespace cairn::physics {

struct alignas(32) ContactBlockPoint {
    Lanes<float> arm_a;  // k_a (r_a x n)
    Lanes<float> arm_b;
    Lanes<float> mass;              // effective, along the normal; 0 in unused points
    Lanes<float> start_separation;  // m, at the start of the step
    Lanes<float> separation;        // m, now: kept by the relaxing pass for the next biased one
    Lanes<float> static_impulse;    // N s, the estimate for rest
    Lanes<float> impulse;           // N s, of one substep
};

/// Of a block of which bodies turn so far in a step that separations are not linear in their angles.
struct alignas(32) TurnLanes {
    // n . r of what turns: from the centre of mass to the point, without what is round of the shape.
    Lanes<float> bow_a{};
    Lanes<float> bow_b{};
    std::array<Lanes<float>, 2> bend{};  // m, what the start separations of both points hold of it now
    LaneBits used = 0;                   // those of such contacts
};

/// A manifold of up to two points between two bodies, with one friction row midway between the points: on the
/// line of a manifold all points have the same tangential arm.
struct alignas(64) ContactBlock {
    Lanes<std::int32_t> a;  // rows
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
    LaneBits bounces = 0;          // that may have met fast in this step, and bounce in their lanes
    TurnLanes* turning = nullptr;  // in this step
};

/// Of a block, what bouncing takes besides.
struct alignas(32) ImpactLanes {
    Lanes<float> restitution{};  // kept from step to step; 0 in lanes that do not bounce here
    std::array<Lanes<float>, 2> closing_velocity{};  // m/s, Jv of both points at the start of the step
};

void copy_lane(ContactBlock& to, int to_lane, const ContactBlock& from, int from_lane);
void copy_lane(TurnLanes& to, int to_lane, const TurnLanes& from, int from_lane);
/// What the passes change.
void copy_outcome(ContactBlock& to, int to_lane, const ContactBlock& from, int from_lane);
/// As unused lanes are.
void clear_lane(ContactBlock& block, int lane);

/// What may move in the contacts of a block. Body b always can.
enum class BlockKind : std::uint8_t {
    TwoBodies,
    OneBody,  ///< a is the world
    Carried,  ///< a moves as it likes, and nothing pushes it
};

inline constexpr int kBlockKinds = 3;

}  // namespace cairn::physics
