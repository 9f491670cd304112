// Where revolute joints live while they act: in SIMD lanes, eight to a block, blocks in buckets by domain
// (world/domains.h) and colour. A joint keeps its lane from step to step; plain pins, which are many, stand
// apart from those with drives, which take three times the memory. Invariant: lanes of a bucket are dense:
// all its blocks but the last are full. Within a colour no body that can be moved stands in two lanes, so
// lanes and blocks of a colour may be solved in any order with the same result.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/colored_runs.h"
#include "base/lane_order.h"
#include "base/motion.h"
#include "base/place.h"
#include "base/prefetch.h"
#include "base/slot_map.h"
#include "base/task_pool.h"
#include "resolve/joints/joint_block.h"
#include "resolve/joints/joint_constraint.h"
#include "resolve/joints/joint_kernels.h"
#include "resolve/joints/torn_joints.h"

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

/// The lane of a joint: the number of its block times kLanes, plus the place in it.
struct JointSeat {
    int lane = kNone;  // kNone: it has none
    std::int16_t bucket = 0;
    bool drives = false;  // which pool
};

/// What a joint remembers from step to step, and what it did in the last one.
struct JointMemory {
    JointImpulses impulse{};
    double angle_rad = 0;
    Vec2 reaction_force;
    float reaction_torque = 0;
};

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

/// What acts on the angle of a joint, in the units of a substep. The angle counts without those of the
/// frames.
struct DriveLane {
    Softness softness;
    float spring_frequency_rad_s = 0;
    float square = 0;   // (w h)^2
    float damping = 0;  // 2 z w h
    ExactSpring spring{0, 0, 0, true};
    float spring_target = 0;
    float motor_speed = 0;
    float motor_limit = 0;
    float lower = -kNoLimit_rad;
    float upper = kNoLimit_rad;
};

/// Blocks of one sort and their buckets.
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

class JointLanes {
  public:
    JointSeat add_pin(int bucket, const AnchorLane& lane);
    JointSeat add_drive(int bucket, const AnchorLane& lane, const DriveLane& drive);
    void set_drive(int lane, const DriveLane& drive);
    /// The result is the joint that took the freed lane, or kNone.
    int remove(const JointSeat& seat);
    /// The joint of the seat goes to another bucket, and the seat with it. The result is as of `remove`.
    int move(JointSeat& seat, int to_bucket);

    /// Impulses and reaction. The angle is without those of the frames.
    [[nodiscard]] JointMemory memory(const JointSeat& seat) const;
    void set_impulses(const JointSeat& seat, const JointImpulses& impulse);

    /// As of the last `arrange`: blocks in use.
    [[nodiscard]] std::size_t block_count() const { return pins_.blocks().size() + drives_.blocks().size(); }
    void make_room(LaneOrder& order) const { order.make_room(std::max(pins_.size(), drives_.size())); }
    /// As JointPool::sort, of pins and drives.
    template <class Tell>
    void sort(std::span<const Place> places, LaneOrder& order, const Tell& tell) {
        pins_.sort(places, order, tell);
        drives_.sort(places, order, tell);
    }

    [[nodiscard]] bool empty() const { return pins_.blocks().empty() && drives_.blocks().empty(); }
    /// Calls visit(joint, lane) for each joint with a drive.
    template <class Visit>
    void for_each_drive(Visit&& visit) const;
    /// Calls visit(anchors, pins, kind) for each block, and asks for the rows of pins ahead.
    template <class Visit>
    void for_each_block(Visit&& visit) const;
    /// Calls visit(bucket, anchors, lane) for each joint.
    template <class Visit>
    void for_each_joint(Visit&& visit) const;
    /// Calls visit(joint) for each joint that can break.
    template <class Visit>
    void for_each_breakable(Visit&& visit) const;

    /// What a plain pin would bear if everything stood still, N; 0: unknown.
    [[nodiscard]] Vec2 load(const JointSeat& seat) const;
    void set_load(const JointSeat& seat, Vec2 force_n);
    [[nodiscard]] const PinBlock& pin_block(int block) const { return pins_.block(block); }

    /// Of the substeps for which the drives were made, s.
    float h_s = 0;

