// Rings for tests of fracture.
#pragma once

#include <vector>

#include "collide/ring.h"
#include "physics/support/random.h"

namespace cairn::physics::test {

inline Ring box_ring(double half_width, double half_height) {
    return {{-half_width, -half_height},
            {half_width, -half_height},
            {half_width, half_height},
            {-half_width, half_height}};
}

/// Points of an ellipse in random places.
inline Ring random_ring(Random& random, int count) {
    const double width = random.real(0.2, 3);
    const double height = random.real(0.2, 3);
    const double turn = 2 * deterministic::acos(-1);
    Ring ring;
    for (int i = 0; i < count; ++i) {
        const double angle = turn * (i + random.real(0, 0.8)) / count;
        ring.push_back({width * deterministic::cos(angle), height * deterministic::sin(angle)});
    }
    return ring;
}

inline DirectedLine random_line(Random& random) {
    const double angle = random.real(0, 7);
    return {{random.real(-1, 1), random.real(-1, 1)}, {deterministic::cos(angle), deterministic::sin(angle)}};
}

inline bool is_convex(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const RingPoint a = ring[i];
        const RingPoint b = ring[(i + 1) % ring.size()];
        for (const RingPoint p : ring) {
            if (cross(b - a, p - a) < -1e-9) return false;
        }
    }
    return true;
}

}  // namespace cairn::physics::test
