// Impacts that go from one body to the next: what touches is hit pair by pair, as it happens in nature within
// microseconds, where the solver makes all of it one impact. Newton's cradle, and the break of billiards.
// Invariant: momentum is kept, and no energy is won. Arms and spins are scaled as in base/motion.h.
// Source: sequential impacts with Newton's restitution and Coulomb's friction; Ivanov, "On Multiple Impact"
// (1995).
#pragma once

#include <array>
#include <span>

#include "base/motion.h"

namespace cairn::physics {

/// A contact between bodies that touch, as a possible impact.
struct Impact {
    struct Point {
        float arm_a = 0;  // k_a (r_a x n)
        float arm_b = 0;
        float impulse = 0;  // N s, of all impacts here
    };
    int a = 0;  // rows
    int b = 0;
    Vec2 normal;  // unit, from a to b
    int count = 0;
    std::array<Point, 2> points{};
    float tangent_arm_a = 0;  // of the friction row, the tangent being the normal turned clockwise
    float tangent_arm_b = 0;
    float friction = 0;
    float restitution = 0;
    float slow_m_s = 0;  // what closes no faster does not bounce
};

/// Lets the impacts happen, one after the other and round by round, until nothing closes in. False when that
/// takes too long or energy would be won, as friction and restitution together can: then the velocities are
/// of no use.
bool let_happen(std::span<Impact> impacts, std::span<const int> rows, Motions& motions);

}  // namespace cairn::physics
