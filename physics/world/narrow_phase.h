// Manifolds of contacts, eight at a time.
#pragma once

#include "collide/manifold.h"
#include "resolve/contact_constraint.h"
#include "world/world_state.h"

namespace cairn::physics {

/// How the bodies of a block of pairs lie, and what else the places say of them, as bits by lane. Lanes that
/// are not asked for are so far apart that nothing is found.
struct BlockPlaces {
    PoseLanes poses;
    Lanes<std::int32_t> row_a;
    Lanes<std::int32_t> row_b;
    unsigned fast = 0;
    unsigned turn_far = 0;
    unsigned boxes_moved = 0;
};

/// `lanes` has a bit for each lane that is wanted.
void load_places(const BodyStore& bodies, const PairBlock& pairs, unsigned lanes, BlockPlaces& out);

void collide_block(const Stores& stores, const PairBlock& pairs, PairGeometry geometry, unsigned lanes,
                   const PoseLanes& poses, ManifoldLanes& out);

/// The contact in a lane in the form for scalar code. Impulses and friction are the caller's.
ContactInput make_input(const Stores& stores, const PairBlock& pairs, const BlockPlaces& places,
                        const ManifoldLanes& manifold, int lane);

}  // namespace cairn::physics
