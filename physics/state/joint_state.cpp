// Joints as bytes: records with their definitions; the lists of those that act; and the lanes, of which all
// numbers are kept but the rows of the bodies, which each step finds anew. Which structures are solved
// directly follows from the joints, and is found again by the next step.
#include <algorithm>

#include "state/sections.h"
#include "state/slots.h"
#include "world/domains.h"
#include "world/joint_rules.h"
#include "world/joints.h"

namespace cairn::physics {
namespace {

constexpr std::size_t kRowsOfBodies = 2;  // the first two rows of a block

template <class Block>
constexpr std::size_t kKeptBytes = sizeof(Block) - kRowsOfBodies * sizeof(Lanes<float>);

template <class Block>
std::span<std::byte> kept_bytes(Block& block) {
    return {reinterpret_cast<std::byte*>(&block) + sizeof(Block) - kKeptBytes<Block>, kKeptBytes<Block>};
}
template <class Block>
std::span<const std::byte> kept_bytes(const Block& block) {
    return kept_bytes(const_cast<Block&>(block));
}

void load_definition(Reader& in, JointDef& def) {
    std::uint8_t kind = 0;
    in.value(kind);
    if (!in.require(kind < std::variant_size_v<JointDef>, "a joint is of no kind that there is")) return;
    const auto load_as = [&]<std::size_t I>(std::integral_constant<std::size_t, I>) {
        if (kind != I) return;
        std::variant_alternative_t<I, JointDef> held;
        in.value(held);
        def = held;
    };
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (load_as(std::integral_constant<std::size_t, I>{}), ...);
    }
    (std::make_index_sequence<std::variant_size_v<JointDef>>{});
}

void load_record(Reader& in, JointRecord& record) {
    fields(record, [&](JointDef& def, auto&... rest) {
        load_definition(in, def);
        (in.value(rest), ...);
    });
}

// A gear is found over the bodies of its joints, and goes with them.
bool fits(const Stores& stores, const JointRecord& record, const GearJointDef& gear) {
    for (const JointId id : {gear.joint_1, gear.joint_2}) {
        const int joint = stores.joints.slots.find(id);
        if (joint == kNone) return false;
        const JointRecord& geared = stores.joints.slots[joint];
        const JointKind kind = kind_of(geared);
        if (kind != JointKind::Revolute && kind != JointKind::Prismatic) return false;
        const auto is_of = [&](int body) { return geared.body_a == body || geared.body_b == body; };
        if (!is_of(record.body_a) && !is_of(record.body_b)) return false;
    }
    return true;
}

template <class Def>
bool fits(const Stores& stores, const JointRecord& record, const Def& def) {
    return stores.bodies.slots.find(def.body_a) == record.body_a &&
           stores.bodies.slots.find(def.body_b) == record.body_b;
}

template <auto kPlace, class Fits>
void load_list(Reader& in, JointStore& joints, ActiveList<kPlace>& active_list, const Fits& fits) {
    StateAccess::list(active_list, [&](std::vector<int>& list) {
        in.list(list);
        for (std::size_t i = 0; i < list.size() && in.ok(); ++i) {
            const bool may_stand = names(joints.slots, list[i]) && joints.slots[list[i]].*kPlace == kNone &&
                                   fits(joints.slots[list[i]]);
            if (!in.require(may_stand, "a joint is listed that does not act, or twice")) return;
            joints.slots[list[i]].*kPlace = static_cast<int>(i);
        }
    });
}

template <class Block>
void save_pool(const JointPool<Block>& pool, Writer& out) {
    StateAccess::pool(pool, [&](const auto& blocks, const auto& anchors, const auto& links, const auto&,
                                const auto& chains) {
        const auto used = std::count_if(chains.begin(), chains.end(),
                                        [](const auto& chain) { return chain.first != kNone; });
        out.count(static_cast<std::size_t>(used));
        for (std::size_t bucket = 0; bucket < chains.size(); ++bucket) {
            if (chains[bucket].first == kNone) continue;
            std::size_t joints = 0;
            const auto next = [&](int block) { return links[static_cast<std::size_t>(block)].next; };
            for (int block = chains[bucket].first; block != kNone; block = next(block))
                joints += static_cast<std::size_t>(links[static_cast<std::size_t>(block)].used);
            out.count(bucket);
            out.count(joints);
            for (int block = chains[bucket].first; block != kNone; block = next(block)) {
                std::byte* const at = out.room(kKeptBytes<Block>);
                const auto kept = kept_bytes(blocks[static_cast<std::size_t>(block)]);
                std::memcpy(at, kept.data(), kept.size());
                out.end(at + kept.size());
                out.value(anchors[static_cast<std::size_t>(block)]);
            }
        }
    });
}

class Seating {
  public:
    Seating(Reader& in, Stores& stores) : in_(in), stores_(stores) {}

