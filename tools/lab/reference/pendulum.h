// Pendulums: the period of one at any amplitude, and the motion of bars hung from each other. In double.
#pragma once

#include <vector>

#include <cairn/physics/math.h>

#include "reference/ode.h"

namespace cairn::lab::reference {

/// Complete elliptic integral of the first kind, K(k). Source: the arithmetic-geometric mean (Gauss 1799).
double elliptic_k(double k);

/// Of a pendulum of this reduced length, released at rest at this angle from hanging down.
double pendulum_period_s(double length_m, double gravity_m_s2, double amplitude_rad);

/// Uniform bars, each hung from the end of the one before, the first from the origin. Angles are from hanging
/// down, anticlockwise.
struct HungBars {
    int count = 2;
    double length_m = 1;
    double mass_kg = 1;
    double inertia_kg_m2 = 1.0 / 12;  ///< of a bar about its centre
    double gravity_m_s2 = 10;

    /// State: the angles, then the angular velocities.
    [[nodiscard]] State derivative(const State& state) const;
    [[nodiscard]] std::vector<physics::Position> centers(const State& state) const;
    [[nodiscard]] double energy_j(const State& state) const;
};

}  // namespace cairn::lab::reference
