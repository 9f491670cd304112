// A rope between two points: short links that bend freely, and one law for the whole, so that it does not
// stretch whatever hangs from it.
#pragma once

#include <cairn/physics/prefabs/prefab.h>

namespace cairn::physics {

struct RopeDef {
    Position from_m{};
    Position to_m{5, 0};
    float length_m = 0;      ///< at least the distance from end to end; 0: just that. It hangs in an arc
    int links = 20;          ///< 2..10,000, each longer than 10 mm
    float radius_m = 0.04f;  ///< > 0
    float friction_torque_nm = 0;  ///< of each bend, >= 0
    float damping_1_s = 1;         ///< of the air, >= 0
    PrefabEnd from{};
    PrefabEnd to{};
    ShapeDef shape{};  ///< of every link
};

struct Rope : Prefab {
    std::vector<BodyId> links{};  ///< from the first end on
    float length_m = 0;
};

Result<Rope> create_rope(World& world, const RopeDef& def);

}  // namespace cairn::physics
