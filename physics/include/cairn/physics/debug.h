// What a world looks like inside, as plain data for those who draw it or study it: contacts, islands, boxes
// of the broad phase. Found by walking over the world when it is asked for; steps do nothing for it.
#pragma once

#include <array>
#include <cstdint>

#include <cairn/physics/ids.h>
#include <cairn/physics/math.h>

namespace cairn::physics {

struct DebugContactPoint {
    Position point_m{};      ///< midway between the two surfaces
    float separation_m = 0;  ///< along the normal; negative when they overlap
    float impulse_ns = 0;    ///< along the normal, over the last step, at the pace of its last substep
};

/// Two shapes that touch, asleep ones too, as they stand now.
struct DebugContact {
    ShapeId shape_a{};
    ShapeId shape_b{};
    BodyId body_a{};
    BodyId body_b{};
    Vec2 normal{};                  ///< unit, from a to b
    float friction_impulse_ns = 0;  ///< on b, along the normal turned clockwise; as the points' impulses
    int count = 0;
    std::array<DebugContactPoint, 2> points{};
};

/// Which bodies move, and fall asleep, together.
struct DebugIsland {
    BodyId body{};   ///< dynamic, or a kinematic one that sleeps
    int island = 0;  ///< from 0 on, by the lowest slot among its bodies
    bool is_awake = true;
};

/// A box that stands for a shape in the broad phase.
struct DebugBox {
    ShapeId shape{};
    Position lower_m{};
    Position upper_m{};
};

}  // namespace cairn::physics
