// How stiff springs are. Users say frequencies, w, and a spring of the stiffness k = w^2/K, with K = J 1/M
// J^T, swings with that. But K depends on how the bodies stand to each other, and a force that is as stiff as
// K says at the moment is that of no energy: what goes round through poses may come back with more of it,
// again and again. Seven boxes on undamped springs of 2 Hz at arms of a metre had ten thousand times their
// energy after a minute. So k is what it is where the spring rests, in all poses:
//     distance joints:        as the bodies stood when the spring was set (JointRecord::line_a, line_b)
//     weld and motor joints:  where both frames are one. x and y turn with body a, and are the principal axes
//                             of K, so that each has a k of its own; their levers reach to anchor b, so that
//                             the force turns the two as a whole by nothing (directions.h)
//     rails, angles:          K is the same in all poses, or, for wheels out of their centre, as it is now
// What draws two points together whatever their angle (mouse joints, and motor joints that turn) has no such
// pose, and is as stiff as K says now.
#pragma once

#include <span>

#include "resolve/joints/joint_constraint.h"

namespace cairn::physics {

/// What a body is to a joint: its masses, whatever axes are locked, and from its centre of mass to the
/// anchor.
struct SpringEnd {
    float inverse_mass = 0;
    float inverse_inertia = 0;
    Vec2 arm;
};

/// Of a spring along a line; the line and the arm of each end in coordinates of their own.
float mobility_along(const SpringEnd& a, Vec2 line_a, const SpringEnd& b, Vec2 line_b);

/// Of a spring between two points that rest upon each other; both arms in the same coordinates.
struct PrincipalMobility {
    Vec2 axis{1, 0};  // along which K is greatest; left of it, least
    SpringMobility k;
};
PrincipalMobility principal_mobility(const SpringEnd& a, const SpringEnd& b);

/// The greatest eigenvalue of a symmetric matrix.
double greatest_eigenvalue(double xx, double xy, double yy);

/// The one of a spring, or K as it is now.
SpringMobility mobility_of(const JointLaw& spring, const JointPlace& place);

/// Where mobilities are set, those at rest: sets them, frequencies and damping ratios to those that the same
/// springs have as their bodies stand now; along two directions, to those of the one in which it is stiffest.
void weigh_springs(std::span<JointConstraint> joints, std::span<const JointPlace> places);

}  // namespace cairn::physics
