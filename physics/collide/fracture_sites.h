// Where the pieces of a breaking body have their middles: the sites of its Voronoi cells.
// Invariant: the sites depend on the arguments alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "collide/ring.h"

namespace cairn::physics {

/// `count` sites within the rings, well apart from each other everywhere. Source: best-candidate sampling,
/// Mitchell 1991.
std::vector<RingPoint> uniform_sites(std::span<const Ring> rings, int count, std::uint64_t seed);

/// About `count` sites where rays from `center` meet circles about it, all a little out of place; the circles
/// follow each other in geometric progression, the innermost no smaller than `least_radius`. There is one in
/// the centre, too.
std::vector<RingPoint> radial_sites(std::span<const Ring> rings, RingPoint center, int count,
                                    double least_radius, std::uint64_t seed);

}  // namespace cairn::physics
