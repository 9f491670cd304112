// Pairs without points: which of them meet, which will meet within the step, and which have parted. Most are
// told by two discs, or by how far apart they were when they were looked at, eight pairs at once; what is
// left is packed, so that lanes of the manifold's routines are full.
#pragma once

#include <algorithm>

#include "world/fast_bodies.h"

namespace cairn::physics {

/// Which lanes of a block of near pairs are from `first` up to, and without, `count`, as bits.
inline unsigned near_lanes(int first, int count, int block) {
    const int begin = std::max(first - block * kLanes, 0);
    const int end = std::min(count - block * kLanes, kLanes);
    return (1u << end) - (1u << begin);
}

/// Whether a pair that has no points, in a lane of a block just looked at, will meet within the step: the
/// contact of then, as predict_contact has it.
bool meets_ahead(const Stores& stores, const std::vector<Advance>& advances, const BlockPlaces& places,
                 const ManifoldLanes& manifold, int lane, int contact, Vec2 gravity_m_s2, float dt_s,
                 ContactInput& input);

/// Whether a pair that had no points in the last step, and has some in a lane of a block just looked at, is
/// not to meet yet: one goes over a corner of the other, as over the seam of two floors.
bool passes_corner(const Stores& stores, const ManifoldLanes& manifold, int lane, int contact,
                   Vec2 gravity_m_s2, float dt_s);

/// Whether one body of a pair that has no points may reach the other, which stands still or sleeps, by the
/// end of the step.
bool may_reach(const std::vector<Advance>& advances, const BlockPlaces& places, const ManifoldLanes& manifold,
               int lane, float dt_s);

/// Looks at the near pairs of a geometry from lane `first` up to `count`, on several threads. Findings are by
/// block, from that of `first` on, in `near_findings`; `near_ahead` has what will meet, in the order of
/// the lanes.
void find_near(Stores& stores, PairGeometry geometry, int first, int count, Vec2 gravity_m_s2, float dt_s,
               StepScratch& scratch, TaskPool& tasks);

}  // namespace cairn::physics
