// A cabin that goes up and down between floors.
#pragma once

#include <cairn/physics/prefabs/prefab.h>

namespace cairn::physics {

struct ElevatorDef {
    Position position_m{};                 ///< of the platform's upper side, at floor 0
    std::vector<float> floors_m{0, 3, 6};  ///< heights over position_m, ascending, 1..1,000 of them
    float width_m = 2;                     ///< of the platform, > 0
    float thickness_m = 0.2f;              ///< > 0
    float speed_m_s = 1.5f;                ///< > 0
    float load_kg = 100;                   ///< that it can carry, >= 0
    ShapeDef shape{.density_kg_m2 = 100, .material = {.friction = 0.9f}};  ///< of the platform
};

struct Elevator : Prefab {
    BodyId platform{};
    JointId guide{};
    std::vector<float> floors_m{};
    float speed_m_s = 0;
};

/// It stands at floor 0.
Result<Elevator> create_elevator(World& world, const ElevatorDef& def);
/// Sets it off to a floor, where it stops at once: going up, what stands on it hops by speed^2 / 2 g. It may
/// be on its way already.
Result<void> send_elevator(World& world, const Elevator& elevator, int floor);
/// Whether it stands at that floor, within a centimetre.
Result<bool> is_elevator_at(const World& world, const Elevator& elevator, int floor);

}  // namespace cairn::physics
