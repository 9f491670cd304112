// A chain of rigid links, pinned end to end.
#pragma once

#include <cairn/physics/prefabs/prefab.h>

namespace cairn::physics {

struct LinkChainDef {
    Position start_m{};
    Vec2 direction{0, -1};         ///< of any length
    int links = 10;                ///< 1..10,000
    float link_length_m = 0.5f;    ///< from pin to pin, > 10 mm
    float thickness_m = 0.15f;     ///< > 0
    float friction_torque_nm = 0;  ///< of each pin, >= 0
    float damping_1_s = 0;         ///< of the air, >= 0
    PrefabEnd start{};
    PrefabEnd end{.held = false};
    ShapeDef shape{};  ///< of every link
};

/// `bodies` begins with the links, from the start on; `joints` are the pins, likewise.
struct LinkChain : Prefab {
    std::vector<BodyId> links{};
};

Result<LinkChain> create_link_chain(World& world, const LinkChainDef& def);

}  // namespace cairn::physics
