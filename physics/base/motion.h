// What the solver reads and changes of a body during one step.
// Invariant: index 0 of a span of motions is the world itself: infinite mass, never moves. All static bodies
// are it.
#pragma once

#include <cairn/physics/math.h>

namespace cairn::physics {

struct Motion {
    Vec2 v;       // m/s, of the centre of mass
    float w = 0;  // rad/s
    Vec2 dp;      // m, moved since the start of the step
    Rotation dq;  // turned since the start of the step
    float inverse_mass = 0;
    float inverse_inertia = 0;
    bool constrained =
        false;  // has contacts or joints in this step, so substeps move it; else free flight does
};

inline constexpr int kWorldMotion = 0;

/// What acts on a body besides constraints, constant over a step.
struct Drive {
    Vec2 acceleration;               // m/s^2, gravity and forces
    float angular_acceleration = 0;  // rad/s^2
    float linear_damping = 0;        // 1/s
    float angular_damping = 0;       // 1/s
};

}  // namespace cairn::physics
