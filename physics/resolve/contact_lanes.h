// Where contacts live while they act: in SIMD lanes, eight to a block, blocks in buckets. A contact keeps its
// lane from step to step, so nothing is packed or unpacked.
// Invariant: lanes of a bucket are dense: all its blocks but the last are full. Within a colour no body that
// moves stands in two lanes, so lanes and blocks of a colour may be solved in any order with the same result.
// Source: first-fit edge colouring, kept up as contacts come and go.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/slot_map.h"
#include "collide/box_lanes.h"
#include "resolve/contact_block.h"
#include "resolve/contact_constraint.h"
#include "resolve/prepare_kernel.h"

namespace cairn::physics {

/// Which routine finds the manifold.
enum class PairGeometry : std::uint8_t { Boxes, General };

/// Which contacts the lanes of a block are, and what the narrow phase needs of them.
struct alignas(32) PairBlock {
    Lanes<std::int32_t> contact;
    Lanes<std::int32_t> body_a;
    Lanes<std::int32_t> body_b;
    Lanes<std::int32_t> shape_a;
    Lanes<std::int32_t> shape_b;
    BoxLanes boxes;  // of general shapes only the offsets are used: of the body's origin
    FeatureLanes features;
    std::uint8_t reports = 0;  // bits: restitution or events want the plain form of the contact too
    std::uint8_t remembers =
        0;  // bits: the contact had points in the last step, though it is not in a colour
};

/// One lane of a PairBlock, to be put in.
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
    bool remembers = false;
};

/// What a contact remembers from step to step.
struct ContactMemory {
    std::array<std::int32_t, 2> features{kNoFeature, kNoFeature};
    std::array<float, 2> impulse{};  // of one substep, N s
    float friction_impulse = 0;
};

inline constexpr int kNearBucket = 0;  // + PairGeometry: pairs without points
inline constexpr int kFirstColored = 2;
inline constexpr int kColors = 32;
inline constexpr int kBuckets = kFirstColored + kColors * kBlockKinds * 2;

constexpr int near_bucket(PairGeometry geometry) {
    return kNearBucket + static_cast<int>(geometry);
}
constexpr int colored_bucket(int color, BlockKind kind, PairGeometry geometry) {
    return kFirstColored + (color * kBlockKinds + static_cast<int>(kind)) * 2 + static_cast<int>(geometry);
}
constexpr bool is_colored(int bucket) {
    return bucket >= kFirstColored;
}
constexpr int color_of(int bucket) {
    return (bucket - kFirstColored) / (2 * kBlockKinds);
}
constexpr BlockKind kind_of(int bucket) {
    return static_cast<BlockKind>((bucket - kFirstColored) / 2 % kBlockKinds);
}
constexpr PairGeometry geometry_of(int bucket) {
    return static_cast<PairGeometry>(bucket % 2);
}

struct LaneBucket {
    std::vector<PairBlock> pairs;
    std::vector<ContactBlock> blocks;  // beside the pairs, in colours
    int lanes = 0;

    [[nodiscard]] int block_count() const { return (lanes + kLanes - 1) / kLanes; }
    /// How many lanes of a block are used.
    [[nodiscard]] int used(int block) const { return std::min(kLanes, lanes - block * kLanes); }
};

class ContactLanes {
  public:
    [[nodiscard]] LaneBucket& bucket(int i) { return buckets_[i]; }
    [[nodiscard]] const LaneBucket& bucket(int i) const { return buckets_[i]; }
    /// Buckets after the last that has ever held a lane are empty.
    [[nodiscard]] int end_bucket() const { return end_; }

    /// The lane of the contact in the bucket.
    int add(int bucket, const PairLane& lane);
    /// The contact that took the freed lane, or kNone.
    int remove(int bucket, int lane);

    /// Of lanes in colours.
    [[nodiscard]] ContactMemory memory(int bucket, int lane) const;
    void set_memory(int bucket, int lane, const ContactMemory& memory);
    void set_friction(int bucket, int lane, float friction);

    /// Leaves a lane out of the passes of this step: it points to the world and does nothing.
    void blank(int bucket, int lane);

    /// Makes the first guesses of a step and applies them.
    void warm_start(Motions& motions, float step_ratio, float friction_ratio);
    void solve(Motions& motions, const ContactRules& rules, float h_s, Pass pass);

  private:
    std::array<LaneBucket, kBuckets> buckets_;
    int end_ = 0;
};

}  // namespace cairn::physics
