// Blocks of joints of one sort, in buckets by domain (world/domains.h), colour and what may move. Invariant:
// lanes of a bucket are dense: all its blocks but the last are full. Within a colour no body that can be
// moved stands in two lanes, so lanes and blocks of a colour may be solved in any order with the same result.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/colored_runs.h"
#include "base/lane_order.h"
#include "base/motion.h"
#include "base/place.h"
#include "base/slot_map.h"
#include "base/task_pool.h"
#include "resolve/joints/joint_block.h"
#include "resolve/joints/joint_kernels.h"

namespace cairn::physics {

inline constexpr int kJointColors = 32;
inline constexpr int kJointBucketsOfDomain = kJointColors * kJointBlockKinds;
inline constexpr int kJointBuckets = (1 + kMostDomains) * kJointBucketsOfDomain;

constexpr int joint_bucket(int color, JointBlockKind kind, int domain = kInterface) {
    return domain * kJointBucketsOfDomain + color * kJointBlockKinds + static_cast<int>(kind);
}
constexpr int joint_color(int bucket) {
    return bucket / kJointBlockKinds % kJointColors;
}
constexpr int joint_domain(int bucket) {
    return bucket / kJointBucketsOfDomain;
}
constexpr JointBlockKind joint_block_kind(int bucket) {
    return static_cast<JointBlockKind>(bucket % kJointBlockKinds);
}

/// Blocks that a thread takes at once: enough to be worth a microsecond.
inline constexpr int kJointBlocksPerChunk = 24;

/// Where a joint is on its bodies.
struct AnchorLane {
    std::int32_t joint = kNone;
    std::int32_t body_a = kNone;
    std::int32_t body_b = kNone;
    Vec2 local_a;  // m, from the centre of mass
    Vec2 local_b;
    Rotation turn;    // of b relative to a, without the angles of the frames
    float turns = 0;  // whole ones, beyond the angle of `turn`
    bool breakable = false;
};

/// Blocks of one sort (pins, drives or wheels) and their buckets.
template <class Block>
class JointPool {
  public:
    int add(int bucket, const AnchorLane& lane);
    /// The result is the joint that took the freed lane, or kNone.
    int remove(int bucket, int lane);
    /// What a lane holds goes to another bucket.
    struct Moved {
        int lane;
        int filler;  // the joint that took the freed lane, or kNone
    };
    Moved move(int bucket, int lane, int to_bucket);

    [[nodiscard]] Block& block(int block) { return blocks_[static_cast<std::size_t>(block)]; }
    [[nodiscard]] const Block& block(int block) const { return blocks_[static_cast<std::size_t>(block)]; }
    [[nodiscard]] const AnchorBlock& anchors(int block) const {
        return anchors_[static_cast<std::size_t>(block)];
    }

    /// Puts the joints of each bucket in the order of the rows that `places` tells of their bodies. Calls
    /// tell(joint, lane) for each that changed its lane. Allocates nothing after order.make_room(size()).
    template <class Tell>
    void sort(std::span<const Place> places, LaneOrder& order, const Tell& tell);
    /// Of blocks, in use and free.
    [[nodiscard]] std::size_t size() const { return blocks_.size(); }

    /// Lists the blocks of all buckets, those of the domains first and then the interface. Adding and
    /// removing ends that.
    void arrange();
    /// As of the last `arrange`: the buckets that hold joints, and the blocks, bucket by bucket.
    [[nodiscard]] std::span<const int> buckets() const { return used_; }
    [[nodiscard]] std::span<const int> blocks() const { return order_; }
    [[nodiscard]] std::span<const int> blocks(int bucket) const {
        const Range& range = ranges_[static_cast<std::size_t>(bucket)];
        return std::span(order_).subspan(range.first, range.count);
    }

    /// Runs pass(blocks, kind) for all buckets: those of a domain on one thread, domains at once; then those
    /// of the interface, one after the other, each cut into parts for threads.
    template <class BlockPass>
    void for_each_bucket(TaskPool& tasks, const BlockPass& pass) const;
    /// Calls visit(block, anchors, lane) for each joint of the blocks of which these are the numbers.
    template <class Visit>
    void for_each_lane(std::span<const int> blocks, const Visit& visit) const;

    Block* data() { return blocks_.data(); }
    AnchorBlock* anchor_data() { return anchors_.data(); }

  private:
    friend struct StateAccess;

    struct Link {
        int used = 0;  // lanes
        int previous = kNone;
        int next = kNone;
    };
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
    int open_block(int bucket);
    bool find_order(int bucket, std::span<const Place> places, LaneOrder& order) const;
    void take_order(LaneOrder& order);

    std::vector<Block> blocks_;
    std::vector<AnchorBlock> anchors_;  // beside the blocks
    std::vector<Link> links_;           // beside the blocks
    std::vector<int> free_;
    std::vector<Chain> chains_;  // by bucket, of as many domains as there have been
    bool is_arranged_ = true;
    std::vector<int> order_;     // of blocks, bucket by bucket
    std::vector<Range> ranges_;  // beside the chains
    std::vector<int> used_;      // buckets
};

template <class Block>
template <class Tell>
void JointPool<Block>::sort(std::span<const Place> places, LaneOrder& order, const Tell& tell) {
    for (int bucket = 0; bucket < bucket_end(); ++bucket) {
        if (!find_order(bucket, places, order)) continue;
        take_order(order);
        order.for_each_changed([&](LaneAt at) {
            tell(anchors_[static_cast<std::size_t>(at.block)].joint[static_cast<std::size_t>(at.lane)],
                 at.block * kLanes + at.lane);
        });
    }
}

template <class Block>
template <class BlockPass>
void JointPool<Block>::for_each_bucket(TaskPool& tasks, const BlockPass& pass) const {
    if (used_.empty()) return;
    const auto run_at = [&](int i) {
        const int bucket = used_[static_cast<std::size_t>(i)];
        return ColoredRun{joint_color(bucket), static_cast<int>(blocks(bucket).size()), joint_domain(bucket)};
    };
    for_colored_runs<kJointBucketsOfDomain>(static_cast<int>(used_.size()), run_at, kJointBlocksPerChunk,
                                            tasks, [&](int i, int first, int count) {
                                                const int bucket = used_[static_cast<std::size_t>(i)];
                                                pass(blocks(bucket).subspan(first, count),
                                                     joint_block_kind(bucket));
                                            });
}

template <class Block>
template <class Visit>
void JointPool<Block>::for_each_lane(std::span<const int> blocks, const Visit& visit) const {
    for (const int block : blocks) {
        const AnchorBlock& anchors = anchors_[static_cast<std::size_t>(block)];
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            if (anchors.joint[lane] != kNone) visit(block, anchors, lane);
        }
    }
}

}  // namespace cairn::physics
