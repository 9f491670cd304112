// Where the frames of a joint are on its bodies and in the world.
#pragma once

#include "world/body_store.h"
#include "world/joint_store.h"

namespace cairn::physics {

/// Origin and angle of both frames, each in the coordinates of its body.
struct JointFrames {
    Vec2 anchor_a_m;
    Vec2 anchor_b_m;
    float angle_a_rad = 0;
    float angle_b_rad = 0;
};

/// Gears and filters have none: their frames are those of the bodies.
JointFrames frames_of(const JointDef& def);

/// Of frame b relative to frame a, rad, now: the one of all angles whole turns apart that is nearest to the
/// angle that the joint had, which is in the record while the joint has no lane.
double joint_angle(const BodyStore& bodies, const JointRecord& joint, double last_angle_rad);
inline double joint_angle(const BodyStore& bodies, const JointRecord& joint) {
    return joint_angle(bodies, joint, joint.angle_rad);
}

/// Of anchor b along the x axis of frame a, m.
float joint_translation(const BodyStore& bodies, const JointRecord& joint);

/// What a gear counts: the angle of a revolute joint, the translation of a prismatic one.
double gear_coordinate(const BodyStore& bodies, const JointRecord& joint);

Position anchor_a(const BodyStore& bodies, const JointRecord& joint);
Position anchor_b(const BodyStore& bodies, const JointRecord& joint);

}  // namespace cairn::physics
