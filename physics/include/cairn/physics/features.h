// Which parts of the physics this build has. A build leaves out what it is told to (CAIRN_WITH_...=OFF, see
// physics/features.cmake); using such a part is an error that names it, and all else is the same to the bit.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cairn::physics {

enum class Feature : std::uint8_t {
    Joints,
    DirectSolver,  ///< of structures and uneven contacts; without it they are swept
    Sensors,
    Chains,
    Events,    ///< of contacts: begin, end and hit
    Fracture,  ///< cuts, breaks and breakable bodies
    Restitution,
    RollingResistance,
    SurfaceSpeed,  ///< of materials: conveyor belts
    Effects,       ///< explosions and wind
    Mover,         ///< characters that walk
    Snapshots,     ///< going back to them, recordings
    Prefabs,
};

inline constexpr std::array kFeatures{
    Feature::Joints,       Feature::DirectSolver, Feature::Sensors,     Feature::Chains,
    Feature::Events,       Feature::Fracture,     Feature::Restitution, Feature::RollingResistance,
    Feature::SurfaceSpeed, Feature::Effects,      Feature::Mover,       Feature::Snapshots,
    Feature::Prefabs,
};

/// In lower case, with underscores: "direct_solver". The option of a build is CAIRN_WITH_DIRECT_SOLVER.
std::string_view name(Feature feature);
bool is_built_in(Feature feature);

}  // namespace cairn::physics
