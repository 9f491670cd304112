// The gear: the coordinates of two joints, each an angle or a translation, keep a sum.
//     q = q1 + k q2,    J = J1 + k J2
// J reaches up to four bodies. One that is in both joints has the sum of both parts.
#include "resolve/joints/kinds.h"

namespace cairn::physics {
namespace {

// The direction that a revolute or prismatic joint leaves free.
Direction free_direction(const JointConstraint& c, const Motions& motions) {
    Directions directions;
    if (c.kind == JointKind::Prismatic) {
        place_prismatic(c, motions, directions);
        return directions[2];
    }
    const float turn = motions.angle(c.anchors.b) - motions.angle(c.anchors.a);
    return {{{{{}, -1}, {{}, 1}}}, turn};
}

}  // namespace

void describe_gear(JointConstraint& c, const GearJointDef& def, float held, const JointStart& start) {
    c.directions = 1;
    c.ratio = def.ratio;
    LawBuilder(c, start.h_s).hold(0, 1, held, def.stiffness);
}

void place_gear(const JointConstraint& c, std::span<const JointConstraint> all, const Motions& motions,
                Directions& out) {
    out[0] = {};
    for (int i = 0; i < 2; ++i) {
        const float k = i == 0 ? 1 : c.ratio;
        const Direction part = free_direction(all[static_cast<std::size_t>(c.geared[i])], motions);
        out[0].q += k * part.q;
        for (int side = 0; side < 2; ++side) {
            Jacobian& j = out[0].j[c.geared_rows[2 * i + side]];
            j.linear += k * part.j[side].linear;
            j.angular += k * part.j[side].angular;
        }
    }
}

}  // namespace cairn::physics
