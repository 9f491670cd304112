// Where contacts are, as bytes: in a lane, among the loose ones, or in no list; which shapes meet stands
// there. Blocks stand in the order of their chains, which is the order of the passes; their numbers are not
// part of the state.
#include <algorithm>
#include <cmath>

#include "state/contact_blocks.h"
#include "state/sections.h"
#include "state/slots.h"
#include "world/contact_lists.h"
#include "world/domains.h"
#include "world/special_contacts.h"

namespace cairn::physics {
namespace {

struct UnlistedContact {
    std::int32_t shape_a = kNone;
    std::int32_t shape_b = kNone;
};

// Contact, two shapes, and whether it had points.
constexpr std::size_t kNearPairBytes = 3 * sizeof(std::int32_t) + 1;

// What else is known of a near pair follows from its shapes and bodies.
void save_near(const ContactLanes& lanes, Writer& out) {
    for (int g = 0; g < kPairGeometries; ++g) {
        const auto geometry = static_cast<PairGeometry>(g);
        const auto count = static_cast<std::size_t>(lanes.near_count(geometry));
        out.count(count);
        std::byte* at = out.room(count * kNearPairBytes);
        for (const NearPair& pair : std::span(lanes.near_pairs(geometry)).first(count)) {
            at = put(put(put(at, pair.contact), pair.shape_a), pair.shape_b);
            at = put(at, static_cast<std::uint8_t>(pair.flags & near_flag::kRemembers));
        }
        out.end(at);
    }
}

void save_colored(const ContactLanes& lanes, Writer& out) {
    StateAccess::colored(lanes, [&](const auto& pairs, const auto& links, const auto& blocks, const auto&,
                                    const auto&, const auto& chains, const auto&) {
        const auto used = std::count_if(chains.begin(), chains.end(),
                                        [](const auto& chain) { return chain.first != kNone; });
        out.count(static_cast<std::size_t>(used));
        RepeatedParts last;
        for (std::size_t bucket = 0; bucket < chains.size(); ++bucket) {
            if (chains[bucket].first == kNone) continue;
            std::size_t length = 0;
            const auto next = [&](int block) { return links[static_cast<std::size_t>(block)].next; };
            for (int block = chains[bucket].first; block != kNone; block = next(block)) ++length;
            out.count(bucket);
            out.count((length - 1) * kLanes +
                      static_cast<std::size_t>(links[static_cast<std::size_t>(chains[bucket].last)].used));
            std::byte* at = out.room(length * kColoredBlockBytes.most);
            for (int block = chains[bucket].first; block != kNone; block = next(block)) {
                const auto i = static_cast<std::size_t>(block);
                at = put_colored_block(at, pairs[i], blocks[i], links[i].used, last);
            }
            out.end(at);
        }
    });
}

// Puts the contacts that were read into the lists and lanes that the bytes name.
class Placing {
  public:
    Placing(Reader& in, Stores& stores)
        : in_(in), stores_(stores), contacts_(stores.contacts.slots), shapes_(stores.shapes) {}

    void load() {
        stores_.contacts.colors.assign(static_cast<std::size_t>(stores_.bodies.slots.end_index()), 0);
        load_domains();
        if (in_.ok()) load_loose();
        if (in_.ok()) load_near();
        if (in_.ok()) load_colored();
        if (in_.ok()) load_unlisted();
        if (in_.ok()) load_uneven();
    }

  private:
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

