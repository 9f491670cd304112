// Contacts and joints of large heaps divided by where they are, so that a thread solves all of its own
// without waiting for others (docs/adr/027-domains.md).
// Invariant: both movable bodies of a contact or joint in the lanes of a domain are of that domain, so
// domains share no body that is moved. All other contacts and joints are of the interface, and are solved
// after those of the domains. Domains are part of the state: passes go by them on any number of threads.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

/// Whether the body is moved in a colour of contacts or joints.
bool is_settled(const Stores& stores, int body);

/// Before a contact or joint gets a colour: a body that has none yet is in the domain that it is in now.
void settle_in_domain(Stores& stores, int body);

/// Of what moves body b, and a if it moves both; they are settled.
int domain_of(const Domains& domains, int body_a, int body_b, bool both);

/// Stage, before rows are looked at: now and then as many domains are made as contacts and joints in lanes
/// are worth. These go to the lanes of their domain, and rows of awake bodies are put in the order of the
/// domains.
void divide_into_domains(Stores& stores, std::uint64_t step_count, StepScratch& scratch);

}  // namespace cairn::physics
