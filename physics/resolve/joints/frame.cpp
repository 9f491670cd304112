// Three directions that several kinds share: x and y of anchor b against anchor a, and the angle between the
// frames.
//     q = d,    J v = vB + wB x rB - vA - wA x rA;        q = angle,    J v = wB - wA
// The axes are those of the world, or, of springs that have a stiffness along each, turn with body a
// (spring_mobility.h).
#include "resolve/joints/directions.h"
#include "resolve/joints/kinds.h"

namespace cairn::physics {

void place_frame(const JointConstraint& c, const Motions& motions, Directions& out) {
    const AnchorsNow at = anchors_now(c.anchors, motions);
    if (c.turns_with_a) {
        const Vec2 u = rotate(motions.turned[c.anchors.a], c.axis);
        out[0] = carried_axis(at, u);
        out[1] = carried_axis(at, left_perp(u));
    } else {
        out[0] = fixed_axis(at, {1, 0});
        out[1] = fixed_axis(at, {0, 1});
    }
    if (c.directions > 2) out[2] = relative_angle(c, at);
}

}  // namespace cairn::physics
