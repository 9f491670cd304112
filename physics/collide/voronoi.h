// Voronoi cells: for each site, all that is nearer to it than to any other.
// Invariant: the cells of a ring tile it, up to rounding of doubles. Source: Okabe et al., "Spatial
// Tessellations" (2000); each cell by half-planes, nearest neighbours first.
#pragma once

#include <span>
#include <vector>

#include "collide/ring.h"

namespace cairn::physics {

/// One cell for each site; empty for a site that repeats an earlier one or has no part of `bounds`.
/// Takes time of n^2 log n for n sites.
std::vector<Ring> voronoi_cells(std::span<const RingPoint> sites, const Ring& bounds);

}  // namespace cairn::physics
