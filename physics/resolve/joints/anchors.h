// What every joint shares: two bodies, an anchor on each, and how they have moved since the start of the
// step.
#pragma once

#include "base/motion.h"

namespace cairn::physics {

struct JointAnchors {
    int a = 0;  // motions
    int b = 0;
    Vec2 r_a;  // centre of mass to anchor, in world axes, at the start of the step
    Vec2 r_b;
    Vec2 center_offset;  // centre of b minus centre of a, at the start of the step
};

/// The same, now.
struct AnchorsNow {
    Vec2 r_a;
    Vec2 r_b;
    Vec2 offset;  // anchor b minus anchor a
};

inline AnchorsNow anchors_now(const JointAnchors& j, const Motion& a, const Motion& b) {
    const Vec2 r_a = rotate(a.dq, j.r_a);
    const Vec2 r_b = rotate(b.dq, j.r_b);
    return {r_a, r_b, (b.dp - a.dp) + j.center_offset + (r_b - r_a)};
}

inline Vec2 relative_velocity(const AnchorsNow& at, const Motion& a, const Motion& b) {
    return (b.v + cross(b.w, at.r_b)) - (a.v + cross(a.w, at.r_a));
}

inline void apply_impulse(const AnchorsNow& at, Motion& a, Motion& b, Vec2 impulse) {
    a.v -= velocity_change(a, impulse);
    a.w -= a.inverse_inertia * cross(at.r_a, impulse);
    b.v += velocity_change(b, impulse);
    b.w += b.inverse_inertia * cross(at.r_b, impulse);
}

inline void apply_angular_impulse(Motion& a, Motion& b, float impulse) {
    a.w -= a.inverse_inertia * impulse;
    b.w += b.inverse_inertia * impulse;
}

}  // namespace cairn::physics
