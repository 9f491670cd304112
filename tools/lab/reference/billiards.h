// Elastic discs without friction on a table without end: from hit to hit, in double.
#pragma once

#include <vector>

#include <cairn/physics/math.h>

namespace cairn::lab::reference {

struct Ball {
    double x_m = 0, y_m = 0;
    double vx_m_s = 0, vy_m_s = 0;
};

/// Balls of equal mass and radius. Runs until `hits` hits have happened, then half-way to the next one (or
/// for a second when there is none). Returns how long that took.
double play(std::vector<Ball>& balls, double radius_m, int hits);

}  // namespace cairn::lab::reference
