// Contacts of large heaps divided by where they are, so that a thread solves all of its own without waiting
// for others (docs/adr/027-domains.md).
// Invariant: both movable bodies of a contact in the lanes of a domain are of that domain, so domains share
// no body that is moved. All other contacts are of the interface, and are solved after those of the domains.
// Domains are part of the state: passes go by them on any number of threads.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

/// Before a contact gets a colour: a body that has none yet is in the domain that it is in now.
void settle_in_domain(const Stores& stores, ContactStore& contacts, int body);

/// Of a contact in a lane, between bodies that are settled.
int domain_of(const ContactStore& contacts, const ContactRecord& contact, BlockKind kind);

/// As many as the contacts in lanes are worth. Contacts go to the lanes of their domain, and rows of awake
/// bodies are put in the order of the domains. Before a step looks at rows only.
void divide_into_domains(Stores& stores, DomainScratch& scratch);

}  // namespace cairn::physics
