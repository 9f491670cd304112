// Contacts are made and removed.
#include "world/contacts.h"

#include <algorithm>

#include "world/contact_events.h"
#include "world/contact_lists.h"
#include "world/filtering.h"
#include "world/sleep.h"
#include "world/special_contacts.h"
#include "world/unheld.h"

namespace cairn::physics {
namespace {

// What a thread takes at once.
constexpr int kGroupsPerChunk = 16;

// Whether contacts can move the body, now or later.
bool is_immovable(const BodyStore& bodies, int body) {
    return bodies.slots[body].type != BodyType::Dynamic;
}

void create_contact(Stores& stores, int shape_a, int shape_b) {
    if (is_immovable(stores.bodies, stores.shapes[shape_b].body)) std::swap(shape_a, shape_b);
    const std::uint8_t bits = special_bits(stores, shape_a, shape_b);
    const ShapeRecord& a = stores.shapes[shape_a];
    const ShapeRecord& b = stores.shapes[shape_b];
    ContactStore& contacts = stores.contacts;
    const int contact = contacts.slots.insert();
    ContactRecord& c = contacts.slots[contact];
    c.special = bits;
    c.shape_a = shape_a;
    c.shape_b = shape_b;
    c.body_a = a.body;
    c.body_b = b.body;
    mix_materials(stores, c);
    c.reports_touch = a.def().contact_events || b.def().contact_events;
    c.reports_hit = a.def().hit_events || b.def().hit_events;
    link_edge(contacts.slots, stores.bodies.slots[c.body_a].first_contact, contact, 0);
    link_edge(contacts.slots, stores.bodies.slots[c.body_b].first_contact, contact, 1);
    list_contact(stores, contact);
}

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

bool has_contact(const Stores& stores, int shape_a, int shape_b) {
    const auto& slots = stores.contacts.slots;
    int of_a = stores.bodies.slots[stores.shapes[shape_a].body].first_contact;
    int of_b = stores.bodies.slots[stores.shapes[shape_b].body].first_contact;
    // Both lists at once, until the shorter one ends: what rests on the ground has few contacts, the ground
    // many.
    const auto is_it = [&](int key) {
        const ContactRecord& c = slots[edge_record(key)];
        return (c.shape_a == shape_a && c.shape_b == shape_b) ||
               (c.shape_a == shape_b && c.shape_b == shape_a);
    };
    while (of_a != kNone && of_b != kNone) {
        if (is_it(of_a) || is_it(of_b)) return true;
        of_a = slots[edge_record(of_a)].edges[edge_side(of_a)].next;
        of_b = slots[edge_record(of_b)].edges[edge_side(of_b)].next;
    }
    return false;
}

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
    const auto ask = [&](const ItemPair& pair) {
        for (const int shape : {pair.a, pair.b}) {
            stores.shapes.ask_for(shape);
        }
    };
    const auto ask_for_bodies = [&](const ItemPair& pair) {
        for (const int shape : {pair.a, pair.b}) stores.bodies.slots.ask_for(stores.shapes[shape].body);
    };
    visit_asking_ahead(scratch.pairs, kRecordsAhead, ask, ask_for_bodies, [&](const ItemPair& pair) {
        if (pair.may_be_known && has_contact(stores, pair.a, pair.b)) return;
        if (may_collide(stores, pair.a, pair.b)) create_contact(stores, pair.a, pair.b);
    });
}

void remove_gone(Stores& stores, Events& events, StepScratch& scratch) {
    const auto& slots = stores.contacts.slots;
    const auto ask = [&](int contact) { slots.ask_for(contact); };
    const auto ask_for_neighbours = [&](int contact) {
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