    template <class Block>
    void load_pool(JointPool<Block>& pool, JointLaneKind kind) {
        StateAccess::pool(pool, [&](auto& blocks, auto& anchors, auto& links, auto& free, auto& chains) {
            blocks.clear();
            anchors.clear();
            links.clear();
            free.clear();
            chains.clear();
            const std::size_t buckets = in_.count(2 * sizeof(std::uint32_t));
            for (std::size_t i = 0; i < buckets && in_.ok(); ++i) {
                std::uint32_t bucket = 0;
                in_.value(bucket);
                const std::size_t joints = in_.count(kKeptBytes<Block> / kLanes);
                if (!in_.require(bucket < kJointBuckets && joints > 0 &&
                                     joint_domain(static_cast<int>(bucket)) <= stores_.domains.count,
                                 "a colour of joints is none, or empty"))
                    return;
                const auto needed = static_cast<std::size_t>((joint_domain(static_cast<int>(bucket)) + 1) *
                                                             kJointBucketsOfDomain);
                if (chains.size() < needed) chains.resize(needed);
                if (!in_.require(chains[bucket].first == kNone, "a colour of joints is there twice")) return;
                const std::size_t first = blocks.size();
                const std::size_t length = (joints + kLanes - 1) / kLanes;
                blocks.resize(first + length);
                anchors.resize(first + length);
                links.resize(first + length);
                chains[bucket] = {static_cast<int>(first), static_cast<int>(first + length) - 1};
                for (std::size_t k = 0; k < length && in_.ok(); ++k) {
                    const int block = static_cast<int>(first + k);
                    const int used = std::min(kLanes, static_cast<int>(joints - k * kLanes));
                    links[first + k] = {used, k > 0 ? block - 1 : kNone, k + 1 < length ? block + 1 : kNone};
                    load_block(blocks[first + k], anchors[first + k]);
                    if (in_.ok())
                        seat(anchors[first + k], used, block, static_cast<std::int16_t>(bucket), kind);
                }
            }
            free.reserve(blocks.capacity());
        });
        StateAccess::disarrange(pool);
        in_.settle();
    }

  private:
    template <class Block>
    void load_block(Block& block, AnchorBlock& anchors) {
        block = {};
        if (const std::byte* at = in_.take(kKeptBytes<Block>)) {
            std::array<float, kKeptBytes<Block> / sizeof(float)> numbers;
            std::memcpy(numbers.data(), at, sizeof numbers);
            in_.reading.bad |= has_nan(std::span<const float>(numbers));
            std::memcpy(kept_bytes(block).data(), at, kKeptBytes<Block>);
        }
        in_.value(anchors);
    }

    void seat(const AnchorBlock& anchors, int used, int block, std::int16_t bucket, JointLaneKind kind) {
        const std::uint32_t bit = 1u << joint_color(bucket);
        const bool both = joint_block_kind(bucket) == JointBlockKind::TwoBodies;
        in_.require(anchors.breakable < 1u << used, "a joint can break in a lane that is not used");
        for (int i = 0; i < kLanes; ++i) {
            const auto lane = static_cast<std::size_t>(i);
            const int joint = anchors.joint[lane];
            if (i >= used) {
                in_.require(joint == kNone && anchors.body_a[lane] == kNone && anchors.body_b[lane] == kNone,
                            "a joint is in a lane that is not used");
                continue;
            }
            const bool may_sit =
                names(stores_.joints.slots, joint) && is_free(joint, kind, anchors, lane, bit, both);
            if (!in_.require(may_sit, "a joint is in a lane that cannot hold it")) return;
            JointRecord& record = stores_.joints.slots[joint];
            const bool at_home =
                joint_domain(bucket) == kInterface ||
                joint_domain(bucket) == domain_of(stores_.domains, record.body_a, record.body_b, both);
            if (!in_.require(at_home, "a joint is of a domain that its bodies are not of")) return;
            record.seat = {block * kLanes + i, bucket, kind};
            stores_.joints.colors[static_cast<std::size_t>(record.body_b)] |= bit;
            if (both) stores_.joints.colors[static_cast<std::size_t>(record.body_a)] |= bit;
        }
    }

