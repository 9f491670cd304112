// Joints of which the anchors are far apart, as after one of their bodies was put elsewhere. A velocity that
// closed such a gap would be one of hundreds of m/s, and what turns meanwhile keeps turning. So they are
// solved as if they were closed, and their bodies are moved together when the substeps are over.
// Invariant: moving together changes no velocity and turns nothing, and the centre of mass of a pair stays
// where it is. Springs are left to their forces, and so are joints of a softness of their own, which may give
// as far as they like.
#pragma once

#include <span>

#include "resolve/joints/joint_constraint.h"

namespace cairn::physics {

/// m. Joints further open are torn. Large structures that sag under a load too great for sweeping must not
/// be: only the pull of their joints holds them.
inline constexpr float kTorn_m = 4;

struct TornJoint {
    int a;  ///< rows
    int b;
    Vec2 r_a;  ///< centre of mass to anchor, at the start of the step
    Vec2 r_b;
    Vec2 apart;  ///< m, by which b is off against a, then
    Vec2 axis;   ///< unit, along which alone the joint holds; 0 when it holds a point
};

/// Whether the joint is torn: then it is hidden from the solver, and `torn` says how it was.
bool hide_tear(JointConstraint& c, TornJoint& torn);

/// Moves the bodies of each joint together, after the substeps.
void close_tears(std::span<const TornJoint> joints, Motions& motions);

}  // namespace cairn::physics
