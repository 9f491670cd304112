// Closing torn joints.
#include "resolve/joints/torn_joints.h"

namespace cairn::physics {
namespace {

bool holds_rigidly(const JointConstraint& c) {
    for (int l = 0; l < c.law_count; ++l) {
        const JointLaw& law = c.laws[static_cast<std::size_t>(l)];
        if (law.kind == LawKind::Hold && law.direction == 0 && law.rigid) return true;
    }
    return false;
}

// By what b's anchor is off, and the axis as in TornJoint.
struct Tear {
    Vec2 apart;
    Vec2 axis;
};

Tear tear_of(const JointConstraint& c) {
    const Vec2 offset = c.anchors.center_offset + (c.anchors.r_b - c.anchors.r_a);
    switch (c.kind) {
        case JointKind::Revolute:
        case JointKind::Weld:
            return {offset, {}};
        case JointKind::Prismatic:
        case JointKind::Wheel: {
            const Vec2 normal = left_perp(c.axis);
            return {dot(offset, normal) * normal, normal};
        }
        case JointKind::Distance:
            // Held at the length is what the first law says.
            return {(length(offset) - c.laws[0].target) * c.axis, c.axis};
        default:
            return {};
    }
}

Vec2 turned_by(const Motions& motions, int row, Vec2 arm) {
    return rotate(Rotation::from_small_angle(motions.angle(row)), arm) - arm;
}

Vec2 movable(const Motions& motions, int row, Vec2 v) {
    return without_locked(motions.velocity[static_cast<std::size_t>(row)].inverse_mass * v,
                          motions.locked_axes(row));
}

}  // namespace

bool hide_tear(JointConstraint& c, TornJoint& torn) {
    const Tear tear = tear_of(c);
    if (!(length_squared(tear.apart) > kTorn_m * kTorn_m) || !holds_rigidly(c)) return false;
    torn = {c.anchors.a, c.anchors.b, c.anchors.r_a, c.anchors.r_b, tear.apart, tear.axis};
    c.anchors.center_offset -= tear.apart;
    return true;
}

void close_tears(std::span<const TornJoint> joints, Motions& motions) {
    for (const TornJoint& j : joints) {
        PoseRow& a = motions.pose[static_cast<std::size_t>(j.a)];
        PoseRow& b = motions.pose[static_cast<std::size_t>(j.b)];
        Vec2 apart = j.apart + (b.d - a.d) + turned_by(motions, j.b, j.r_b) - turned_by(motions, j.a, j.r_a);
        if (j.axis != Vec2{}) apart = dot(apart, j.axis) * j.axis;
        const Vec2 shift_a = movable(motions, j.a, apart);
        const Vec2 shift_b = movable(motions, j.b, apart);
        const float k = dot(shift_a + shift_b, apart);
        const float impulse = length_squared(apart) / k;
        // Beyond all measure: what cannot be moved would take no number, and all that touches it.
        if (!(k > 0) || !is_finite(impulse)) continue;
        a.d += impulse * shift_a;
        b.d -= impulse * shift_b;
    }
}

}  // namespace cairn::physics
