// The weld joint: x, y and the angle are held together, or the point and the angle apart, each rigid or a
// spring.
#include "resolve/joints/kinds.h"

namespace cairn::physics {

void describe(JointConstraint& c, const WeldJointDef& def, const JointStart& start) {
    c.directions = 3;
    LawBuilder laws(c, start.h_s);
    const bool rigid_point = def.linear_frequency_hz == 0;
    const bool rigid_angle = def.angular_frequency_hz == 0;
    if (rigid_point && rigid_angle) {
        laws.hold(0, 3, 0, def.stiffness);
        return;
    }
    if (rigid_angle) {
        laws.hold(2, 1, 0, def.stiffness);
    } else {
        laws.spring(2, 1,
                    {.frequency_hz = def.angular_frequency_hz, .damping_ratio = def.angular_damping_ratio});
    }
    if (rigid_point) {
        laws.hold(0, 2, 0, def.stiffness);
    } else {
        c.turns_with_a = true;
        laws.spring(0, 2,
                    {.frequency_hz = def.linear_frequency_hz, .damping_ratio = def.linear_damping_ratio});
    }
}

}  // namespace cairn::physics
