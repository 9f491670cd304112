// The mouse joint: a spring that draws a point to a target, with no more than its greatest force.
#include "resolve/joints/kinds.h"

namespace cairn::physics {

void describe(JointConstraint& c, const MouseJointDef& def, const JointStart& start) {
    c.directions = 2;
    LawBuilder laws(c, start.h_s);
    laws.spring(
        0, 2,
        {.frequency_hz = def.frequency_hz, .damping_ratio = def.damping_ratio, .high = def.max_force_n});
}

}  // namespace cairn::physics
