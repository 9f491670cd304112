// Wheels in a row that turn each other without slip, and a motor on the first.
#pragma once

#include <cairn/physics/prefabs/prefab.h>

namespace cairn::physics {

struct GearTrainDef {
    Position position_m{};                       ///< of the first wheel's centre
    Vec2 direction{1, 0};                        ///< of the row, of any length
    std::vector<float> radii_m{0.5f, 1, 0.25f};  ///< 1..1,000 of them, each > 0
    float motor_speed_rad_s = 1;                 ///< of the first wheel
    float max_motor_torque_nm = 0;               ///< >= 0; 0: no motor
    ShapeDef shape{};
};

struct GearTrain : Prefab {
    std::vector<BodyId> wheels{};
    std::vector<JointId> axles{};
};

Result<GearTrain> create_gear_train(World& world, const GearTrainDef& def);

}  // namespace cairn::physics