    void load_domains() {
        Domains& domains = stores_.domains;
        in_.value(domains.count);
        std::uint8_t by = 0;
        in_.value(by);
        in_.value(domains.cuts);
        const bool fits = domains.count >= 0 && domains.count <= kMostDomains && domains.count != 1 &&
                          by <= static_cast<std::uint8_t>(DividedBy::Y) &&
                          std::ranges::all_of(domains.cuts, [](double x) { return std::isfinite(x); }) &&
                          std::ranges::is_sorted(domains.cuts.begin(),
                                                 domains.cuts.begin() + std::max(domains.count - 1, 0));
        if (!in_.require(fits, "contacts are divided into domains that cannot be")) return;
        domains.by = static_cast<DividedBy>(by);
        in_.list(domains.of_body);
        const auto is_one = [&](std::uint8_t domain) { return domain <= domains.count; };
        in_.require(domains.of_body.size() <= stores_.contacts.colors.size() &&
                        std::ranges::all_of(domains.of_body, is_one),
                    "a body is in a domain that is none");
        if (domains.count > 0) domains.of_body.resize(stores_.contacts.colors.size());
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
        ContactLanes& lanes = stores_.contacts.lanes;
        StateAccess::near(lanes, [](auto& pairs, auto& counts) {
            for (auto& list : pairs) list.clear();
            counts.fill(0);
        });
        for (int g = 0; g < kPairGeometries; ++g) {
            const auto geometry = static_cast<PairGeometry>(g);
            const std::size_t count = in_.count(kNearPairBytes);
            for (std::size_t i = 0; i < count; ++i) {
                if (!load_near_pair(geometry, static_cast<int>(i))) return;
            }
        }
    }

    bool load_near_pair(PairGeometry geometry, int lane) {
        int contact = kNone;
        UnlistedContact shapes;
        std::uint8_t remembers = 0;
        in_.value(contact);
        in_.value(shapes.shape_a);
        in_.value(shapes.shape_b);
        in_.value(remembers);
        const int bucket = near_bucket(geometry);
        const ContactRecord* record = place(contact, shapes.shape_a, shapes.shape_b, bucket, lane);
        if (!in_.require(record != nullptr, kMisplaced)) return false;
        const bool fits = geometry_of(stores_, *record) == geometry && remembers <= near_flag::kRemembers;
        if (!in_.require(fits, "a pair without points is among others of another form")) return false;
        ContactLanes& lanes = stores_.contacts.lanes;
        NearPair& pair = lanes.near_pairs(geometry)[lanes.open_near(geometry)];
        fill_near_pair(stores_, *record, contact, geometry, pair);
        pair.flags = remembers;
        return true;
    }

    void load_colored() {
        StateAccess::colored(
            stores_.contacts.lanes, [&](auto& pairs, auto& links, auto& blocks, auto& impacts, auto& free,
                                        auto& chains, bool& is_arranged) {
                links.clear();
                impacts.clear();
                free.clear();
                chains.clear();
                is_arranged = false;
                RepeatedParts last;
                const std::size_t buckets = in_.count(2 * sizeof(std::uint32_t));
                for (std::size_t i = 0; i < buckets && in_.ok(); ++i) {
                    std::uint32_t bucket = 0;
                    in_.value(bucket);
                    const int most = stores_.domains.count;
                    const bool fits = bucket < kBuckets && is_colored(static_cast<int>(bucket)) &&
                                      domain_of(static_cast<int>(bucket)) <= most &&
                                      (bucket >= chains.size() || chains[bucket].first == kNone);
                    if (!in_.require(fits, "a colour of contacts is none, or is there twice")) return;
                    const int domains = domain_of(static_cast<int>(bucket)) + 1;
                    const auto needed = static_cast<std::size_t>(kFirstColored + domains * kBucketsOfDomain);
                    if (chains.size() < needed) chains.resize(needed);
                    load_bucket(static_cast<int>(bucket), last, pairs, links, blocks, chains[bucket]);
                }
                pairs.resize(links.size());
                blocks.resize(links.size());
                free.reserve(pairs.capacity());
            });
        if (in_.settle()) stores_.contacts.lanes.arrange();
    }

