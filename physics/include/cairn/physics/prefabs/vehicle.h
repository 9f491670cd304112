// A car seen from the side: a chassis on sprung wheels, some of them driven.
#pragma once

#include <cairn/physics/prefabs/prefab.h>

namespace cairn::physics {

struct VehicleWheelDef {
    Vec2 place_m{};         ///< in the chassis
    float radius_m = 0.4f;  ///< > 0
    bool driven = true;
    bool braked = true;
};

struct VehicleDef {
    Position position_m{};  ///< of the middle of the chassis
    float length_m = 3;     ///< of the chassis, > 0
    float height_m = 0.6f;  ///< > 0
    std::vector<VehicleWheelDef> wheels{{.place_m = {-1, -0.5f}}, {.place_m = {1, -0.5f}}};
    float suspension_hz = 3;           ///< > 0
    float suspension_damping = 0.8f;   ///< ratio, >= 0
    float suspension_travel_m = 0.3f;  ///< up and down, > 0
    float drive_torque_nm = 30;        ///< of each driven wheel, >= 0
    float brake_torque_nm = 60;        ///< of each braked wheel, >= 0
    ShapeDef chassis{.density_kg_m2 = 2};
    ShapeDef tyre{.material = {.friction = 1}};
};

struct Vehicle : Prefab {
    struct Wheel {
        BodyId body{};
        JointId axle{};
        float radius_m = 0;
        bool driven = false;
        bool braked = false;
    };
    BodyId chassis{};
    std::vector<Wheel> wheels{};
    float drive_torque_nm = 0;
    float brake_torque_nm = 0;
};

/// At rest, with its brakes off.
Result<Vehicle> create_vehicle(World& world, const VehicleDef& def);
/// Turns the driven wheels for that speed, to the right when it is positive; the others run freely.
Result<void> drive_vehicle(World& world, const Vehicle& vehicle, float speed_m_s);
/// Blocks the braked wheels with all their torque; the others run freely.
Result<void> brake_vehicle(World& world, const Vehicle& vehicle);
/// Lets all wheels run freely.
Result<void> coast_vehicle(World& world, const Vehicle& vehicle);

}  // namespace cairn::physics
