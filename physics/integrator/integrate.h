// Moving bodies on: by substeps when constraints act on them, in one exact stride when none does.
// Source: semi-implicit Euler for the substeps; constant acceleration for the stride, but for the host's
// forces.
#pragma once

#include <cstdint>
#include <span>

#include "base/motion.h"

namespace cairn::physics {

/// What forces and damping alone make of the velocity (m/s) in so many substeps: to the bit what the substeps
/// do.
Vec2 freely_moving(Vec2 velocity, const Drive& drive, float h_s, int substeps);

/// What forces and damping do in a substep to each row from first up to, and without, last, which is the same
/// in all substeps. Bodies moved by constraints only; structures that are solved directly take half of it.
void prepare_kicks(Motions& motions, std::span<const Drive> drives, float h_s, int first, int last);

/// v += h a, then damped by e^(-c h), as prepared; then, unless afresh, the impulses that contacts gave in
/// the last substep are applied again, as the first guess.
void integrate_velocities(Motions& motions, bool afresh, int first, int last);

// What acts between the two is not taken for an impulse of contacts. Only where there are both.
void begin_joints(Motions& motions, int first, int last);
void end_joints(Motions& motions, int first, int last);

/// Bodies moved by constraints only.
void integrate_positions(Motions& motions, float h_s);
void integrate_positions(Motions& motions, float h_s, int first, int last);

/// The whole step at once for the others: x += dt (v + v')/2, exact under gravity. What else acts was found
/// by the host from where the body was, so it acts as a kick at the start: v += dt F/m before x moves. Then
/// forces that depend on the place, springs and orbits that a game computes itself, do not pump energy (kick
/// and drift are symplectic: Hairer, Lubich, Wanner, "Geometric Numerical Integration", 2006). `step` is the
/// number of the step: roundings of the velocity even out over many (base/dithered_rounding.h).
void fly_freely(Motions& motions, std::span<const Drive> drives, Vec2 gravity_m_s2, float dt_s,
                std::uint64_t step);
void fly_freely(Motions& motions, std::span<const Drive> drives, Vec2 gravity_m_s2, float dt_s,
                std::uint64_t step, int first, int last);

}  // namespace cairn::physics
