// A wheel of sails that faces the wind and turns in it.
#pragma once

#include <cairn/physics/prefabs/prefab.h>

namespace cairn::physics {

struct WindmillDef {
    Position position_m{};            ///< of the hub
    int sails = 4;                    ///< 2..24
    float hub_radius_m = 0.3f;        ///< > 0
    float sail_length_m = 2;          ///< > 0
    float sail_width_m = 0.4f;        ///< > 0
    float tip_speed_ratio = 2;        ///< speed of the tips to that of the wind when nothing brakes, > 0
    bool clockwise = false;           ///< which way it turns
    float friction_torque_nm = 0.5f;  ///< of the hub, >= 0
    PrefabEnd hub{};                  ///< what it turns on
    ShapeDef shape{};                 ///< of hub and sails
};

struct Windmill : Prefab {
    BodyId rotor{};
    JointId axle{};
    float tip_m = 0;            ///< from the axle
    float sail_area_m2 = 0;     ///< of all sails
    float tip_speed_ratio = 0;  ///< < 0: clockwise
};

Result<Windmill> create_windmill(World& world, const WindmillDef& def);
/// What the wind does to the wheel in the next step, which takes dt_s; call it before each. The wheel faces
/// the wind, so only its speed counts. Still air brakes.
Result<void> blow_windmill(World& world, const Windmill& windmill, const WindDef& wind, float dt_s);

}  // namespace cairn::physics
