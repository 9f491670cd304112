// Surfaces run clockwise round their shapes: a's along the tangent, b's, which faces it, against it; so both
// carry b on.
#include "world/surface_speed.h"

namespace cairn::physics {

bool runs(const Material& material) {
    return material.surface_speed_m_s != 0;
}

float mixed_surface_speed(const Material& a, const Material& b) {
    return a.surface_speed_m_s + b.surface_speed_m_s;
}

}  // namespace cairn::physics
