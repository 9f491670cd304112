// Directions that several kinds of joint have in common.
#pragma once

#include "resolve/joints/joint_constraint.h"

namespace cairn::physics {

/// Anchor b against anchor a, along an axis that does not turn:
///     q = u . d,    J v = u . (vB + wB x rB - vA - wA x rA)
inline Direction fixed_axis(const AnchorsNow& at, Vec2 u) {
    return {{{{-u, -cross(at.r_a, u)}, {u, cross(at.r_b, u)}}}, dot(at.offset, u)};
}

/// Anchor b along an axis that turns with body a: its lever reaches from the centre of a to anchor b.
///     dq/dt = u . (dB' - dA') + (wA x u) . d,    and (wA x u) . d = -wA (d x u)
inline Direction carried_axis(const AnchorsNow& at, Vec2 u) {
    return {{{{-u, -cross(at.r_a + at.offset, u)}, {u, cross(at.r_b, u)}}}, dot(at.offset, u)};
}

/// The angle of frame b relative to frame a.
inline Direction relative_angle(const JointConstraint& c, const AnchorsNow& at) {
    return {{{{{}, -1}, {{}, 1}}}, c.start_angle_rad + at.turn};
}

}  // namespace cairn::physics