    [[nodiscard]] bool is_free(int joint, JointLaneKind kind, const AnchorBlock& anchors, std::size_t lane,
                               std::uint32_t bit, bool both) const {
        const JointRecord& record = stores_.joints.slots[joint];
        const JointKind fitting = kind == JointLaneKind::Wheel ? JointKind::Wheel : JointKind::Revolute;
        // What got another mass since the last step leaves its lanes at the start of the next.
        const auto may_be_moved = [&](int body, bool moved) {
            return (stores_.bodies.slots[body].inverse_mass > 0) == moved ||
                   stores_.masses.entries[static_cast<std::size_t>(body)].is_outdated;
        };
        const auto is_taken = [&](int body) {
            return (stores_.joints.colors[static_cast<std::size_t>(body)] & bit) != 0;
        };
        return record.seat.lane == kNone && record.active_index != kNone && record.swept_index == kNone &&
               kind_of(record) == fitting && anchors.body_a[lane] == record.body_a &&
               anchors.body_b[lane] == record.body_b && may_be_moved(record.body_b, true) &&
               !is_taken(record.body_b) && may_be_moved(record.body_a, both) &&
               !(both && is_taken(record.body_a));
    }

    Reader& in_;
    Stores& stores_;
};

}  // namespace

void save_joints(const JointStore& joints, Writer& out) {
    save_slots(joints.slots, out);
    std::byte* at = out.room(static_cast<std::size_t>(joints.slots.size()) * packed_size<JointRecord>());
    for_each_alive(joints.slots, [&](int, const JointRecord& record) { at = put(at, record); });
    out.end(at);
}

void load_joints(Reader& in, JointStore& joints) {
    in.begin("joints");
    load_slots(in, joints.slots);
    in.require_built_in(Feature::Joints, joints.slots.size() > 0);
    if (!in.ok()) return;
    for_each_alive(joints.slots, [&](int, JointRecord& record) {
        if (!in.ok()) return;
        record = {};
        load_record(in, record);
    });
    in.settle();
}

void save_joint_lists(const JointStore& joints, Writer& out) {
    StateAccess::list(joints.active, [&](const std::vector<int>& list) { out.list(list); });
    StateAccess::list(joints.swept, [&](const std::vector<int>& list) { out.list(list); });
    StateAccess::joints(joints.lanes, [&](const auto& pins, const auto& drives, const auto& wheels, float h_s,
                                          float most_swept_hz, bool springs_changed, bool has_crowded_springs,
                                          bool has_loads, float dt_s) {
        save_pool(pins, out);
        save_pool(drives, out);
        save_pool(wheels, out);
        out.value(h_s);
        out.value(most_swept_hz);
        out.value(springs_changed);
        out.value(has_crowded_springs);
        out.value(has_loads);
        out.value(dt_s);
    });
}

void load_joint_lists(Reader& in, Stores& stores) {
    in.begin("lists of joints");
    for_each_alive(stores.joints.slots, [&](int, const JointRecord& record) {
        const bool sound = std::visit([&](const auto& def) { return fits(stores, record, def); }, record.def);
        in.require(sound, "a joint is between other bodies than its definition says");
    });
    if (!in.ok()) return;
    JointStore& joints = stores.joints;
    joints.version = 0;
    joints.colors.assign(static_cast<std::size_t>(stores.bodies.slots.end_index()), 0);
    load_list(in, joints, joints.active,
              [&](const JointRecord& record) { return acts(stores.bodies, record); });
    load_list(in, joints, joints.swept,
              [](const JointRecord& record) { return record.active_index != kNone; });
    if (!in.ok()) return;
    StateAccess::joints(joints.lanes,
                        [&](auto& pins, auto& drives, auto& wheels, float& h_s, float& most_swept_hz,
                            bool& springs_changed, bool& has_crowded_springs, bool& has_loads, float& dt_s) {
                            Seating seating(in, stores);
                            seating.load_pool(pins, JointLaneKind::Pin);
                            if (in.ok()) seating.load_pool(drives, JointLaneKind::Drive);
                            if (in.ok()) seating.load_pool(wheels, JointLaneKind::Wheel);
                            in.value(h_s);
                            in.value(most_swept_hz);
                            in.value(springs_changed);
                            in.value(has_crowded_springs);
                            in.value(has_loads);
                            in.value(dt_s);
                        });
    for (const int joint : joints.active) {
        const JointRecord& record = joints.slots[joint];
        in.require((record.seat.lane != kNone) != (record.swept_index != kNone),
                   "a joint that acts is in no list, or in two");
    }
    in.settle();
}

}  // namespace cairn::physics
