// Two platforms on one rope over two wheels: one goes up as the other goes down.
#pragma once

#include <cairn/physics/prefabs/prefab.h>

namespace cairn::physics {

struct PulleyLiftDef {
    Position position_m{};     ///< of the middle between the platforms, which hang at the same height
    float distance_m = 4;      ///< between the centres of the platforms, > width_m
    float travel_m = 2;        ///< up and down from there, > 0
    float width_m = 1.5f;      ///< of each platform, > 0
    float thickness_m = 0.2f;  ///< > 0
    float rope_m = 5;          ///< from the platforms up to the wheels, > travel_m
    float ratio = 1;           ///< of a block and tackle on the right, > 0: it bears that many times as much
    ShapeDef left{};
    ShapeDef right{};
};

struct PulleyLift : Prefab {
    BodyId left{};
    BodyId right{};
    JointId pulley{};
};

/// Each platform slides upright along a guide.
Result<PulleyLift> create_pulley_lift(World& world, const PulleyLiftDef& def);

}  // namespace cairn::physics
