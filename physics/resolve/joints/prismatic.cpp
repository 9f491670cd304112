// The prismatic joint. Glossary: u axis on body a, n the axis turned left, d offset of the anchors.
//     held:   q = n . d  and the angle;    free:   q = u . d
// Both axes turn with a, so the lever on a reaches to anchor b (directions.h).
#include "resolve/joints/directions.h"
#include "resolve/joints/kinds.h"

namespace cairn::physics {

void describe(JointConstraint& c, const PrismaticJointDef& def, const JointStart& start) {
    c.axis = rotate(start.frame_a, {1, 0});
    c.directions = 3;
    LawBuilder laws(c, start.h_s);
    if (def.enable_spring) {
        laws.spring(
            2, 1,
            {.frequency_hz = def.frequency_hz, .damping_ratio = def.damping_ratio, .target = def.target_m});
    }
    if (def.enable_motor) laws.motor(2, def.motor_speed_m_s, def.max_motor_force_n);
    if (def.enable_limit) laws.limits(2, def.lower_m, def.upper_m, def.stiffness);
    laws.hold(0, 2, 0, def.stiffness);
}

void place_prismatic(const JointConstraint& c, const Motions& motions, Directions& out) {
    const AnchorsNow at = anchors_now(c.anchors, motions);
    const Vec2 u = rotate(motions.turned[c.anchors.a], c.axis);
    out[0] = carried_axis(at, left_perp(u));
    out[1] = relative_angle(c, at);
    out[2] = carried_axis(at, u);
}

}  // namespace cairn::physics
