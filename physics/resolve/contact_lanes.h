// Where contacts live while they are looked at or act. Those without points are records in a list for each
// geometry; those with points stand in SIMD lanes, eight to a block, blocks in buckets. A contact keeps its
// place from step to step, so nothing is packed or unpacked.
// Invariant: lanes of a bucket are dense: all its blocks but the last are full. Within a colour no body that
// moves stands in two lanes, so lanes and blocks of a colour may be solved in any order with the same result.
// Blocks of all colours come from one pool, which grows to the most contacts ever seen and then stays.
// Source: first-fit edge colouring, kept up as contacts come and go.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/colored_runs.h"
#include "base/lane_order.h"
#include "base/place.h"
#include "base/slot_map.h"
#include "collide/box_lanes.h"
#include "collide/place_lanes.h"
#include "resolve/contact_block.h"
#include "resolve/prepare_kernel.h"

namespace cairn::physics {

/// Which routine finds the manifold.
enum class PairGeometry : std::uint8_t {
    Boxes,
    Hulls,   ///< circles, capsules and polygons
    Chains,  ///< with a segment of a chain, or what never meets: one by one
};
inline constexpr int kPairGeometries = 3;

/// Which contacts the lanes of a block are, and what the narrow phase needs of them.
struct alignas(64) PairBlock {
    Lanes<std::int32_t> contact;
    Lanes<std::int32_t> body_a;
    Lanes<std::int32_t> body_b;
    Lanes<std::int32_t> shape_a;
    Lanes<std::int32_t> shape_b;
    BoxLanes boxes;  // of other shapes only the offsets are used: of the body's origin
    FeatureLanes features;
    LaneBits reports = 0;  // touching is told, which takes the plain form of the contact too
    LaneBits impacts = 0;  // impacts bounce or are told; they take that form as well
    LaneBits faint = 0;    // impacts bounce in their lanes
};

/// Where a block in a colour stands.
struct BlockLink {
    int bucket = kNone;
    int used = 0;  // lanes
    int previous = kNone;
    int next = kNone;
};

/// A pair of shapes, to be put into a lane of a PairBlock.
struct PairLane {
    std::int32_t contact = kNone;
    std::int32_t body_a = kNone;
    std::int32_t body_b = kNone;
    std::int32_t shape_a = kNone;
    std::int32_t shape_b = kNone;
    Vec2 half_a;
    Vec2 half_b;
    Vec2 offset_a;
    Vec2 offset_b;
    bool reports = false;
    bool impacts = false;
    bool faint = false;
};

/// What a contact remembers from step to step.
struct ContactMemory {
    std::array<std::int32_t, 2> features{kNoFeature, kNoFeature};
    std::array<float, 2> impulse{};  // of one substep, N s
    float friction_impulse = 0;
};

inline constexpr int kNearBucket = 0;  // + PairGeometry: pairs without points
inline constexpr int kFirstColored = kPairGeometries;
inline constexpr int kColors = 32;
inline constexpr int kBucketsOfDomain = kColors * kBlockKinds * kPairGeometries;
inline constexpr int kBuckets = kFirstColored + (1 + kMostDomains) * kBucketsOfDomain;

constexpr int near_bucket(PairGeometry geometry) {
    return kNearBucket + static_cast<int>(geometry);
}
constexpr int colored_bucket(int color, BlockKind kind, PairGeometry geometry, int domain = kInterface) {
    return kFirstColored + domain * kBucketsOfDomain +
           (color * kBlockKinds + static_cast<int>(kind)) * kPairGeometries + static_cast<int>(geometry);
}
constexpr bool is_colored(int bucket) {
    return bucket >= kFirstColored && bucket < kBuckets;
}
constexpr int color_of(int bucket) {
    return (bucket - kFirstColored) / (kPairGeometries * kBlockKinds) % kColors;
}
constexpr int domain_of(int bucket) {
    return (bucket - kFirstColored) / kBucketsOfDomain;
}
constexpr BlockKind kind_of(int bucket) {
    return static_cast<BlockKind>((bucket - kFirstColored) / kPairGeometries % kBlockKinds);
}
constexpr PairGeometry geometry_of(int bucket) {
    return static_cast<PairGeometry>(bucket % kPairGeometries);
}

class ContactLanes {
  public:
    /// Before so many contacts more come into colours: room for them, at once.
    void make_room(std::size_t contacts);
    /// Puts a contact into a colour. The result is its lane: the number of the block times kLanes, plus the
    /// place in it.
    int add(int bucket, const PairLane& lane);
    /// The next lane of the near bucket, for one without points; empty, and to be filled where it stands: put
    /// together elsewhere and copied it would wait for its own parts.
    int open_near(PairGeometry geometry);
    /// The contact that took the freed lane, or kNone.
    int remove(int bucket, int lane);
    /// Asks for what taking the lane out will read and write.
    void ask_for(int bucket, int lane) const;
    /// What a lane holds goes to another bucket in a colour.
    struct Moved {
        int lane;
        int filler;  // the contact that took the freed lane, or kNone
    };
    Moved move(int bucket, int lane, int to_bucket);

