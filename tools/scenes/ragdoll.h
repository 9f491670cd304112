// A figure of eleven bones with feet.
#pragma once

#include <array>

#include "scene.h"

namespace cairn::bench {

inline constexpr int kBones = 11;

using Ragdoll = std::array<BodyRef, kBones>;

/// Stands at the position with its feet a little above it. Figures of different groups, numbered from 1 on,
/// meet each other; the bones of one do not.
Ragdoll add_ragdoll(Engine& engine, physics::Position position_m, int group);

/// Category of the shapes of figures; the world's own is 1.
inline constexpr std::uint64_t kBoneCategory = 2;

}  // namespace cairn::bench
