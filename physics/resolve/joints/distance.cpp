// The distance joint. Glossary: d offset of the anchors, u = d/|d|.
//     q = |d|,    J v = u . (vB + wB x rB - vA - wA x rA)
// J is made from the arms as they are now: an effective mass kept from the start of the step is too large by
// up to r^2/I m when an arm has turned across the line since, and the impulses then explode. Source: Catto,
// "Modeling and Solving Constraints", GDC 2009.
#include "resolve/joints/directions.h"
#include "resolve/joints/kinds.h"

namespace cairn::physics {
namespace {

// m. Anchors nearer than this have no direction; the one of the start of the step, or straight up, serves
// then.
constexpr float kCoincident_m = 1e-6f;

}  // namespace

void describe(JointConstraint& c, const DistanceJointDef& def, const JointStart& start) {
    const Vec2 offset = c.anchors.center_offset + (c.anchors.r_b - c.anchors.r_a);
    c.axis = length(offset) > kCoincident_m ? normalized(offset) : Vec2{0, 1};
    c.directions = 1;
    LawBuilder laws(c, start.h_s);
    if (!def.enable_spring) {
        laws.hold(0, 1, def.length_m, def.stiffness);
        return;
    }
    // A spring that pulls has a negative impulse on b along u.
    laws.spring(0, 1,
                {.frequency_hz = def.frequency_hz,
                 .damping_ratio = def.damping_ratio,
                 .target = def.length_m,
                 .low = -def.max_spring_force_n,
                 .high = -def.min_spring_force_n});
    laws.limits(0, def.min_length_m > 0 ? def.min_length_m : -kUnlimited, def.max_length_m, def.stiffness);
}

void place_distance(const JointConstraint& c, const Motions& motions, Directions& out) {
    const AnchorsNow at = anchors_now(c.anchors, motions);
    const float distance = length(at.offset);
    const Vec2 u = distance > kCoincident_m ? (1 / distance) * at.offset : c.axis;
    out[0] = fixed_axis(at, u);
    out[0].q = distance;
}

}  // namespace cairn::physics
