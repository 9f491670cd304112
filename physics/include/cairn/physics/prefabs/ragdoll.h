// A human figure of eleven bones that falls as a limp body does, facing right.
#pragma once

#include <array>

#include <cairn/physics/prefabs/prefab.h>

namespace cairn::physics {

enum class Bone : std::uint8_t {
    Hip,
    Torso,
    Head,
    UpperLegLeft,
    LowerLegLeft,
    UpperLegRight,
    LowerLegRight,
    UpperArmLeft,
    LowerArmLeft,
    UpperArmRight,
    LowerArmRight,
};
inline constexpr int kBoneCount = 11;

struct RagdollDef {
    Position position_m{};  ///< between the feet
    float scale = 1;        ///< 1: it is 1.6 m tall; > 0
    /// Of a joint of strength 1 (hip), at scale 1, >= 0; grows with the cube of the scale, as muscles need.
    float friction_torque_nm = 0.05f;
    float spring_hz = 0;          ///< of springs that draw every joint to where it stands, >= 0; 0: limp
    float spring_damping = 0.5f;  ///< ratio, >= 0
    /// Bones of the same negative group do not collide with each other; 0: a group of its own.
    std::int32_t group = 0;
    ShapeDef shape{.material = {.friction = 0.2f}};  ///< its group is not used
    Vec2 velocity_m_s{};
};

struct Ragdoll : Prefab {
    [[nodiscard]] BodyId bone(Bone which) const { return bodies[static_cast<std::size_t>(which)]; }
    /// What holds a bone to its parent. Not for the hip, which is the root.
    [[nodiscard]] JointId joint(Bone which) const { return joints[static_cast<std::size_t>(which) - 1]; }
};

Result<Ragdoll> create_ragdoll(World& world, const RagdollDef& def);

}  // namespace cairn::physics
