// The revolute joint: x and y are held, and a spring, a motor and limits act on the angle.
// Source: Catto, "Modeling and Solving Constraints", GDC 2009.
#include "resolve/joints/kinds.h"

namespace cairn::physics {

void describe(JointConstraint& c, const RevoluteJointDef& def, const JointStart& start) {
    c.directions = def.enable_spring || def.enable_motor || def.enable_limit ? 3 : 2;
    LawBuilder laws(c, start.h_s);
    if (def.enable_spring) {
        laws.spring(2, 1,
                    {.frequency_hz = def.frequency_hz,
                     .damping_ratio = def.damping_ratio,
                     .target = start.angle(def.target_rad)});
    }
    if (def.enable_motor) laws.motor(2, def.motor_speed_rad_s, def.max_motor_torque_nm);
    if (def.enable_limit)
        laws.limits(2, start.angle(def.lower_rad), start.angle(def.upper_rad), def.stiffness);
    laws.hold(0, 2, 0, def.stiffness);
}

}  // namespace cairn::physics
