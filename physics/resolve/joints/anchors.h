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
    Vec2 offset;     // anchor b minus anchor a
    float turn = 0;  // of b relative to a since the start of the step, rad
};

inline AnchorsNow anchors_now(const JointAnchors& j, const Motions& motions) {
    const Vec2 r_a = rotate(motions.turned[j.a], j.r_a);
    const Vec2 r_b = rotate(motions.turned[j.b], j.r_b);
    return {r_a, r_b, (motions.pose[j.b].d - motions.pose[j.a].d) + j.center_offset + (r_b - r_a),
            motions.angle(j.b) - motions.angle(j.a)};
}

}  // namespace cairn::physics
