// Which kind has which directions.
#include "resolve/joints/kinds.h"

namespace cairn::physics {

void place(const JointConstraint& c, std::span<const JointConstraint> all, const Motions& motions,
           Directions& out) {
    switch (c.kind) {
        case JointKind::Distance:
            return place_distance(c, motions, out);
        case JointKind::Prismatic:
            return place_prismatic(c, motions, out);
        case JointKind::Wheel:
            return place_wheel(c, motions, out);
        case JointKind::Pulley:
            return place_pulley(c, motions, out);
        case JointKind::Gear:
            return place_gear(c, all, motions, out);
        case JointKind::Revolute:
        case JointKind::Weld:
        case JointKind::Motor:
        case JointKind::Mouse:
        case JointKind::Friction:
            return place_frame(c, motions, out);
        case JointKind::Filter:
            return;
    }
}

}  // namespace cairn::physics
