// Surfaces that run, as of conveyor belts: what they bring to a contact. The solver only sees the speed that
// comes of it, as what friction aims at in contacts with special::kSurface.
#pragma once

#include <cairn/physics/shape.h>

namespace cairn::physics {

/// Whether the surface runs, so that contacts with it are special.
bool runs(const Material& material);

/// Of b's surface past a's, along the tangent, m/s.
float mixed_surface_speed(const Material& a, const Material& b);

}  // namespace cairn::physics