    /// Puts the contacts of each bucket in a colour in the order of the rows that `places` tells of their
    /// bodies. Calls tell(contact, lane) for each that changed its lane. Allocates nothing after `make_room`,
    /// until a bucket opens a block.
    template <class Tell>
    void sort(std::span<const Place> places, LaneOrder& order, const Tell& tell);
    void make_room(LaneOrder& order) const { order.make_room(pairs_.size()); }

    /// Lanes of near pairs are numbered on their own, from 0 in each of their buckets. As many stand here as
    /// fill whole blocks of eight; those behind the last pair are empty.
    [[nodiscard]] std::vector<NearPair>& near_pairs(PairGeometry geometry) { return near_[index(geometry)]; }
    [[nodiscard]] const std::vector<NearPair>& near_pairs(PairGeometry geometry) const {
        return near_[index(geometry)];
    }
    [[nodiscard]] int near_count(PairGeometry geometry) const { return near_count_[index(geometry)]; }
    /// Where of many near pairs most went at once, as where a scene begins, gives back the memory that they
    /// took. `before` is how many there were. Once: what comes again is needed again, and a step that has
    /// warmed up allocates nothing.
    void shrink_near(PairGeometry geometry, int before);

    [[nodiscard]] PairBlock& pairs(int block) { return pairs_[block]; }
    [[nodiscard]] const PairBlock& pairs(int block) const { return pairs_[block]; }
    [[nodiscard]] ContactBlock& block(int block) { return blocks_[block]; }
    [[nodiscard]] const ContactBlock& block(int block) const { return blocks_[block]; }

    /// Of a block; null as long as no contact bounces in its lane.
    [[nodiscard]] ImpactLanes* impacts(int block) { return impacts_.empty() ? nullptr : &impacts_[block]; }
    [[nodiscard]] const ImpactLanes* impacts(int block) const {
        return impacts_.empty() ? nullptr : &impacts_[block];
    }

