// Mass, centre of mass and inertia of shapes.
#pragma once

#include <cairn/physics/math.h>

#include "collide/convex.h"

namespace cairn::physics {

/// In double: bodies are sums of many shapes.
struct MassSum {
    double mass = 0;
    double moment_x = 0;  // mass times position
    double moment_y = 0;
    double inertia = 0;  // about the origin of the body's frame

    MassSum& operator+=(const MassSum& b) {
        mass += b.mass;
        moment_x += b.moment_x;
        moment_y += b.moment_y;
        inertia += b.inertia;
        return *this;
    }
};

/// Of one shape of uniform density, kg per m^2; exact for rounded shapes too.
MassSum mass_of(const Convex& shape, double density_kg_m2);

}  // namespace cairn::physics
