// Explosions and wind: what they do to each body, worked out from the outlines of its shapes. Both only read
// the world; applying the result is the caller's.
#pragma once

#include <vector>

#include <cairn/physics/explosion.h>
#include <cairn/physics/wind.h>

#include "base/check.h"
#include "world/world_state.h"

namespace cairn::physics {

/// An impulse, or a force, with its moment about the centre of mass.
struct SurfaceForce {
    BodyId body{};
    Vec2 linear{};
    float angular = 0;
};

check::Fault validate(const ExplosionDef& def);
check::Fault validate(const WindDef& def);

/// Impulses on dynamic bodies, one for each body that is met, ordered by slot.
std::vector<SurfaceForce> explosion_impulses(const Stores& stores, const ExplosionDef& def);

/// The force on one dynamic body for a step of dt_s.
SurfaceForce wind_force(const Stores& stores, int body, const WindDef& def, float dt_s);

}  // namespace cairn::physics
