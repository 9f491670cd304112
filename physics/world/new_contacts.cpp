// Drafts of contacts, and how they are taken in.
#include "world/new_contacts.h"

#include <algorithm>

#include "base/ample.h"
#include "world/contact_lists.h"
#include "world/edge_list.h"
#include "world/filtering.h"
#include "world/special_contacts.h"

namespace cairn::physics {
namespace {

// What a thread takes at once.
constexpr int kPairsPerChunk = 32;

// Drafts at once: enough for several threads, and few beside what a small world takes.
constexpr std::size_t kMostDrafts = 256;

// Whether contacts can move the body, now or later.
bool is_immovable(const BodyStore& bodies, int body) {
    return bodies.slots[body].type != BodyType::Dynamic;
}

// All of it but what tells where the contact is: its edges, its list, its number.
void draft(const Stores& stores, const ItemPair& pair, NewContact& made) {
    made.makes =
        !(pair.may_be_known && has_contact(stores, pair.a, pair.b)) && may_collide(stores, pair.a, pair.b);
    if (!made.makes) return;
    ContactRecord& c = made.record;
    c = {};
    c.shape_a = pair.a;
    c.shape_b = pair.b;
    if (is_immovable(stores.bodies, stores.shapes[pair.b].body)) std::swap(c.shape_a, c.shape_b);
    c.special = special_bits(stores, c.shape_a, c.shape_b);
    const ShapeRecord& a = stores.shapes[c.shape_a];
    const ShapeRecord& b = stores.shapes[c.shape_b];
    c.body_a = a.body;
    c.body_b = b.body;
    mix_materials(stores, c);
    c.reports_touch = a.def().contact_events || b.def().contact_events;
    c.reports_hit = a.def().hit_events || b.def().hit_events;
    made.geometry = geometry_of(stores, c);
    fill_near_pair(stores, c, kNone, made.geometry, made.pair);
}

void draft_all(const Stores& stores, std::span<const ItemPair> pairs, std::vector<NewContact>& drafts,
               TaskPool& tasks) {
    const auto ask = [&](const ItemPair& pair) {
        for (const int shape : {pair.a, pair.b}) stores.shapes.ask_for(shape);
    };
    const auto ask_next = [&](const ItemPair& pair) {
        for (const int shape : {pair.a, pair.b}) stores.bodies.slots.ask_for(stores.shapes[shape].body);
    };
    const auto draft_some = [&](const Chunk& chunk) {
        auto made = drafts.begin() + chunk.begin;
        const auto first = static_cast<std::size_t>(chunk.begin);
        const auto count = static_cast<std::size_t>(chunk.end - chunk.begin);
        visit_asking_ahead(pairs.subspan(first, count), kRecordsAhead, ask, ask_next,
                           [&](const ItemPair& pair) { draft(stores, pair, *made++); });
    };
    const int count = static_cast<int>(pairs.size());
    // The host is asked in the order of the pairs, and on its own thread.
    if (stores.rules.filter.may_collide) return draft_some({0, count, 0, 0});
    tasks.parallel_for(count, kPairsPerChunk, draft_some);
}

void take_in(Stores& stores, const NewContact& made) {
    if (!made.makes) return;
    ContactStore& contacts = stores.contacts;
    // Handed over by value, the record would be copied twice, and wait for its own parts.
    const int contact = contacts.slots.insert();
    contacts.slots[contact] = made.record;
    link_edge(contacts.slots, stores.bodies.slots[made.record.body_a].first_contact, contact, 0);
    link_edge(contacts.slots, stores.bodies.slots[made.record.body_b].first_contact, contact, 1);
    list_contact(stores, contact, made);
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

void make_contacts(Stores& stores, std::span<const ItemPair> pairs, StepScratch& scratch, TaskPool& tasks) {
    std::vector<NewContact>& drafts = scratch.new_contacts;
    const auto for_bodies = [&](const NewContact& made, const auto& visit) {
        if (!made.makes) return;
        for (const int body : {made.record.body_a, made.record.body_b}) visit(stores.bodies.slots[body]);
    };
    const auto ask = [&](const NewContact& made) {
        for_bodies(made, [](const BodyRecord& body) { prefetch_to_write(&body.first_contact); });
    };
    // Of each body, the contact ahead of which the new one is linked in.
    const auto ask_for_heads = [&](const NewContact& made) {
        for_bodies(made, [&](const BodyRecord& body) {
            if (body.first_contact != kNone) stores.contacts.slots.ask_for(edge_record(body.first_contact));
        });
    };
    for (; !pairs.empty(); pairs = pairs.subspan(drafts.size())) {
        resize_amply(drafts, std::min(pairs.size(), kMostDrafts));
        draft_all(stores, pairs.first(drafts.size()), drafts, tasks);
        visit_asking_ahead(drafts, kRecordsAhead, ask, ask_for_heads,
                           [&](const NewContact& made) { take_in(stores, made); });
    }
}

}  // namespace cairn::physics
