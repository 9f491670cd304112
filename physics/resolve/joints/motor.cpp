// The motor joint: springs or speeds for x and y together and for the angle, under caps. What acts in frame a
// is given in the frame, and solved in the axes of the world, or of springs where both are
// (spring_mobility.h). The offset to go to is part of the arm on a.
#include "resolve/joints/kinds.h"

namespace cairn::physics {

void describe(JointConstraint& c, const MotorJointDef& def, const JointStart& start) {
    c.directions = 3;
    LawBuilder laws(c, start.h_s);
    if (def.angular_frequency_hz > 0) {
        laws.spring(2, 1,
                    {.frequency_hz = def.angular_frequency_hz,
                     .damping_ratio = def.angular_damping_ratio,
                     .target = start.angle(def.target_angle_rad),
                     .low = -def.max_torque_nm,
                     .high = def.max_torque_nm});
    } else {
        laws.motor(2, def.angular_velocity_rad_s, def.max_torque_nm);
    }
    if (def.linear_frequency_hz > 0) {
        c.turns_with_a = def.angular_frequency_hz > 0;
        laws.spring(0, 2,
                    {.frequency_hz = def.linear_frequency_hz,
                     .damping_ratio = def.linear_damping_ratio,
                     .high = def.max_force_n});
    } else {
        laws.motor(0, rotate(start.frame_a, def.linear_velocity_m_s), def.max_force_n);
    }
}

}  // namespace cairn::physics
