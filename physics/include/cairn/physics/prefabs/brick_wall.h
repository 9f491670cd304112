// A wall of bricks in running bond, held by mortar that breaks.
#pragma once

#include <cairn/physics/prefabs/prefab.h>

namespace cairn::physics {

/// columns * courses; as many as a chain may have links. Each brick has up to four joints, so that a
/// million of them would take gigabytes.
inline constexpr int kMaxBricks = 10'000;

struct BrickWallDef {
    Position position_m{};         ///< of the middle of its foot
    int columns = 6;               ///< bricks in a course, 1..1,000
    int courses = 8;               ///< 1..1,000, and at most kMaxBricks / columns
    float brick_width_m = 0.5f;    ///< > 20 mm
    float brick_height_m = 0.25f;  ///< > 10 mm
    /// Force that a metre of mortar bears, N/m, > 0. A brick that hangs from its side by mortar of that
    /// strength can be `strength / (density g)` wide.
    float mortar_n_m = 400;
    ShapeDef shape{};  ///< of every brick
};

struct BrickWall : Prefab {};

/// Every other course begins with half a brick, so that all are equally wide.
Result<BrickWall> create_brick_wall(World& world, const BrickWallDef& def);

}  // namespace cairn::physics
