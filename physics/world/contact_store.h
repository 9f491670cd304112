// Contacts: pairs of shapes whose fat boxes overlap.
// Invariant: a pair has at most one contact; body b can be moved by the contact, body a is the one that
// cannot if there is such; a contact is listed, in a bucket of lanes or among the loose ones, exactly when
// one of its bodies is awake; it is in the edge lists of both bodies.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <cairn/physics/ids.h>

#include "base/prefetch.h"
#include "base/slot_map.h"
#include "resolve/contact_lanes.h"
#include "world/active_list.h"
#include "world/edge_list.h"

namespace cairn::physics {

/// The list of contacts that are solved in plain form, one by one.
inline constexpr int kLooseBucket = kBuckets;

struct ContactRecord {
    int shape_a = kNone;
    int shape_b = kNone;
    int body_a = kNone;
    int body_b = kNone;
    Edges edges;
    int bucket = kNone;  // kNone: not listed
    int lane = 0;        // in the bucket, or among the loose contacts
    int uneven_index = kNone;
    ContactMemory memory;  // kept in the lane instead while the contact is in a colour
    float friction = 0;
    float restitution = 0;
    bool has_points = false;
    bool put_in =
        false;  // the bodies were put into each other, or may have been: it has points since this step
    bool touching = false;  // kept up for contacts that report touching
    bool reports_touch = false;
    bool reports_hit = false;
    std::uint8_t special = 0;  // bits of world/special_contacts.h
};

/// Whether so little speed comes back that impacts are no more than stops: at most a 25th of the energy. Such
/// impacts go on to what else is touched by being stopped there, and win nothing: each gives at most e^2 of
/// what stopping it took, and a body would have to meet 25 others at once.
constexpr bool gives_back_little(float restitution) {
    return restitution <= 0.2f;
}

/// The restitution of impacts that may bounce in their lanes, 0 for others: those which give back little, and
/// of which nobody is told.
constexpr float faint_restitution(const ContactRecord& c) {
    return gives_back_little(c.restitution) && !c.reports_hit ? c.restitution : 0;
}

struct ContactStore {
    explicit ContactStore(std::uint16_t world_tag) : slots(world_tag) {}

    SlotMap<ContactRecord, Handle<struct ContactTag>> slots;
    ContactLanes lanes;
    std::vector<int> loose;
    std::vector<int> unheld;  // bodies that lost what held them, while a call is under way
    std::vector<int> put_in;  // those of which the bodies were put into each other, and some that went
    int tiny = 0;             // how many of them are (world/tiny_contacts.h)
    ActiveList<&ContactRecord::uneven_index> uneven;  // of those that are listed: world/direct_groups.h
    std::vector<std::uint32_t> colors;  // by body slot: bits of those in which the body is moved
};

/// Of a body's colours. Counting bits would be a call, where processors are not known to do it.
constexpr bool is_in_several(std::uint32_t colors) {
    return (colors & (colors - 1)) != 0;
}

/// How many records ahead.
inline constexpr std::size_t kRecordsAhead = 8;

/// Calls visit(contact) for each of some, which stand all over memory.
template <class Visit>
void visit_contacts(const ContactStore& contacts, std::span<const int> some, const Visit& visit) {
    visit_asking_ahead(
        some, kRecordsAhead, [&](int contact) { contacts.slots.ask_for(contact); }, visit);
}

/// The same, and asks, half as far ahead, by ask_next(contact) for what the record tells of.
template <class AskNext, class Visit>
void visit_contacts(const ContactStore& contacts, std::span<const int> some, const AskNext& ask_next,
                    const Visit& visit) {
    visit_asking_ahead(
        some, kRecordsAhead, [&](int contact) { contacts.slots.ask_for(contact); }, ask_next, visit);
}

}  // namespace cairn::physics
