// The life of contacts: made when fat boxes begin to overlap, updated each step, gone when the boxes part.
#pragma once

#include "world/prepare.h"

namespace cairn::physics {

/// Stage: contacts for the pairs that the broad phase reports.
void find_new_pairs(Stores& stores, StepScratch& scratch, TaskPool& tasks);

/// Whether the two shapes have a contact. Costs as much as the shorter of their bodies' lists is long.
[[nodiscard]] bool has_contact(const Stores& stores, int shape_a, int shape_b);

/// Stage: manifolds of all listed contacts, and from them the constraints of this step, in lanes or in plain
/// form; sleeping bodies that are touched wake, and take part in this step.
void update_contacts(WorldState& world, const StepTime& time, const ContactRules& rules);

/// Between steps: the two bodies wake if the contact held them; its end is told with the next step.
void destroy_contact(Stores& stores, Events& events, int contact);

}  // namespace cairn::physics
