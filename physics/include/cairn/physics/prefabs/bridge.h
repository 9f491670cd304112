// A bridge of planks, pinned end to end between two abutments.
#pragma once

#include <cairn/physics/prefabs/prefab.h>

namespace cairn::physics {

struct BridgeDef {
    Position from_m{};
    Position to_m{10, 0};
    int planks = 20;                  ///< 2..10,000, each longer than 10 mm
    float slack = 0.01f;              ///< how much longer than the straight way it is, as a share of it, 0..1
    float thickness_m = 0.2f;         ///< > 0
    float friction_torque_nm = 0.5f;  ///< of each pin, >= 0
    float damping_1_s = 1;            ///< of the air, >= 0
    JointStrength strength{};         ///< of each pin
    PrefabEnd from{};
    PrefabEnd to{};
    ShapeDef shape{.density_kg_m2 = 4};  ///< of every plank
};

struct Bridge : Prefab {
    std::vector<BodyId> planks{};
    std::vector<JointId> pins{};  ///< one more than planks when both ends are held
};

Result<Bridge> create_bridge(World& world, const BridgeDef& def);

}  // namespace cairn::physics
