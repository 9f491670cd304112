// What an explosion does to the bodies around it.
#pragma once

#include <cstdint>

#include <cairn/physics/query.h>

namespace cairn::physics {

/// An impulse at once, outward from a point. It acts as a pressure does: on the part of each outline that
/// faces the point, square to the surface. So a shape gets impulse_ns_m times its length as seen from the
/// point, large shapes more than small ones; a disc is not turned, a plank that is met at one end is.
struct ExplosionDef {
    Position center_m{};
    float radius_m = 3;         ///< full strength up to here, >= 0
    float falloff_m = 2;        ///< from there on it fades to nothing over this distance, linearly, >= 0
    float impulse_ns_m = 10;    ///< per metre of length that faces the point; negative: inward
    std::uint64_t shelter = 0;  ///< shapes of these categories keep it from what lies behind them
    QueryFilter filter{};       ///< who is met
};

}  // namespace cairn::physics
