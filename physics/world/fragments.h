// Parts of the shapes of a body that is being divided, and the pieces that they make up.
// Invariant: everything is in the frame of the body.
#pragma once

#include <utility>
#include <vector>

#include "base/union_find.h"
#include "collide/mass.h"
#include "collide/ring.h"
#include "world/world_state.h"

namespace cairn::physics {

struct Fragment {
    int shape = kNone;  // slot of the shape that it is a part of
    int group = 0;      // only fragments of one group may be one piece
    bool is_whole = false;
    Ring ring;
    std::vector<Convex> convexes;
};

/// The shape as it is.
Fragment whole_fragment(const Stores& stores, int shape, int group);
/// A part of it. Without convexes when it is too narrow to be a shape.
Fragment part_fragment(int shape, int group, Ring ring);

/// Pairs of one group that overlap, or between which no gap can be seen; in a fixed order.
std::vector<std::pair<int, int>> touching_pairs(const std::vector<Fragment>& fragments);

struct PieceShape {
    int source = kNone;  // slot of the shape that it is a part of
    Convex convex;
    float density_kg_m2 = 0;
};

/// A body to be.
struct Piece {
    std::vector<PieceShape> shapes;
    MassSum mass;  // as a dynamic body, whatever the type
    int group = 0;
    bool is_shattered = false;  // by a break, which this part of the body was near enough to
    bool is_released = false;   // becomes dynamic
};

/// One piece for each set of fragments, in the order of their first members. The parts of a shape share its
/// mass by their areas.
std::vector<Piece> make_pieces(const Stores& stores, const std::vector<Fragment>& fragments,
                               UnionFind& together);

/// visit(shape) in order of creation; not for sensors.
template <class Visit>
void for_each_solid_shape(const Stores& stores, int body, Visit&& visit) {
    for (int s = stores.bodies.slots[body].first_shape; s != kNone; s = stores.shapes[s].next_of_body)
        visit(s);
}

}  // namespace cairn::physics
