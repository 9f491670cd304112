// The friction joint: a motor that drives at rest, with the greatest force that friction has.
#include "resolve/joints/kinds.h"

namespace cairn::physics {

void describe(JointConstraint& c, const FrictionJointDef& def, const JointStart& start) {
    c.directions = 3;
    LawBuilder laws(c, start.h_s);
    laws.motor(2, 0, def.max_torque_nm);
    laws.motor(0, Vec2{}, def.max_force_n);
}

}  // namespace cairn::physics
