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
};

inline constexpr std::array kFeatures{Feature::Joints,      Feature::DirectSolver,     Feature::Sensors,
                                      Feature::Chains,      Feature::Events,           Feature::Fracture,
                                      Feature::Restitution, Feature::RollingResistance};

/// "joints", "direct_solver", "sensors", "chains", "events", "fracture", "restitution" or
/// "rolling_resistance".
std::string_view name(Feature feature);
bool is_built_in(Feature feature);

}  // namespace cairn::physics
