// Contacts are made and removed.
#include "world/contacts.h"

#include <algorithm>

#include "world/contact_events.h"
#include "world/contact_lists.h"
#include "world/new_contacts.h"
#include "world/sleep.h"
#include "world/special_contacts.h"
#include "world/unheld.h"

namespace cairn::physics {
namespace {

// What a thread takes at once.
constexpr int kGroupsPerChunk = 16;

void remove_contact(Stores& stores, int contact) {
    ContactStore& contacts = stores.contacts;
    ContactRecord& c = contacts.slots[contact];
    unlist_contact(stores, contact);
    unlink_edge(contacts.slots, stores.bodies.slots[c.body_a].first_contact, contact, 0);
    unlink_edge(contacts.slots, stores.bodies.slots[c.body_b].first_contact, contact, 1);
    c.put_in = false;  // its list still names it
    contacts.slots.erase_as_is(contact);
}

}  // namespace

void find_new_pairs(Stores& stores, StepScratch& scratch, TaskPool& tasks) {
    const int groups = stores.broad.start_search(tasks);
    if (groups == 0) {
        scratch.beside.clear(tasks);
        scratch.pairs.clear();
        return stores.broad.end_search(scratch.pairs);
    }
    scratch.found_pairs.start(groups, kGroupsPerChunk, tasks);
    scratch.beside.start(groups, kGroupsPerChunk, tasks);
    tasks.parallel_for(groups, kGroupsPerChunk, [&](const Chunk& chunk) {
        ChunkedList<ItemPair>::Appender found(scratch.found_pairs, chunk);
        ChunkedList<PairsBeside>::Appender beside(scratch.beside, chunk);
        stores.broad.search(chunk.begin, chunk.end, {found.items(), beside.items()});
    });
    scratch.found_pairs.copy_to(scratch.pairs);
    stores.broad.end_search(scratch.pairs);
    make_contacts(stores, scratch.pairs, scratch, tasks);
}

void remove_gone(Stores& stores, Events& events, StepScratch& scratch) {
    const auto& slots = stores.contacts.slots;
    const auto ask = [&](int contact) { slots.ask_for(contact); };
    const auto ask_for_neighbours = [&](int contact) {
        ask_for_place(stores.contacts, contact);
        for (const Edge& edge : slots[contact].edges) {
            if (edge.previous != kNone) slots.ask_for(edge_record(edge.previous));
            if (edge.next != kNone) slots.ask_for(edge_record(edge.next));
        }
    };
    visit_asking_ahead(scratch.gone, kRecordsAhead, ask, ask_for_neighbours, [&](int contact) {
        report_parting(stores, stores.contacts.slots[contact], events.ends);
        remove_contact(stores, contact);
    });
    scratch.gone.clear();
}

void destroy_contact(Stores& stores, Events& events, int contact) {
    ContactRecord& c = stores.contacts.slots[contact];
    if (c.has_points) {
        wake_body(stores, c.body_a);
        wake_body(stores, c.body_b);
    }
    report_parting(stores, c, events.pending_ends);
    note_unheld(stores, contact);
    remove_contact(stores, contact);
}

}  // namespace cairn::physics
