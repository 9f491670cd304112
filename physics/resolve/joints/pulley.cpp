// The pulley. Glossary: e offset of an anchor from its wheel, u = e/|e|, k ratio.
//     q = |eA| + k |eB| <= rope,    J v = uA . (vA + wA x rA) + k uB . (vB + wB x rB)
#include "resolve/joints/kinds.h"

namespace cairn::physics {
namespace {

struct Side {
    Jacobian j;
    float length_m;
};

Side side_of(Vec2 from_wheel, Vec2 arm, int row, const Motions& motions) {
    const Vec2 arm_now = rotate(motions.turned[row], arm);
    const Vec2 e = from_wheel + motions.pose[row].d + (arm_now - arm);
    const Vec2 u = normalized(e);  // at the wheel itself it points nowhere, and nothing is pulled
    return {{u, cross(arm_now, u)}, length(e)};
}

}  // namespace

void describe(JointConstraint& c, const PulleyJointDef& def, const JointStart& start) {
    c.directions = 1;
    c.ratio = def.ratio;
    LawBuilder(c, start.h_s).limits(0, -kUnlimited, def.length_m, def.stiffness);
}

void place_pulley(const JointConstraint& c, const Motions& motions, Directions& out) {
    const Side a = side_of(c.from_wheel_a, c.anchors.r_a, c.anchors.a, motions);
    const Side b = side_of(c.from_wheel_b, c.anchors.r_b, c.anchors.b, motions);
    out[0].j[0] = a.j;
    out[0].j[1] = {c.ratio * b.j.linear, c.ratio * b.j.angular};
    out[0].q = a.length_m + c.ratio * b.length_m;
}

}  // namespace cairn::physics
