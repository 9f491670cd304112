// Contacts as bytes. Records hold what is of the contact itself; which shapes meet, and what is remembered,
// stands where the contact is: in a lane, among the loose ones, or in no list.
//
// Of a block only what outlasts a step is written: who is in its lanes, their boxes, features and impulses.
// All else is made anew at the start of each step, before anybody looks at it. Blocks stand in the order of
// their chains, which is the order of the passes; their numbers are not part of the state.
#include <algorithm>
#include <bit>

#include <cairn/physics/tuning.h>

#include "state/sections.h"
#include "state/slots.h"
#include "world/contact_lists.h"
#include "world/special_contacts.h"

namespace cairn::physics {
namespace {

// A contact that was read, but not yet found in any list.
constexpr int kUnplaced = -2;

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

using IntLanes = Lanes<std::int32_t>;
using FloatLanes = Lanes<float>;
constexpr std::size_t kLaneRow = sizeof(IntLanes);

constexpr int kBoxRows = 8;
static_assert(sizeof(BoxLanes) == kBoxRows * kLaneRow);
using BoxNumbers = std::array<float, kBoxRows * kLanes>;
constexpr int kBits = 3;  // bytes of bits by lane: reports, impacts, remembers

// Contact, two shapes, boxes, reaches.
constexpr std::size_t kNearBytes = (3 + kBoxRows + 1) * kLaneRow + kBits;
// Contact, two shapes, boxes, two features, two impulses, that of friction.
constexpr std::size_t kColoredBytes = (3 + kBoxRows + 5) * kLaneRow + kBits + 1;  // and who touches

struct UnlistedContact {
    std::int32_t shape_a = kNone;
    std::int32_t shape_b = kNone;
};

// m. For points that do not touch: more than the slop.
constexpr float kApart_m = 1;

constexpr unsigned lanes_below(int used) {
    return (1u << used) - 1;
}

// Lanes that nobody is in hold what the last one left there, which means nothing.
template <class T>
std::byte* put_lanes(std::byte* at, const Lanes<T>& lanes, int used, T unused) {
    Lanes<T> clean = lanes;
    for (int lane = used; lane < kLanes; ++lane) clean[static_cast<std::size_t>(lane)] = unused;
    return put(at, clean);
}

template <class T>
bool is_unused(const Lanes<T>& lanes, int used, T unused) {
    return std::all_of(lanes.begin() + used, lanes.end(), [unused](T value) { return value == unused; });
}

// As put_lanes leaves them. Passes go over all lanes of a block, so nothing may lie hidden there.
bool is_unused(const PairBlock& pairs, int used) {
    const auto& [contact, body_a, body_b, shape_a, shape_b, boxes, features, reports, impacts, remembers,
                 seen] = pairs;
    const auto& [half_ax, half_ay, half_bx, half_by, offset_ax, offset_ay, offset_bx, offset_by] = boxes;
    bool unused = static_cast<unsigned>(reports | impacts | remembers) <= lanes_below(used);
    for (const IntLanes* lanes : {&contact, &shape_a, &shape_b}) unused &= is_unused(*lanes, used, kNone);
    for (const IntLanes& lanes : features) unused &= is_unused(lanes, used, kNoFeature);
    for (const FloatLanes* lanes :
         {&half_ax, &half_ay, &half_bx, &half_by, &offset_ax, &offset_ay, &offset_bx, &offset_by})
        unused &= is_unused(*lanes, used, 0.0f);
    return unused;
}

bool is_unused(const ContactBlock& block, int used) {
    bool unused = is_unused(block.friction_impulse, used, 0.0f);
    for (const ContactBlockPoint& point : block.points) unused &= is_unused(point.impulse, used, 0.0f);
    return unused;
}

// What near blocks and those in colours have in common.
std::byte* put_pairs(std::byte* at, const PairBlock& pairs, int used) {
    const auto& [contact, body_a, body_b, shape_a, shape_b, boxes, features, reports, impacts, remembers,
                 seen] = pairs;
    for (const IntLanes* lanes : {&contact, &shape_a, &shape_b}) at = put_lanes(at, *lanes, used, kNone);
    const auto& [half_ax, half_ay, half_bx, half_by, offset_ax, offset_ay, offset_bx, offset_by] = boxes;
    for (const FloatLanes* lanes :
         {&half_ax, &half_ay, &half_bx, &half_by, &offset_ax, &offset_ay, &offset_bx, &offset_by})
        at = put_lanes(at, *lanes, used, 0.0f);
    for (const std::uint8_t bits : {reports, impacts, remembers})
        at = put(at, static_cast<std::uint8_t>(bits & lanes_below(used)));
    return at;
}

const std::byte* get_pairs(const std::byte* at, PairBlock& pairs, Reading& reading) {
    auto& [contact, body_a, body_b, shape_a, shape_b, boxes, features, reports, impacts, remembers, seen] =
        pairs;
    for (IntLanes* lanes : {&contact, &shape_a, &shape_b}) at = get(at, *lanes, reading);
    BoxNumbers numbers;
    at = get(at, numbers, reading);
    boxes = std::bit_cast<BoxLanes>(numbers);
    body_a.fill(kNone);
    body_b.fill(kNone);
    for (auto& lanes : features) lanes.fill(kNoFeature);
    for (std::uint8_t* bits : {&reports, &impacts, &remembers}) at = get(at, *bits, reading);
    seen = 0;  // they are looked at again
    return at;
}

void save_near(const ContactLanes& lanes, Writer& out) {
    StateAccess::near(lanes, [&](const auto& near, const auto& reaches, const auto&, const auto& counts) {
        for (std::size_t g = 0; g < near.size(); ++g) {
            const int count = counts[g];
            out.count(static_cast<std::size_t>(count));
            const int blocks = (count + kLanes - 1) / kLanes;
            std::byte* at = out.room(static_cast<std::size_t>(blocks) * kNearBytes);
            for (int block = 0; block < blocks; ++block) {
                const int used = std::min(kLanes, count - block * kLanes);
                const auto i = static_cast<std::size_t>(block);
                at = put_lanes(put_pairs(at, near[g][i], used), reaches[g][i].m, used, 0.0f);
            }
            out.end(at);
        }
    });
}

// Of separations only this is asked between steps: whether they are so small that the two touch.
std::uint8_t touching_lanes(const ContactBlock& block, int used) {
    unsigned touching = 0;
    for (int i = 0; i < used; ++i) {
        const auto lane = static_cast<std::size_t>(i);
        const float gap = std::min(block.points[0].separation[lane], block.points[1].separation[lane]);
        touching |= (gap < tuning::kLinearSlop_m ? 1u : 0u) << i;
    }
    return static_cast<std::uint8_t>(touching);
}

void save_colored(const ContactLanes& lanes, Writer& out) {
    StateAccess::colored(lanes, [&](const auto& pairs, const auto& links, const auto& blocks, const auto&,
                                    const auto& chains, const auto&) {
        const auto used = std::count_if(chains.begin(), chains.end(),
                                        [](const auto& chain) { return chain.first != kNone; });
        out.count(static_cast<std::size_t>(used));
        for (std::size_t bucket = 0; bucket < chains.size(); ++bucket) {
            if (chains[bucket].first == kNone) continue;
            std::size_t length = 0;
            const auto next = [&](int block) { return links[static_cast<std::size_t>(block)].next; };
            for (int block = chains[bucket].first; block != kNone; block = next(block)) ++length;
            out.count(bucket);
            out.count((length - 1) * kLanes +
                      static_cast<std::size_t>(links[static_cast<std::size_t>(chains[bucket].last)].used));
            std::byte* at = out.room(length * kColoredBytes);
            for (int block = chains[bucket].first; block != kNone; block = next(block)) {
                const auto i = static_cast<std::size_t>(block);
                const int lanes_used = links[i].used;
                at = put_pairs(at, pairs[i], lanes_used);
                for (const IntLanes& features : pairs[i].features)
                    at = put_lanes(at, features, lanes_used, kNoFeature);
                for (const ContactBlockPoint& point : blocks[i].points)
                    at = put_lanes(at, point.impulse, lanes_used, 0.0f);
                at = put_lanes(at, blocks[i].friction_impulse, lanes_used, 0.0f);
                at = put(at, touching_lanes(blocks[i], lanes_used));
            }
            out.end(at);
        }
    });
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

// Puts the contacts that were read into the lists and lanes that the bytes name.
class Placing {
  public:
    Placing(Reader& in, Stores& stores)
        : in_(in), stores_(stores), contacts_(stores.contacts.slots), shapes_(stores.shapes) {}

    void load() {
        stores_.contacts.colors.assign(static_cast<std::size_t>(stores_.bodies.slots.end_index()), 0);
        load_loose();
        if (in_.ok()) load_near();
        if (in_.ok()) load_colored();
        if (in_.ok()) load_unlisted();
        if (in_.ok()) load_uneven();
    }

  private:
    static constexpr const char* kUsed = "a lane of contacts holds something, though none is in it";
    static constexpr const char* kMisplaced =
        "a contact is in two places, or of shapes that its bodies do not have";

    bool fits(int shape, int body) const {
        const ShapeRecord* const record = shapes_.find(shape);
        return record != nullptr && record->body == body && record->sensor == kNone;
    }

    ContactRecord* place(int contact, int shape_a, int shape_b, int bucket, int lane) {
        ContactRecord* const record = contacts_.find(contact);
        if (record == nullptr || record->bucket != kUnplaced || !fits(shape_a, record->body_a) ||
            !fits(shape_b, record->body_b))
            return nullptr;
        record->shape_a = shape_a;
        record->shape_b = shape_b;
        record->bucket = bucket;
        record->lane = lane;
        return record;
    }

    bool place_lanes(PairBlock& pairs, int used, int bucket, int first_lane) {
        if (!in_.require(is_unused(pairs, used), kUsed)) return false;
        for (int i = 0; i < used; ++i) {
            const auto lane = static_cast<std::size_t>(i);
            const ContactRecord* record =
                place(pairs.contact[lane], pairs.shape_a[lane], pairs.shape_b[lane], bucket, first_lane + i);
            if (!in_.require(record != nullptr, kMisplaced)) return false;
            pairs.body_a[lane] = record->body_a;
            pairs.body_b[lane] = record->body_b;
        }
        return true;
    }

    void load_loose() {
        std::vector<int>& loose = stores_.contacts.loose;
        loose.resize(in_.count(3 * sizeof(int)));
        stores_.contacts.tiny = 0;
        for (std::size_t i = 0; i < loose.size(); ++i) {
            UnlistedContact shapes;
            in_.value(loose[i]);
            in_.value(shapes.shape_a);
            in_.value(shapes.shape_b);
            if (!in_.require(place(loose[i], shapes.shape_a, shapes.shape_b, kLooseBucket,
                                   static_cast<int>(i)) != nullptr,
                             kMisplaced))
                return;
            stores_.contacts.tiny += special::has(stores_.contacts.slots[loose[i]], special::kTiny) ? 1 : 0;
        }
    }

    void load_unlisted() {
        for_each_alive(stores_.contacts.slots, [&](int contact, ContactRecord& record) {
            if (!in_.ok() || record.bucket != kUnplaced) return;
            UnlistedContact shapes;
            in_.value(shapes.shape_a);
            in_.value(shapes.shape_b);
            in_.require(place(contact, shapes.shape_a, shapes.shape_b, kNone, 0) != nullptr, kMisplaced);
        });
    }

    void load_near() {
        StateAccess::near(stores_.contacts.lanes, [&](auto& near, auto& reaches, auto& sights, auto& counts) {
            for (std::size_t g = 0; g < near.size(); ++g) {
                const std::size_t count = in_.count(kNearBytes / kLanes);
                const std::size_t blocks = (count + kLanes - 1) / kLanes;
                const std::byte* at = in_.take(blocks * kNearBytes);
                counts[g] = 0;
                if (at == nullptr) return;
                near[g].resize(blocks);
                reaches[g].resize(blocks);
                sights[g].resize(blocks * kLanes);
                counts[g] = static_cast<int>(count);
                const int bucket = near_bucket(static_cast<PairGeometry>(g));
                for (std::size_t block = 0; block < blocks; ++block) {
                    at = get_pairs(at, near[g][block], in_.reading);
                    at = get(at, reaches[g][block].m, in_.reading);
                    const int first_lane = static_cast<int>(block) * kLanes;
                    const int used = std::min(kLanes, static_cast<int>(count) - first_lane);
                    if (!in_.require(is_unused(reaches[g][block].m, used, 0.0f), kUsed)) return;
                    if (!place_lanes(near[g][block], used, bucket, first_lane)) return;
                }
            }
        });
        in_.settle();
    }

    void load_colored() {
        StateAccess::colored(stores_.contacts.lanes, [&](auto& pairs, auto& links, auto& blocks, auto& free,
                                                         auto& chains, bool& is_arranged) {
            links.clear();
            free.clear();
            chains.fill({});
            is_arranged = false;
            const std::size_t buckets = in_.count(2 * sizeof(std::uint32_t));
            for (std::size_t i = 0; i < buckets && in_.ok(); ++i) {
                std::uint32_t bucket = 0;
                in_.value(bucket);
                const bool fits = bucket < kBuckets && is_colored(static_cast<int>(bucket)) &&
                                  chains[bucket].first == kNone;
                if (!in_.require(fits, "a colour of contacts is none, or is there twice")) return;
                load_bucket(static_cast<int>(bucket), pairs, links, blocks, chains[bucket]);
            }
            pairs.resize(links.size());
            blocks.resize(links.size());
            free.reserve(pairs.capacity());
        });
        if (in_.settle()) stores_.contacts.lanes.arrange();
    }

    template <class Chain>
    void load_bucket(int bucket, std::vector<PairBlock>& pairs, std::vector<BlockLink>& links,
                     std::vector<ContactBlock>& blocks, Chain& chain) {
        const std::size_t count = in_.count(kColoredBytes / kLanes);
        const std::size_t length = (count + kLanes - 1) / kLanes;
        const std::byte* at = in_.take(length * kColoredBytes);
        if (at == nullptr || !in_.require(count > 0, "a colour of contacts is empty")) return;
        const std::size_t first = links.size();
        links.resize(first + length);
        // What blocks held before is read over, or made anew by the next step, before anybody looks at it.
        if (pairs.size() < first + length) pairs.resize(first + length);
        if (blocks.size() < first + length) blocks.resize(first + length);
        chain = {static_cast<int>(first), static_cast<int>(first + length) - 1};
        for (std::size_t i = 0; i < length; ++i) {
            const int block = static_cast<int>(first + i);
            const int used = std::min(kLanes, static_cast<int>(count - i * kLanes));
            PairBlock& pair_block = pairs[first + i];
            ContactBlock& contact_block = blocks[first + i];
            at = get_pairs(at, pair_block, in_.reading);
            for (IntLanes& features : pair_block.features) at = get(at, features, in_.reading);
            for (ContactBlockPoint& point : contact_block.points) at = get(at, point.impulse, in_.reading);
            at = get(at, contact_block.friction_impulse, in_.reading);
            std::uint8_t touching = 0;
            at = get(at, touching, in_.reading);
            for (int lane = 0; lane < kLanes; ++lane)
                contact_block.points[0].separation[static_cast<std::size_t>(lane)] =
                    (touching >> lane & 1) != 0 ? 0.0f : kApart_m;
            contact_block.points[1].separation.fill(kApart_m);
            links[first + i] = {bucket, used, i > 0 ? block - 1 : kNone, i + 1 < length ? block + 1 : kNone};
            if (!in_.require(touching <= lanes_below(used) && is_unused(contact_block, used), kUsed)) return;
            if (!place_lanes(pair_block, used, bucket, block * kLanes)) return;
            for (int lane = 0; lane < used; ++lane) color(bucket, pair_block, lane, contact_block);
        }
    }

    // Marks the colour of the bodies, in which nobody else may be, and takes the friction from the record.
    void color(int bucket, const PairBlock& pairs, int at, ContactBlock& block) {
        const auto lane = static_cast<std::size_t>(at);
        const int a = pairs.body_a[lane];
        const int b = pairs.body_b[lane];
        const BodyType type_a = stores_.bodies.slots[a].type;
        const BlockKind kind = kind_of(bucket);
        const std::uint32_t bit = 1u << color_of(bucket);
        std::uint32_t& colors_b = stores_.contacts.colors[static_cast<std::size_t>(b)];
        bool fits = (colors_b & bit) == 0 && stores_.bodies.slots[b].inverse_mass > 0 &&
                    (type_a == BodyType::Static) == (kind == BlockKind::OneBody) &&
                    (type_a == BodyType::Kinematic) == (kind == BlockKind::Carried);
        colors_b |= bit;
        if (kind == BlockKind::TwoBodies) {
            std::uint32_t& colors_a = stores_.contacts.colors[static_cast<std::size_t>(a)];
            fits = fits && (colors_a & bit) == 0 && stores_.bodies.slots[a].inverse_mass > 0;
            colors_a |= bit;
        }
        in_.require(fits, "a body is moved twice in one colour of contacts, or by none that moves it");
        block.friction[lane] = stores_.contacts.slots[pairs.contact[lane]].friction;
    }

    void load_uneven() {
        StateAccess::list(stores_.contacts.uneven, [&](std::vector<int>& list) {
            in_.list(list);
            for (std::size_t i = 0; i < list.size() && in_.ok(); ++i) {
                const bool fits = names(stores_.contacts.slots, list[i]) &&
                                  stores_.contacts.slots[list[i]].bucket != kNone &&
                                  stores_.contacts.slots[list[i]].uneven_index == kNone;
                if (!in_.require(fits, "a contact is listed that is in no list, or twice")) return;
                stores_.contacts.slots[list[i]].uneven_index = static_cast<int>(i);
            }
        });
    }

    Reader& in_;
    Stores& stores_;
    Lookup<decltype(ContactStore::slots)> contacts_;
    Lookup<ShapeStore> shapes_;
};

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

void save_contact_lists(const ContactStore& contacts, Writer& out) {
    constexpr std::size_t kShapesBytes = 2 * sizeof(int);
    std::byte* at = out.room(sizeof(int) + contacts.loose.size() * (sizeof(int) + kShapesBytes));
    at = put(at, static_cast<std::uint32_t>(contacts.loose.size()));
    for (const int contact : contacts.loose) {
        const ContactRecord& record = contacts.slots[contact];
        at = put(put(put(at, contact), record.shape_a), record.shape_b);
    }
    out.end(at);
    save_near(contacts.lanes, out);
    save_colored(contacts.lanes, out);
    at = out.room(static_cast<std::size_t>(contacts.slots.size()) * kShapesBytes);
    for_each_alive(contacts.slots, [&](int, const ContactRecord& record) {
        if (record.bucket == kNone) at = put(put(at, record.shape_a), record.shape_b);
    });
    out.end(at);
    StateAccess::list(contacts.uneven, [&](const std::vector<int>& list) { out.list(list); });
}

void load_contact_lists(Reader& in, Stores& stores) {
    in.begin("lists of contacts");
    Placing(in, stores).load();
}

}  // namespace cairn::physics