    // The stages of a step, in their order.

    void arrange();
    /// Where all anchors are. Marks who carries joints without being moved by them. The result is whether
    /// some joint may be torn.
    bool place(const std::vector<Place>& places, Motions& motions, float impulse_ratio, float dt_s,
               TaskPool& tasks);
    /// Makes pins that have loads soft about them. Costs nothing before the first load is set.
    void take_off_loads(const Motions& motions, const PinLoads& loads, TaskPool& tasks);
    /// Hides torn joints from the passes, and appends how they were. Those softer than
    /// `rigid_rate` are let alone.
    void hide_tears(float rigid_rate, std::vector<TornJoint>& torn);
    /// Whether springs came, went or changed since `settle_springs` was last told of none that are swept.
    [[nodiscard]] bool springs_changed() const { return springs_changed_; }
    /// As prepare_springs, in two halves: what each row has of springs, and what comes of it.
    void add_spring_loads(const Motions& motions, std::vector<SpringLoad>& loads, TaskPool& tasks) const;
    void settle_springs(const std::vector<SpringLoad>& loads, bool others, TaskPool& tasks);
    void note_spring_speeds(const Motions& motions, TaskPool& tasks);
    void warm_start(Motions& motions, TaskPool& tasks);
    [[nodiscard]] bool has_crowded_springs() const { return has_crowded_springs_; }
    /// As the function of the same name in joint_solver.h.
    void sweep_crowded_springs(Motions& motions, bool back);
    void solve(Motions& motions, const JointPassTime& time, TaskPool& tasks);
    void relax(Motions& motions, const JointPassTime& time, TaskPool& tasks);

  private:
    friend struct StateAccess;

    JointPool<PinBlock> pins_;
    JointPool<DriveBlock> drives_;
    bool springs_changed_ = false;
    bool has_crowded_springs_ = false;
    bool has_loads_ = false;  // some pin may have one
    float dt_s_ = 0;
};

template <class Visit>
void JointLanes::for_each_drive(Visit&& visit) const {
    for (const int block : drives_.blocks()) {
        const AnchorBlock& anchors = drives_.anchors(block);
        for (int lane = 0; lane < kLanes; ++lane) {
            const int joint = anchors.joint[static_cast<std::size_t>(lane)];
            if (joint != kNone) visit(joint, block * kLanes + lane);
        }
    }
}

template <class Visit>
void JointLanes::for_each_joint(Visit&& visit) const {
    const auto visit_all = [&](const auto& pool) {
        for (const int bucket : pool.buckets()) {
            for (const int block : pool.blocks(bucket)) {
                const AnchorBlock& anchors = pool.anchors(block);
                for (std::size_t lane = 0; lane < kLanes; ++lane) {
                    if (anchors.joint[lane] != kNone) visit(bucket, anchors, lane);
                }
            }
        }
    };
    visit_all(pins_);
    visit_all(drives_);
}

template <class Visit>
void JointLanes::for_each_breakable(Visit&& visit) const {
    const auto visit_all = [&](const auto& pool) {
        for (const int block : pool.blocks()) {
            const AnchorBlock& anchors = pool.anchors(block);
            for (unsigned bits = anchors.breakable, lane = 0; bits != 0; bits >>= 1, ++lane) {
                if (bits & 1) visit(anchors.joint[lane]);
            }
        }
    };
    visit_all(pins_);
    visit_all(drives_);
}

template <class Visit>
void JointLanes::for_each_block(Visit&& visit) const {
    const auto visit_pool = [&](const auto& pool, const auto& pins_of) {
        for (const int bucket : pool.buckets()) {
            visit_asking_ahead(
                pool.blocks(bucket), kBlocksAhead,
                [&](int block) { prefetch(&pins_of(block), sizeof(PinBlock::a) + sizeof(PinBlock::b)); },
                [&](int block) { visit(pool.anchors(block), pins_of(block), joint_block_kind(bucket)); });
        }
    };
    visit_pool(pins_, [&](int block) -> const PinBlock& { return pins_.block(block); });
    visit_pool(drives_, [&](int block) -> const PinBlock& { return drives_.block(block).pin; });
}

}  // namespace cairn::physics
