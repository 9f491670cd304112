// Manifolds of contacts, eight at a time.
#pragma once

#include "collide/manifold.h"
#include "collide/place_lanes.h"
#include "resolve/contact_constraint.h"
#include "world/world_state.h"

namespace cairn::physics {

/// Of some lanes those whose boxes have parted, or keep apart on their ways.
unsigned gone_lanes(const Stores& stores, const Lanes<std::int32_t>& shape_a,
                    const Lanes<std::int32_t>& shape_b, unsigned lanes);

/// Asks for what colliding some lanes will read besides the block.
void ask_for_pairs(const Stores& stores, const PairBlock& pairs, PairGeometry geometry, unsigned lanes);

/// `lanes` has a bit for each lane that is wanted. Another unit than 1 is for what goes one by one
/// (world/tiny_contacts.h).
void collide_block(const Stores& stores, const PairBlock& pairs, PairGeometry geometry, unsigned lanes,
                   const PoseLanes& poses, ManifoldLanes& out, float unit = 1);

/// The contact in a lane in the form for scalar code. Impulses and friction are the caller's.
ContactInput make_input(const Stores& stores, const PairBlock& pairs, const BlockPlaces& places,
                        const ManifoldLanes& manifold, int lane);

/// How far along the normal the point of a contact lies from the centres of mass, without what is round of
/// the shapes; midway between two points.
struct Bows {
    float a_m = 0;
    float b_m = 0;
};
Bows bows_of(const Stores& stores, const PairBlock& pairs, const BlockPlaces& places,
             const ManifoldLanes& manifold, int lane);

}  // namespace cairn::physics
