// Shapes that are solid from one side only. The decision falls when two shapes meet: whoever comes from the
// side that the normal points to meets a contact like any other, everyone else goes through.
// Invariant: a contact stays what it became until the pair is apart; then, or once it is in front again, it
// is decided anew.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

inline bool is_one_way(const ShapeRecord& shape) {
    return shape.def().one_way_normal != Vec2{};
}

/// The direction with length 1; (0, 0) stays.
Vec2 unit_or_zero(Vec2 direction);

/// Whether a contact with special::kOneWay that would have points keeps them; decided when the two meet.
bool is_held_out(const Stores& stores, ContactRecord& contact);

/// The shapes of such a contact are apart.
void forget_side(ContactRecord& contact);

/// The shape's normal has changed: what it touches is decided anew, and wakes.
void reconsider_one_way(Stores& stores, int shape);

}  // namespace cairn::physics