    /// Of a bucket in colours; kNone when it is empty. BlockLink::next leads on.
    [[nodiscard]] int first_block(int bucket) const {
        return bucket < bucket_end() ? chains_[static_cast<std::size_t>(bucket)].first : kNone;
    }
    /// Lists the blocks of all buckets in colours, for the stages of a step: those of the domains first, and
    /// then the interface. Adding and removing ends that.
    void arrange();
    /// Another one whenever a contact in a colour came, went or changed its lane.
    [[nodiscard]] std::uint64_t version() const { return version_; }
    /// Blocks are numbered below this, those without contacts too.
    [[nodiscard]] int pool_size() const { return static_cast<int>(pairs_.size()); }
    /// The pool does not grow until there are more: what stands beside it takes as much room at once.
    [[nodiscard]] std::size_t pool_room() const { return pairs_.capacity(); }
    /// As of the last `arrange`: the buckets that hold contacts, and the blocks, bucket by bucket.
    [[nodiscard]] std::span<const int> buckets() const { return used_; }
    [[nodiscard]] std::span<const int> blocks() const { return order_; }
    [[nodiscard]] std::span<const int> blocks(int bucket) const {
        const Range& range = ranges_[static_cast<std::size_t>(bucket)];
        return std::span(order_).subspan(range.first, range.count);
    }
    /// The same blocks as they stand in memory, for stages that look at each by itself: that is twice as fast
    /// where they are more than the cache holds. A snapshot does not keep this order, so nothing may depend
    /// on it.
    [[nodiscard]] std::span<const int> blocks_in_memory() const { return in_memory_; }
    [[nodiscard]] const BlockLink& link(int block) const { return links_[block]; }

    /// Of lanes in colours.
    [[nodiscard]] ContactMemory memory(int lane) const;
    void set_memory(int lane, const ContactMemory& memory);
    /// `restitution` is that of impacts which bounce in their lanes, 0 for all others.
    void set_material(int lane, float friction, float restitution);

    /// Before contacts turn in their lanes: room for what that takes, of all blocks.
    void make_room_for_turns();
    /// In this step the bodies of the lane turn far; bows are those of TurnLanes. Several threads may tell so
    /// of lanes of different blocks.
    void turn(int block, int lane, float bow_a_m, float bow_b_m);

    /// Leaves a lane out of the passes of this step: it keeps its bodies, so that nobody else writes them
    /// meanwhile, and does nothing to them.
    void blank(int lane);

  private:
    friend struct StateAccess;

    struct Chain {
        int first = kNone;
        int last = kNone;
    };
    // Among the blocks in their order.
    struct Range {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };

    // Buckets from here on hold nothing, and have never yet.
    [[nodiscard]] int bucket_end() const { return static_cast<int>(chains_.size()); }
    void arrange_domain(int domain);
    static std::size_t index(PairGeometry geometry) { return static_cast<std::size_t>(geometry); }
    int remove_near(PairGeometry geometry, int lane);
    int open_lane(int bucket);
    int open_block(int bucket);
    void make_room_for_impacts();
    void move_turn(int block, int lane, int from_block, int from_lane);
    void close_block(int bucket);
    bool find_order(int bucket, std::span<const Place> places, LaneOrder& order) const;
    void take_order(LaneOrder& order);

    std::array<std::vector<NearPair>, kPairGeometries> near_;
    std::array<int, kPairGeometries> near_count_{};
    std::array<bool, kPairGeometries> near_shrank_{};
    std::vector<PairBlock> pairs_;
    std::vector<BlockLink> links_;      // beside the pairs
    std::vector<ContactBlock> blocks_;  // beside the pairs
    std::vector<ImpactLanes> impacts_;  // the same; empty until a contact bounces in its lane
    std::vector<TurnLanes> turns_;      // the same, as blocks point to them; empty until a body turns far
    std::vector<int> free_;
    std::vector<Chain> chains_;  // by bucket, of as many domains as there have been
    std::uint64_t version_ = 0;
    bool is_arranged_ = true;
    std::vector<int> order_;      // of blocks, bucket by bucket
    std::vector<int> in_memory_;  // the same, ascending
    std::vector<Range> ranges_;   // beside the chains
    std::vector<int> used_;       // buckets
};

template <class Tell>
void ContactLanes::sort(std::span<const Place> places, LaneOrder& order, const Tell& tell) {
    for (int bucket = kFirstColored; bucket < bucket_end(); ++bucket) {
        if (first_block(bucket) == kNone || !find_order(bucket, places, order)) continue;
        take_order(order);
        ++version_;
        order.for_each_changed(
            [&](LaneAt at) { tell(pairs_[at.block].contact[at.lane], at.block * kLanes + at.lane); });
    }
}

}  // namespace cairn::physics
