// One or more bobs on rods without mass, each hung from the one above.
#pragma once

#include <cairn/physics/prefabs/prefab.h>

namespace cairn::physics {

struct PendulumDef {
    Position pivot_m{};
    int bobs = 1;            ///< 1..100; two make a double pendulum
    float rod_m = 1;         ///< from centre to centre, > 0
    float radius_m = 0.15f;  ///< of each bob, > 0
    float angle_rad = 0.5f;  ///< of all rods at the start, from straight down, anticlockwise
    float damping_1_s = 0;   ///< of the air, >= 0
    PrefabEnd pivot{};       ///< a free pendulum falls
    ShapeDef shape{};        ///< of each bob
};

struct Pendulum : Prefab {
    std::vector<BodyId> bobs{};
};

Result<Pendulum> create_pendulum(World& world, const PendulumDef& def);

}  // namespace cairn::physics
