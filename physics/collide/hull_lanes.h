// Eight pairs of circles, capsules, segments (not of chains) and polygons at once, in any mixture. The same
// method as hulls.cpp, with selections where that branches, and brute force over the corners where that
// iterates.
#pragma once

#include "collide/box_lanes.h"
#include "collide/convex.h"

namespace cairn::physics {

/// The shapes of eight pairs. Every lane names two, whether it is used or not.
struct HullLanes {
    Lanes<const Convex*> a;
    Lanes<const Convex*> b;
};

/// Of `offsets` those are used, of the bodies' origins. Points within reach_m. The result has a bit for each
/// lane that only the general routine can decide. No pair consists of two segments.
unsigned collide_hull_lanes(const PoseLanes& poses, const BoxLanes& offsets, const HullLanes& hulls,
                            float reach_m, ManifoldLanes& out);

}  // namespace cairn::physics
