// Contacts are made of pairs of shapes. What a contact is to be is drafted on several threads; the drafts are
// taken in one by one, in the order of the pairs.
#pragma once

#include <span>

#include "world/world_state.h"

namespace cairn::physics {

/// Whether the two shapes have a contact. Costs as much as the shorter of their bodies' lists is long.
[[nodiscard]] bool has_contact(const Stores& stores, int shape_a, int shape_b);

/// Makes a contact for each pair that may collide and has none. Each pair is there once.
void make_contacts(Stores& stores, std::span<const ItemPair> pairs, StepScratch& scratch, TaskPool& tasks);

}  // namespace cairn::physics
