// A joint as the solver sees it in one step: directions in which it acts, and laws for the motion along them.
//
// A direction is a row J of the Jacobian together with how far the bodies have gone along it, q, so that
// dq/dt = J v. The file of each kind says what its directions are; what is done with them is the same for
// all. Invariant: a law's impulses stand at [4 direction + role] of the constraint, so that they find
// themselves again in the next step whatever else was switched on or off meanwhile.
#pragma once

#include <array>
#include <cstdint>

#include <cairn/physics/joint.h>

#include "resolve/joints/anchors.h"
#include "resolve/joints/exact_spring.h"
#include "resolve/soft.h"

namespace cairn::physics {

inline constexpr int kMaxDirections = 3;
inline constexpr int kMaxJointBodies = 4;  // of gears; all others have two

/// The part of J that belongs to one body.
struct Jacobian {
    Vec2 linear;
    float angular = 0;
};

struct Direction {
    std::array<Jacobian, kMaxJointBodies> j;
    float q = 0;  // m or rad
};
using Directions = std::array<Direction, kMaxDirections>;

enum class LawKind : std::uint8_t {
    Hold,    ///< q stays at the target; several directions are solved as one
    Spring,  ///< q is drawn to the target by a force within [low, high]
    Motor,   ///< J v is driven to a speed by a force within [low, high]
    Lower,   ///< q stays above the target
    Upper,   ///< q stays below it
};

/// The K that a spring's constants are for: these over it are N/m and N s/m (spring_mobility.h). xy and yy
/// are of springs of two directions. 0: as K is at the moment.
struct SpringMobility {
    float xx = 0;
    float xy = 0;
    float yy = 0;
};

struct JointLaw {
    LawKind kind = LawKind::Hold;
    std::uint8_t direction = 0;  // the first
    std::uint8_t count = 1;
    bool rigid = false;  // of what is held: no softer than the default
    bool bears = false;  // of a spring: stands on contacts (world/stiff_springs.h)
    bool round = false;  // high limits the length of an impulse of two directions
    float target = 0;
    std::array<float, 2> speed{};  // m/s or rad/s
    float low = 0;                 // N s or N m s per substep
    float high = 0;
    Softness softness;  // of what is held, and of limits
    float spring_frequency_hz = 0;
    float spring_damping_ratio = 0;
    ExactSpring spring;
    SpringMobility mobility;
    std::array<float, 2> speed_before{};  // J v at the end of the last substep
    std::array<float, 2> start_error{};   // of a spring that relaxes, at the start of the substep
};

enum class Role : std::uint8_t { HoldOrSpring, Motor, Lower, Upper };
inline constexpr int kRoles = 4;

using JointImpulses = std::array<float, kMaxDirections * kRoles>;

constexpr int impulse_index(int direction, Role role) {
    return kRoles * direction + static_cast<int>(role);
}
constexpr Role role_of(LawKind kind) {
    switch (kind) {
        case LawKind::Hold:
        case LawKind::Spring:
            return Role::HoldOrSpring;
        case LawKind::Motor:
            return Role::Motor;
        case LawKind::Lower:
            return Role::Lower;
        case LawKind::Upper:
            return Role::Upper;
    }
    return Role::HoldOrSpring;
}

struct JointConstraint {
    JointKind kind = JointKind::Distance;
    int joint = 0;                            // where the impulses go back to
    std::array<int, kMaxJointBodies> rows{};  // motions
    int bodies = 2;
    int directions = 0;
    int b = 1;  // which of `rows` is body b of the joint
    JointAnchors anchors;
    Vec2 axis{1, 0};            // x axis of frame a in the world, at the start of the step
    float start_angle_rad = 0;  // of frame b relative to a, at the start of the step, in (-pi, pi]
    // Of pulleys.
    Vec2 from_wheel_a;  // anchor less wheel, at the start of the step
    Vec2 from_wheel_b;
    float ratio = 1;  // of gears, too
    // Of gears: the constraints of the two joints, and in which of `rows` the bodies a and b of each stand.
    std::array<int, 2> geared{};
    std::array<int, 4> geared_rows{};

    std::array<JointLaw, 6> laws;
    int law_count = 0;
    bool has_spring = false;
    // x and y of frames, which else are the axes of the world, turn with a: `axis`, in its coordinates this.
    bool turns_with_a = false;
    Vec2 axis_on_a{1, 0};
    float softened_hz = 0;    // of its springs where they are softer than asked for (world/stiff_springs.h)
    bool is_new = false;      // in its first step
    bool direct = false;      // solved with its whole structure at once, and not by sweeping
    JointImpulses impulse{};  // of one substep
    Vec2 total_impulse;       // on body b over the step, N s
    float total_angular_impulse = 0;  // about its anchor, N m s
};

/// Where the directions of a joint point, and what follows from it; the same until bodies move on.
struct JointPlace {
    Directions directions;
    std::array<std::array<float, kMaxDirections>, kMaxDirections> inverse_mass{};  // K
    float least_mobility = 0;  // pivots of K up to this count as locked altogether (base/motion.h)
};

}  // namespace cairn::physics
