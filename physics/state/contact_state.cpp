// Records of contacts as bytes: what is of the contact itself. Which shapes meet, and what is remembered,
// stands where the contact is (state/contact_list_state.cpp).
#include "state/sections.h"
#include "state/slots.h"

namespace cairn::physics {
namespace {

// What a contact has: a byte tells, and what it does not tell follows.
constexpr std::uint8_t kHasPoints = 1;
constexpr std::uint8_t kPutIn = 2;
constexpr std::uint8_t kTouching = 4;
constexpr std::uint8_t kReportsTouch = 8;
constexpr std::uint8_t kReportsHit = 16;
constexpr std::uint8_t kIsSpecial = 32;
constexpr std::uint8_t kIsNewMix = 64;  // friction and restitution that the contact before does not have
constexpr std::uint8_t kHasAll = 127;

constexpr std::size_t record_size(std::uint8_t has) {
    return ((has & kIsSpecial) != 0 ? sizeof(ContactRecord::special) : 0) +
           ((has & kIsNewMix) != 0 ? sizeof(ContactRecord::friction) + sizeof(ContactRecord::restitution)
                                   : 0);
}

// Lanes of colours have memories of their own. That of the record is then what it was when the contact came
// into its lane, and still the first guess for one that parts and meets again within a step.
bool remembers(const ContactRecord& contact) {
    const auto& [features, impulse, friction_impulse] = contact.memory;
    return features[0] != kNoFeature || features[1] != kNoFeature || !(impulse[0] == 0) ||
           !(impulse[1] == 0) || !(friction_impulse == 0);
}

// Shapes stand in the lanes or lists of contacts, bodies follow from the links, the rest from the lists;
// memory is written only where there is any.
void save_records(const ContactStore& contacts, Writer& out) {
    std::byte* at = out.room(static_cast<std::size_t>(contacts.slots.size()) * (1 + record_size(kHasAll)));
    float last_friction = 0;
    float last_restitution = 0;
    for_each_alive(contacts.slots, [&](int, const ContactRecord& record) {
        const auto& [shape_a, shape_b, body_a, body_b, edges, bucket, lane, uneven_index, memory, friction,
                     restitution, has_points, put_in, touching, reports_touch, reports_hit, special] = record;
        const bool is_new =
            (differing_bits(friction, last_friction) | differing_bits(restitution, last_restitution)) != 0;
        at = put(at, static_cast<std::uint8_t>(
                         (has_points ? kHasPoints : 0) | (put_in ? kPutIn : 0) | (touching ? kTouching : 0) |
                         (reports_touch ? kReportsTouch : 0) | (reports_hit ? kReportsHit : 0) |
                         (special != 0 ? kIsSpecial : 0) | (is_new ? kIsNewMix : 0)));
        if (special != 0) at = put(at, special);
        if (is_new) at = put(put(at, friction), restitution);
        last_friction = friction;
        last_restitution = restitution;
    });
    out.end(at);
}

void load_records(Reader& in, ContactStore& contacts) {
    // Copied whole: made field by field at its place, the processor would wait for the halves of its words.
    ContactRecord made{.bucket = kUnplaced};
    std::uint8_t last = 0;
    const std::byte* at = in.rest().data();
    std::size_t left = in.rest().size();
    Reading reading;
    contacts.put_in.clear();
    for_each_alive(contacts.slots, [&](int contact, ContactRecord& record) {
        if (!in.ok()) return;
        const auto has = left > 0 ? std::to_integer<std::uint8_t>(*at) : std::uint8_t{0};
        const std::size_t size = 1 + record_size(has);
        if (!in.require(size <= left, "it ends in the middle of the contacts")) return;
        if (!in.require(has <= kHasAll, "a contact has what no contact has")) return;
        left -= size;
        ++at;
        if (has != last || size > 1) {
            made.special = 0;
            if ((has & kIsSpecial) != 0) at = get(at, made.special, reading);
            if ((has & kIsNewMix) != 0) at = get(get(at, made.friction, reading), made.restitution, reading);
            made.has_points = (has & kHasPoints) != 0;
            made.put_in = (has & kPutIn) != 0;
            made.touching = (has & kTouching) != 0;
            made.reports_touch = (has & kReportsTouch) != 0;
            made.reports_hit = (has & kReportsHit) != 0;
            last = has;
        }
        record = made;
        if (made.put_in) contacts.put_in.push_back(contact);
    });
    if (!in.ok()) return;
    in.end(at);
    in.reading.bad |= reading.bad;
    in.settle();
}

void save_memories(const ContactStore& contacts, Writer& out) {
    const std::size_t start = out.size();
    std::uint32_t count = 0;
    out.value(count);
    for_each_alive(contacts.slots, [&](int contact, const ContactRecord& record) {
        if (!remembers(record)) return;
        ++count;
        out.value(contact);
        out.value(record.memory);
    });
    put(out.data() + start, count);
}

void load_memories(Reader& in, ContactStore& contacts) {
    constexpr std::size_t kBytes = sizeof(int) + packed_size<ContactMemory>();
    const std::size_t count = in.count(kBytes);
    const std::byte* at = in.take(count * kBytes);
    if (at == nullptr) return;
    Reading reading;
    for (std::size_t i = 0; i < count; ++i) {
        int contact = kNone;
        at = get(at, contact, reading);
        if (!in.require(names(contacts.slots, contact), "a contact is remembered that there is not")) return;
        at = get(at, contacts.slots[contact].memory, reading);
    }
    in.reading.bad |= reading.bad;
    in.settle();
}

}  // namespace

void save_contacts(const ContactStore& contacts, Writer& out) {
    save_slots(contacts.slots, out);
    save_records(contacts, out);
    save_memories(contacts, out);
}

void load_contacts(Reader& in, ContactStore& contacts) {
    in.begin("contacts");
    load_slots(in, contacts.slots);
    if (in.ok()) load_records(in, contacts);
    if (in.ok()) load_memories(in, contacts);
}

}  // namespace cairn::physics
