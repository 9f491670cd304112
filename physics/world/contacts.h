// The life of contacts: made when fat boxes begin to overlap, updated each step, gone when the boxes part.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

/// Stage: contacts for the pairs that the broad phase reports.
void find_new_pairs(Stores& stores);

/// Whether the two shapes have a contact. Costs as much as the shorter of their bodies' lists is long.
[[nodiscard]] bool has_contact(const Stores& stores, int shape_a, int shape_b);

/// Stage: manifolds of all active contacts, with impulses carried over by feature; sleeping bodies that are
/// touched wake, and their contacts are updated in the same pass.
void update_contacts(Stores& stores, Events& events, std::vector<int>& parted, Vec2 gravity_m_s2, float dt_s);

/// Between steps: the two bodies wake if the contact held them; its end is told with the next step.
void destroy_contact(Stores& stores, Events& events, int contact);

}  // namespace cairn::physics
