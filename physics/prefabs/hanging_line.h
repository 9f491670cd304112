// The points of a line of equal links that hangs between two ends.
#pragma once

#include <vector>

#include <cairn/physics/math.h>

namespace cairn::physics {

/// count + 1 points from `from` to `to`, below the straight way, on an arc of a circle, so that each is
/// length_m / count from the next. length_m is at least the distance of the ends, which are apart.
std::vector<Position> hanging_line(Position from, Position to, double length_m, int count);

}  // namespace cairn::physics
