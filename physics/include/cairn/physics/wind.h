// What moving air, or water, does to bodies.
#pragma once

#include <cairn/physics/query.h>

namespace cairn::physics {

/// Acts on the part of each outline that faces the flow, as seen from the moving surface; with q = 1/2
/// density times the square of that speed, drag is q drag L along the flow, where L is the length of outline
/// across it, and lift is q lift L c across it, to where the surface leads, where c is the cosine between the
/// surface and the flow. For a disc: 1/2 density drag 2r |w| w, through its centre. Nothing shelters from it.
struct WindDef {
    Vec2 velocity_m_s{};         ///< of the air; (0, 0) is still air, which slows bodies down
    float density_kg_m2 = 1.2f;  ///< of the air, in a world one metre deep, >= 0
    float drag = 1;              ///< >= 0; 1 suits most shapes
    float lift = 0;              ///< >= 0; 1 suits flat plates
    QueryFilter filter{};        ///< who is met
};

}  // namespace cairn::physics
