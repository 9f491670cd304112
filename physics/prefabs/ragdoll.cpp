// Bones are upright capsules in one line; each hangs from its parent by a pin with limits and friction. The
// measures and limits are those of the common test scene of 2D engines ("rain").
#include <cairn/physics/prefabs/ragdoll.h>

#include "prefabs/builder.h"

namespace cairn::physics {
namespace {

struct BoneDef {
    int parent;
    float y_m;            // of the bone's origin, over the feet
    float low_m, high_m;  // of the capsule's ends, from there
    float radius_m;
    float pivot_m;       // over the feet
    float lower, upper;  // limits, in units of pi
    float friction;      // share of the friction
    float frame_a = 0;   // angle of the limits' 0, in units of pi
    float damping_1_s = 0;
    bool has_foot = false;
};

constexpr BoneDef kHip{-1, .95f, -.02f, .02f, .095f, 0, 0, 0, 0};
constexpr BoneDef kTorso{0, 1.2f, -.135f, .135f, .09f, 1.0f, -.25f, 0, .5f};
constexpr BoneDef kHead{1, 1.475f, -.038f, .039f, .075f, 1.4f, -.3f, .1f, .25f, 0, .1f};
constexpr BoneDef kUpperLeg{0, .775f, -.125f, .125f, .06f, .9f, -.05f, .4f, 1};
constexpr BoneDef lower_leg(int parent) {
    return {parent, .475f, -.155f, .125f, .045f, .625f, -.5f, -.02f, .5f, 0, 0, true};
}
constexpr BoneDef kUpperArm{1, 1.225f, -.125f, .125f, .035f, 1.35f, -.1f, .8f, .5f};
constexpr BoneDef lower_arm(int parent) {
    return {parent, .975f, -.125f, .125f, .03f, 1.1f, -.2f, .3f, .1f, .25f, .1f};
}

// In the order of Bone.
constexpr std::array<BoneDef, kBoneCount> kBones = {
    kHip,         kTorso,    kHead,        kUpperLeg, lower_leg(3), kUpperLeg,
    lower_leg(5), kUpperArm, lower_arm(7), kUpperArm, lower_arm(9),
};

constexpr std::array<Vec2, 4> kFoot = {Vec2{-.03f, -.185f}, {.11f, -.185f}, {.11f, -.16f}, {-.03f, -.14f}};
constexpr float kFootRadius_m = 0.015f;
constexpr float kFootFriction = 0.05f;
constexpr float kSleepSpeed_m_s = 0.1f;

/// Of its own: below all that a game is likely to count.
std::int32_t own_group(BodyId hip) {
    return -(std::int32_t{1} << 30) - static_cast<std::int32_t>(hip.index1);
}

}  // namespace

Result<Ragdoll> create_ragdoll(World& world, const RagdollDef& def) {
    Builder builder(world);
    builder.require({
        check::finite("ragdoll.position_m", def.position_m),
        check::positive("ragdoll.scale", as_double(def.scale)),
        check::not_negative("ragdoll.friction_torque_nm", as_double(def.friction_torque_nm)),
        check::not_negative("ragdoll.spring_hz", as_double(def.spring_hz)),
        check::not_negative("ragdoll.spring_damping", as_double(def.spring_damping)),
    });
    const float s = def.scale;
    ShapeDef shape = def.shape;
    std::array<BodyId, kBoneCount> bones{};
    for (std::size_t i = 0; i < kBones.size(); ++i) {
        const BoneDef& bone = kBones[i];
        bones[i] = builder.body({.position_m = def.position_m + Vec2{0, s * bone.y_m},
                                 .linear_velocity_m_s = def.velocity_m_s,
                                 .linear_damping_1_s = bone.damping_1_s,
                                 .sleep_speed_m_s = kSleepSpeed_m_s});
        shape.filter.group = def.group != 0 ? def.group : own_group(bones[0]);
        builder.shape(
            bones[i],
            Capsule{.a_m = {0, s * bone.low_m}, .b_m = {0, s * bone.high_m}, .radius_m = s * bone.radius_m},
            shape);
        if (bone.has_foot) {
            std::array<Vec2, 4> foot = kFoot;
            for (Vec2& point : foot) point *= s;
            ShapeDef sole = shape;
            sole.material.friction = kFootFriction;
            builder.shape(bones[i], Polygon{.points_m = foot, .radius_m = s * kFootRadius_m}, sole);
        }
    }
    for (std::size_t i = 1; i < kBones.size(); ++i) {
        const BoneDef& bone = kBones[i];
        RevoluteJointDef joint;
        builder.place(joint, bones[static_cast<std::size_t>(bone.parent)], bones[i],
                      def.position_m + Vec2{0, s * bone.pivot_m});
        joint.local_angle_a_rad = kPi * bone.frame_a;
        joint.enable_limit = true;
        joint.lower_rad = kPi * bone.lower;
        joint.upper_rad = kPi * bone.upper;
        joint.enable_motor = def.friction_torque_nm > 0;
        joint.max_motor_torque_nm = def.friction_torque_nm * bone.friction * s * s * s;
        joint.enable_spring = def.spring_hz > 0;
        if (joint.enable_spring) joint.frequency_hz = def.spring_hz;
        joint.damping_ratio = def.spring_damping;
        builder.joint(joint);
    }
    return builder.finish(Ragdoll{});
}

}  // namespace cairn::physics
