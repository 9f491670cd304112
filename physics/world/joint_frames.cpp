// Frames and coordinates of joints.
#include "world/joint_frames.h"

#include <cmath>

namespace cairn::physics {
namespace {

constexpr double kTurn_rad = 2 * 3.14159265358979323846;

JointFrames frames(const DistanceJointDef& d) {
    return {d.local_anchor_a_m, d.local_anchor_b_m};
}
JointFrames frames(const RevoluteJointDef& d) {
    return {d.local_anchor_a_m, d.local_anchor_b_m, d.local_angle_a_rad, d.local_angle_b_rad};
}
JointFrames frames(const PrismaticJointDef& d) {
    return {d.local_anchor_a_m, d.local_anchor_b_m, d.local_angle_a_rad, d.local_angle_b_rad};
}
JointFrames frames(const WeldJointDef& d) {
    return {d.local_anchor_a_m, d.local_anchor_b_m, d.local_angle_a_rad, d.local_angle_b_rad};
}
JointFrames frames(const WheelJointDef& d) {
    return {d.local_anchor_a_m, d.local_anchor_b_m, d.local_angle_a_rad, 0};
}
JointFrames frames(const MotorJointDef& d) {
    const Vec2 offset =
        rotate(Rotation::from_angle(static_cast<double>(d.local_angle_a_rad)), d.target_offset_m);
    return {d.local_anchor_a_m + offset, d.local_anchor_b_m, d.local_angle_a_rad, d.local_angle_b_rad};
}
JointFrames frames(const MouseJointDef& d) {
    return {d.local_target_m, d.local_anchor_b_m};
}
JointFrames frames(const GearJointDef&) {
    return {};
}
JointFrames frames(const PulleyJointDef& d) {
    return {d.local_anchor_a_m, d.local_anchor_b_m};
}
JointFrames frames(const FrictionJointDef& d) {
    return {d.local_anchor_a_m, d.local_anchor_b_m};
}
JointFrames frames(const FilterJointDef&) {
    return {};
}

}  // namespace

JointFrames frames_of(const JointDef& def) {
    return std::visit([](const auto& d) { return frames(d); }, def);
}

double joint_angle(const BodyStore& bodies, const JointRecord& joint, double last_angle_rad) {
    const JointFrames frame = frames_of(joint.def);
    const Rotation turn =
        inverse(bodies.places[joint.body_a].rotation) * bodies.places[joint.body_b].rotation;
    const double angle = deterministic::atan2(static_cast<double>(turn.s), static_cast<double>(turn.c)) +
                         static_cast<double>(frame.angle_b_rad) - static_cast<double>(frame.angle_a_rad);
    return angle + kTurn_rad * std::round((last_angle_rad - angle) / kTurn_rad);
}

float joint_translation(const BodyStore& bodies, const JointRecord& joint) {
    const Rotation frame_a = bodies.places[joint.body_a].rotation *
                             Rotation::from_angle(static_cast<double>(frames_of(joint.def).angle_a_rad));
    return dot(anchor_b(bodies, joint) - anchor_a(bodies, joint), rotate(frame_a, {1, 0}));
}

double gear_coordinate(const BodyStore& bodies, const JointRecord& joint) {
    if (kind_of(joint) == JointKind::Revolute) return joint_angle(bodies, joint);
    return static_cast<double>(joint_translation(bodies, joint));
}

Position anchor_a(const BodyStore& bodies, const JointRecord& joint) {
    return transform_point(bodies.transform(joint.body_a), frames_of(joint.def).anchor_a_m);
}

Position anchor_b(const BodyStore& bodies, const JointRecord& joint) {
    return transform_point(bodies.transform(joint.body_b), frames_of(joint.def).anchor_b_m);
}

}  // namespace cairn::physics