    template <class Chain>
    void load_bucket(int bucket, RepeatedParts& last, std::vector<PairBlock>& pairs,
                     std::vector<BlockLink>& links, std::vector<ContactBlock>& blocks, Chain& chain) {
        const std::size_t count = in_.count(kColoredBlockBytes.least / kLanes);
        const std::size_t length = (count + kLanes - 1) / kLanes;
        if (!in_.require(count > 0, "a colour of contacts is empty")) return;
        const std::size_t first = links.size();
        links.resize(first + length);
        // What else blocks held before is read over, or made anew by the next step, before anybody looks at
        // it.
        if (pairs.size() < first + length) pairs.resize(first + length);
        if (blocks.size() < first + length) blocks.resize(first + length);
        chain = {static_cast<int>(first), static_cast<int>(first + length) - 1};
        for (std::size_t i = 0; i < length; ++i) {
            const int block = static_cast<int>(first + i);
            const int used = std::min(kLanes, static_cast<int>(count - i * kLanes));
            PairBlock& pair_block = pairs[first + i];
            ContactBlock& contact_block = blocks[first + i];
            contact_block.turning = nullptr;
            links[first + i] = {bucket, used, i > 0 ? block - 1 : kNone, i + 1 < length ? block + 1 : kNone};
            if (!read_colored_block(in_, pair_block, contact_block, used, last)) return;
            if (!place_lanes(pair_block, used, bucket, block * kLanes)) return;
            for (int lane = 0; lane < used; ++lane) color(bucket, pair_block, lane, block * kLanes);
        }
    }

    // Marks the colour of the bodies, in which nobody else may be, and takes the material from the record.
    void color(int bucket, PairBlock& pairs, int at, int first_lane) {
        const auto lane = static_cast<std::size_t>(at);
        const int a = pairs.body_a[lane];
        const int b = pairs.body_b[lane];
        const BodyType type_a = stores_.bodies.slots[a].type;
        const BlockKind kind = kind_of(bucket);
        const std::uint32_t bit = 1u << color_of(bucket);
        std::uint32_t& colors_b = stores_.contacts.colors[static_cast<std::size_t>(b)];
        // What got another mass since the last step leaves its lanes at the start of the next.
        const auto may_be_moved = [&](int body) {
            return stores_.bodies.is_awake(body) &&
                   (stores_.bodies.slots[body].inverse_mass > 0 ||
                    stores_.masses.entries[static_cast<std::size_t>(body)].is_outdated);
        };
        bool fits = (colors_b & bit) == 0 && may_be_moved(b) &&
                    (type_a == BodyType::Static) == (kind == BlockKind::OneBody) &&
                    (type_a == BodyType::Kinematic) == (kind == BlockKind::Carried);
        colors_b |= bit;
        if (kind == BlockKind::TwoBodies) {
            std::uint32_t& colors_a = stores_.contacts.colors[static_cast<std::size_t>(a)];
            fits = fits && (colors_a & bit) == 0 && may_be_moved(a);
            colors_a |= bit;
        }
        in_.require(fits, "a body is moved twice in one colour of contacts, or by none that moves it");
        const bool at_home =
            domain_of(bucket) == kInterface ||
            domain_of(bucket) == domain_of(stores_.domains, a, b, kind == BlockKind::TwoBodies);
        in_.require(at_home, "a contact is of a domain that its bodies are not of");
        const ContactRecord& record = stores_.contacts.slots[pairs.contact[lane]];
        stores_.contacts.lanes.set_material(first_lane + at, record.friction, faint_restitution(record));
        set_lane_bit(pairs.faint, at, faint_restitution(record) > 0);
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

void save_domains(const Stores& stores, Writer& out) {
    const Domains& domains = stores.domains;
    out.value(domains.count);
    out.value(static_cast<std::uint8_t>(domains.by));
    out.value(domains.cuts);
    // Of bodies in no colour they mean nothing.
    out.count(domains.count > 0 ? domains.of_body.size() : 0);
    if (domains.count == 0) return;
    std::byte* at = out.room(domains.of_body.size());
    for (std::size_t body = 0; body < domains.of_body.size(); ++body)
        at = put(at, is_settled(stores, static_cast<int>(body)) ? domains.of_body[body] : std::uint8_t{0});
    out.end(at);
}

}  // namespace

void save_contact_lists(const Stores& stores, Writer& out) {
    constexpr std::size_t kShapesBytes = 2 * sizeof(int);
    const ContactStore& contacts = stores.contacts;
    save_domains(stores, out);
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
