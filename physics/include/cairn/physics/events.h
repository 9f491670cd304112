// What happened in the last step, as plain data. The handles of an event may be stale when it is read (a body
// destroyed since): ask the world.
#pragma once

#include <cstdint>
#include <span>

#include <cairn/physics/ids.h>
#include <cairn/physics/joint.h>
#include <cairn/physics/math.h>

namespace cairn::physics {

/// Two shapes began to touch.
struct ContactBegin {
    ShapeId shape_a{};
    ShapeId shape_b{};
    BodyId body_a{};
    BodyId body_b{};
    Position point_m{};  ///< middle of the contact points
    Vec2 normal{};       ///< unit, from a to b
};

/// Two shapes ceased to touch, or one of them was destroyed.
struct ContactEnd {
    ShapeId shape_a{};
    ShapeId shape_b{};
    BodyId body_a{};
    BodyId body_b{};
};

/// Two shapes met faster than WorldDef::hit_speed_m_s.
struct ContactHit {
    ShapeId shape_a{};
    ShapeId shape_b{};
    BodyId body_a{};
    BodyId body_b{};
    Position point_m{};  ///< where they met fastest
    Vec2 normal{};       ///< unit, from a to b
    float approach_speed_m_s = 0;
    float impulse_ns = 0;  ///< sum of the normal impulses of the contact over the step
};

/// A joint was loaded beyond its strength, and destroyed at the end of the step.
struct JointBreak {
    JointId joint{};
    JointKind kind{};
    BodyId body_a{};
    BodyId body_b{};
    Position point_m{};  ///< anchor b
    Vec2 force_n{};      ///< on body b, the mean over the step
    float torque_nm = 0;
    std::uint64_t user_data = 0;
};

/// Something pressed on a breakable body harder than it withstands. One for each body, of the contact that
/// pressed hardest. Where two breakable bodies meet, the weaker breaks and spares the other.
struct BodyBreak {
    BodyId body{};
    BodyId other{};
    Position point_m{};            ///< through which the impulse went
    Vec2 normal{};                 ///< unit, into the body
    float approach_speed_m_s = 0;  ///< at the start of the step; 0 for things at rest on each other
    float impulse_ns = 0;          ///< normal impulse of the contact over the step
    /// If the world has broken it already (BreakableDef::automatic); empty when it was too small to break.
    std::span<const BodyId> pieces{};
};

/// A shape came to overlap a sensor.
struct SensorBegin {
    ShapeId sensor{};
    ShapeId visitor{};
    BodyId sensor_body{};
    BodyId visitor_body{};
};

/// A shape ceased to overlap a sensor, one of the two was destroyed, or its filter hides it now.
struct SensorEnd {
    ShapeId sensor{};
    ShapeId visitor{};
    BodyId sensor_body{};
    BodyId visitor_body{};
};

}  // namespace cairn::physics
