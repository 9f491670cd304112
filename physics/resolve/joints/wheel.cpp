// The wheel joint. Glossary: u axis of the suspension on body a, n the axis turned left, d offset of the
// anchors.
//     held:   q = n . d;    suspension:   q = u . d;    motor:   J v = wB - wA
#include "resolve/joints/directions.h"
#include "resolve/joints/kinds.h"

namespace cairn::physics {

void describe(JointConstraint& c, const WheelJointDef& def, const JointStart& start) {
    c.axis = rotate(start.frame_a, {1, 0});
    c.directions = def.enable_motor ? 3 : 2;
    LawBuilder laws(c, start.h_s);
    if (def.enable_spring) {
        laws.spring(
            1, 1,
            {.frequency_hz = def.frequency_hz, .damping_ratio = def.damping_ratio, .target = def.target_m});
    }
    if (def.enable_motor) laws.motor(2, def.motor_speed_rad_s, def.max_motor_torque_nm);
    if (def.enable_limit) laws.limits(1, def.lower_m, def.upper_m, def.stiffness);
    laws.hold(0, 1, 0, def.stiffness);
}

void place_wheel(const JointConstraint& c, const Motions& motions, Directions& out) {
    const AnchorsNow at = anchors_now(c.anchors, motions);
    const Vec2 u = rotate(motions.turned[c.anchors.a], c.axis);
    out[0] = carried_axis(at, left_perp(u));
    out[1] = carried_axis(at, u);
    if (c.directions > 2) out[2] = relative_angle(c, at);
}

}  // namespace cairn::physics
