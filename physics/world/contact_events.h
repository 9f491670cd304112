// What the world tells about contacts: begin, end and hit.
// Invariant: a touching pair that reports was announced by one begin, and is taken back by one end.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

/// Contacts exist from a speculative distance on; touching means that a force acted, or that no gap can be
/// seen. Leaving takes twice the gap, so that a trembling pair does not flood its listener.
bool touches(int count, const std::array<float, 2>& impulse, const std::array<float, 2>& separation,
             bool touched);

/// Whether the pair touches, as far as is known after the last step.
bool is_touching(const ContactStore& contacts, int contact);

/// The contact has no points any more, or is about to go: if it touched, `ends` says so.
void report_parting(const Stores& stores, ContactRecord& contact, std::vector<ContactEnd>& ends);

/// Stage after the substeps: which pairs touch now, and which met fast.
void report_contacts(Stores& stores, const StepScratch& scratch, float hit_speed_m_s, Events& events);

}  // namespace cairn::physics
