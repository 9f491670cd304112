// The kinds of joints, one file each: the laws that a definition asks for, and where the directions point
// now.
//
// `describe` is called once per step, with the anchors, the axis and the bodies of the constraint set;
// `place_*` at its start and before each relaxing pass.
#pragma once

#include <span>

#include "resolve/joints/joint_constraint.h"
#include "resolve/joints/laws.h"

namespace cairn::physics {

void describe(JointConstraint& c, const DistanceJointDef& def, const JointStart& start);
void describe(JointConstraint& c, const RevoluteJointDef& def, const JointStart& start);
void describe(JointConstraint& c, const PrismaticJointDef& def, const JointStart& start);
void describe(JointConstraint& c, const WeldJointDef& def, const JointStart& start);
void describe(JointConstraint& c, const WheelJointDef& def, const JointStart& start);
void describe(JointConstraint& c, const MotorJointDef& def, const JointStart& start);
void describe(JointConstraint& c, const MouseJointDef& def, const JointStart& start);
void describe(JointConstraint& c, const PulleyJointDef& def, const JointStart& start);
void describe(JointConstraint& c, const FrictionJointDef& def, const JointStart& start);
/// held: what the gear holds constant, less what its two coordinates are at the start of the step.
void describe_gear(JointConstraint& c, const GearJointDef& def, float held, const JointStart& start);

void place_distance(const JointConstraint& c, const Motions& motions, Directions& out);
void place_prismatic(const JointConstraint& c, const Motions& motions, Directions& out);
void place_wheel(const JointConstraint& c, const Motions& motions, Directions& out);
void place_pulley(const JointConstraint& c, const Motions& motions, Directions& out);
/// x, y and angle of frame b against frame a: revolute, weld, motor, mouse and friction joints.
void place_frame(const JointConstraint& c, const Motions& motions, Directions& out);
/// `all` holds the constraints of the two joints.
void place_gear(const JointConstraint& c, std::span<const JointConstraint> all, const Motions& motions,
                Directions& out);

/// Whichever of them it is.
void place(const JointConstraint& c, std::span<const JointConstraint> all, const Motions& motions,
           Directions& out);

}  // namespace cairn::physics
