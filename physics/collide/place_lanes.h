// Places of the bodies of eight pairs, gathered for SIMD; and which pairs are so far apart that their shapes
// need not be looked at, before a step and after it.
#pragma once

#include <cstdint>
#include <limits>

#include "base/place.h"
#include "base/slot_map.h"
#include "collide/box_lanes.h"

namespace cairn::physics {

/// How the bodies of a block of pairs lie, and what else the places say of them, as bits by lane. Lanes that
/// are not asked for are so far apart that nothing is found.
struct BlockPlaces {
    PoseLanes poses;
    alignas(32) Lanes<std::int32_t> row_a;
    alignas(32) Lanes<std::int32_t> row_b;
    unsigned hasty = 0;
    unsigned turn_far = 0;
    unsigned boxes_moved = 0;
    unsigned direct = 0;
    unsigned rouses = 0;
};

/// `lanes` has a bit for each lane that is wanted; the others need not name a body.
void load_places(const Place* places, const Lanes<std::int32_t>& body_a, const Lanes<std::int32_t>& body_b,
                 unsigned lanes, BlockPlaces& out);

/// What a body is expected to do in a step if it meets nothing. That of the world is nothing at all.
struct alignas(16) Advance {
    Vec2 velocity_m_s;      // mean over the step, of the centre of mass
    float turning_m_s = 0;  // speed of the farthest point about it
    float calm_way_m = 0;   // ways up to this neither pass through anything nor end deep in it
};

/// What was seen of a pair without points. How one body lies as seen from the other tells how much of the gap
/// can be gone by now: what moves along with its neighbour need not be looked at again.
struct NearSight {
    float gap_m = 0;  // the shapes were at least this far apart
    Vec2 center;      // m, of b, in the frame of a
    Rotation turn;    // of b as seen from a
};

/// `poses` of a pair of which the shapes are so far apart.
NearSight make_sight(const PoseLanes& poses, int lane, float gap_m);

namespace near_flag {
inline constexpr std::uint32_t kRemembers = 1;  ///< it had points in the last step
inline constexpr std::uint32_t kSeen = 2;       ///< its sight holds; only speed depends on it
}  // namespace near_flag

/// A pair without points. Such pairs come and go in crowds, and to take one somewhere else is to take one
/// cache line. What a look at all of them reads comes first.
struct alignas(64) NearPair {
    std::int32_t body_a = kNone;
    std::int32_t body_b = kNone;
    float reach_m = 0;  // sum of the radii of the discs about the centres of mass that hold the shapes
    std::uint32_t flags = 0;
    NearSight sight;
    std::int32_t contact = kNone;
    std::int32_t shape_a = kNone;
    std::int32_t shape_b = kNone;
    Vec2 offset_a;  // as in BoxLanes
    Vec2 offset_b;
};
static_assert(sizeof(NearPair) == 64);

/// Of eight pairs, as bits.
struct NearLanes {
    unsigned close = 0;  // the shapes could have points, or meet within the step
    unsigned boxes_moved = 0;
    unsigned remembers = 0;
};

/// Of some of eight pairs, all of which are there to be read. `advances` are by row.
NearLanes look_near(const Place* places, const NearPair* pairs, const Advance* advances, float dt_s,
                    unsigned lanes);

/// What a body did in a step.
struct alignas(32) Displacement {
    Vec2 moved;
    float chord = 0;  // of the angle that it turned by: how far that takes a point at 1 m
    float extent_m = std::numeric_limits<float>::infinity();  // of its shapes, from the centre of mass
    float arm_m = 0;                                          // how far its shapes' own centres are from that
    // Shorter ways take none of these through anything; infinite for a body that is not fast.
    float least_way_m = std::numeric_limits<float>::infinity();
};

/// Lanes in which the centre of a shape of one body may have met a shape of the other in the last step, by
/// what the bodies did as a whole. Displacements are by row; pairs without a fast body are left out.
unsigned find_passed(const Place* places, const Lanes<std::int32_t>& body_a,
                     const Lanes<std::int32_t>& body_b, const Displacement* displacements, unsigned lanes);

}  // namespace cairn::physics
