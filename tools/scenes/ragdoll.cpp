// Bones are capsules along y, pinned to their parents, with limits, a weak spring and a motor that brakes.
#include "ragdoll.h"

#include <numbers>

namespace cairn::bench {

using physics::Capsule;
using physics::Polygon;
using physics::Position;
using physics::RevoluteJointDef;
using physics::ShapeDef;
using physics::Vec2;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kNoParent = -1;

struct Bone {
    int parent;
    float y_m;  // of the body's origin above the figure's
    float low_m;
    float high_m;  // ends of the capsule above the body's origin
    float radius_m;
    float pivot_y_m;  // above the figure's origin
    float lower;      // limits, in half turns
    float upper;
    float frame;     // angle of frame a, in half turns
    float friction;  // share of the joint friction
    float damping_1_s;
    bool foot;
};

constexpr Bone kHip{kNoParent, 0.95f, -0.02f, 0.02f, 0.095f, 0, 0, 0, 0, 0, 0, false};
constexpr Bone kTorso{0, 1.2f, -0.135f, 0.135f, 0.09f, 1, -0.25f, 0, 0, 0.5f, 0, false};
constexpr Bone kHead{1, 1.475f, -0.038f, 0.039f, 0.075f, 1.4f, -0.3f, 0.1f, 0, 0.25f, 0.1f, false};

constexpr Bone upper_leg() {
    return {0, 0.775f, -0.125f, 0.125f, 0.06f, 0.9f, -0.05f, 0.4f, 0, 1, 0, false};
}
constexpr Bone lower_leg(int parent) {
    return {parent, 0.475f, -0.155f, 0.125f, 0.045f, 0.625f, -0.5f, -0.02f, 0, 0.5f, 0, true};
}
constexpr Bone upper_arm() {
    return {1, 1.225f, -0.125f, 0.125f, 0.035f, 1.35f, -0.1f, 0.8f, 0, 0.5f, 0, false};
}
constexpr Bone lower_arm(int parent) {
    return {parent, 0.975f, -0.125f, 0.125f, 0.03f, 1.1f, -0.2f, 0.3f, 0.25f, 0.1f, 0.1f, false};
}

constexpr std::array<Bone, kBones> kSkeleton{kHip,         kTorso,      kHead,        upper_leg(),
                                             lower_leg(3), upper_leg(), lower_leg(5), upper_arm(),
                                             lower_arm(7), upper_arm(), lower_arm(9)};

constexpr std::array kFoot{Vec2{-0.03f, -0.185f}, Vec2{0.11f, -0.185f}, Vec2{0.11f, -0.16f},
                           Vec2{-0.03f, -0.14f}};
constexpr float kMostFriction_nm = 0.05f;

void pin(Engine& engine, const Ragdoll& figure, int i) {
    const Bone& bone = kSkeleton[static_cast<std::size_t>(i)];
    const auto parent = static_cast<std::size_t>(bone.parent);
    engine.add_revolute(figure[parent], figure[static_cast<std::size_t>(i)],
                        {.local_anchor_a_m = {0, bone.pivot_y_m - kSkeleton[parent].y_m},
                         .local_anchor_b_m = {0, bone.pivot_y_m - bone.y_m},
                         .local_angle_a_rad = bone.frame * kPi,
                         .enable_limit = true,
                         .lower_rad = bone.lower * kPi,
                         .upper_rad = bone.upper * kPi,
                         .enable_motor = true,
                         .max_motor_torque_nm = bone.friction * kMostFriction_nm,
                         .enable_spring = true,
                         .frequency_hz = 5,
                         .damping_ratio = 0.5f});
}

}  // namespace

Ragdoll add_ragdoll(Engine& engine, Position position_m, int group) {
    const ShapeDef skin{.material = {.friction = 0.2f},
                        .filter = {.categories = kBoneCategory, .mask = 1 | kBoneCategory, .group = -group}};
    const ShapeDef sole{.material = {.friction = 0.05f},
                        .filter = {.categories = kBoneCategory, .mask = 1, .group = -group}};
    Ragdoll figure;
    for (int i = 0; i < kBones; ++i) {
        const Bone& bone = kSkeleton[static_cast<std::size_t>(i)];
        const BodyRef body = engine.add({.position_m = position_m + Vec2{0, bone.y_m},
                                         .linear_damping_1_s = bone.damping_1_s,
                                         .sleep_speed_m_s = 0.1f},
                                        Capsule{{0, bone.low_m}, {0, bone.high_m}, bone.radius_m}, skin);
        if (bone.foot) engine.add_shape(body, Polygon{.points_m = kFoot, .radius_m = 0.015f}, sole);
        figure[static_cast<std::size_t>(i)] = body;
        if (bone.parent != kNoParent) pin(engine, figure, i);
    }
    return figure;
}

}  // namespace cairn::bench
