// Upkeep of the blocks of joints.
#include "resolve/joints/joint_pool.h"

#include <cstring>

namespace cairn::physics {
namespace {

// Blocks are rows of eight numbers of four bytes each, and nothing else.
constexpr std::size_t kRowBytes = sizeof(Lanes<float>);
static_assert(sizeof(PinBlock) % kRowBytes == 0 && sizeof(DriveBlock) % kRowBytes == 0 &&
              sizeof(WheelBlock) % kRowBytes == 0);

template <class Block>
void copy_lane(Block& to, std::size_t to_lane, const Block& from, std::size_t from_lane) {
    auto* target = reinterpret_cast<std::byte*>(&to) + to_lane * sizeof(float);
    const auto* source = reinterpret_cast<const std::byte*>(&from) + from_lane * sizeof(float);
    for (std::size_t row = 0; row < sizeof(Block); row += kRowBytes) {
        std::memcpy(target + row, source + row, sizeof(float));
    }
}

// An unused lane is of the world's row, and all its numbers are 0.
template <class Block>
void clear_lane(Block& block, std::size_t lane) {
    const Block nothing{};
    copy_lane(block, lane, nothing, 0);
}

void write_anchor(AnchorBlock& to, std::size_t lane, const AnchorLane& from) {
    to.joint[lane] = from.joint;
    to.body_a[lane] = from.body_a;
    to.body_b[lane] = from.body_b;
    to.local_ax[lane] = from.local_a.x;
    to.local_ay[lane] = from.local_a.y;
    to.local_bx[lane] = from.local_b.x;
    to.local_by[lane] = from.local_b.y;
    to.cosine[lane] = from.turn.c;
    to.sine[lane] = from.turn.s;
    to.turns[lane] = from.turns;
    to.breakable =
        static_cast<std::uint8_t>((to.breakable & ~(1 << lane)) | (from.breakable ? 1 : 0) << lane);
}

AnchorLane read_anchor(const AnchorBlock& from, std::size_t lane) {
    return {from.joint[lane],
            from.body_a[lane],
            from.body_b[lane],
            {from.local_ax[lane], from.local_ay[lane]},
            {from.local_bx[lane], from.local_by[lane]},
            {from.cosine[lane], from.sine[lane]},
            from.turns[lane],
            (from.breakable >> lane & 1) != 0};
}

std::size_t block_of(int lane) {
    return static_cast<std::size_t>(lane / kLanes);
}
std::size_t place_in(int lane) {
    return static_cast<std::size_t>(lane % kLanes);
}

}  // namespace

template <class Block>
int JointPool<Block>::add(int bucket, const AnchorLane& lane) {
    if (bucket >= bucket_end())
        chains_.resize(static_cast<std::size_t>((joint_domain(bucket) + 1) * kJointBucketsOfDomain));
    int block = chains_[static_cast<std::size_t>(bucket)].last;
    if (block == kNone || links_[static_cast<std::size_t>(block)].used == kLanes) block = open_block(bucket);
    const auto i = static_cast<std::size_t>(block);
    const int at = links_[i].used++;
    write_anchor(anchors_[i], static_cast<std::size_t>(at), lane);
    return block * kLanes + at;
}

template <class Block>
int JointPool<Block>::remove(int bucket, int lane) {
    Chain& chain = chains_[static_cast<std::size_t>(bucket)];
    const auto last_block = static_cast<std::size_t>(chain.last);
    const int last = --links_[last_block].used;
    const auto last_at = static_cast<std::size_t>(last);
    const AnchorLane moved = read_anchor(anchors_[last_block], last_at);
    copy_lane(blocks_[block_of(lane)], place_in(lane), blocks_[last_block], last_at);
    write_anchor(anchors_[block_of(lane)], place_in(lane), moved);
    clear_lane(blocks_[last_block], last_at);
    write_anchor(anchors_[last_block], last_at, AnchorLane{});
    const bool is_last = chain.last * kLanes + last == lane;
    if (last == 0) {
        free_.push_back(chain.last);
        chain.last = links_[last_block].previous;
        (chain.last == kNone ? chain.first : links_[static_cast<std::size_t>(chain.last)].next) = kNone;
        is_arranged_ = false;
    }
    return is_last ? kNone : moved.joint;
}

template <class Block>
typename JointPool<Block>::Moved JointPool<Block>::move(int bucket, int lane, int to_bucket) {
    const int to = add(to_bucket, read_anchor(anchors_[block_of(lane)], place_in(lane)));
    copy_lane(blocks_[block_of(to)], place_in(to), blocks_[block_of(lane)], place_in(lane));
    return {to, remove(bucket, lane)};
}

template <class Block>
int JointPool<Block>::open_block(int bucket) {
    int block = static_cast<int>(blocks_.size());
    if (free_.empty()) {
        blocks_.emplace_back();
        anchors_.emplace_back();
        links_.emplace_back();
        free_.reserve(blocks_.capacity());
        order_.reserve(blocks_.capacity());
        for (std::size_t lane = 0; lane < kLanes; ++lane) write_anchor(anchors_.back(), lane, AnchorLane{});
    } else {
        block = free_.back();
        free_.pop_back();
    }
    Chain& chain = chains_[static_cast<std::size_t>(bucket)];
    links_[static_cast<std::size_t>(block)] = {0, chain.last, kNone};
    (chain.last == kNone ? chain.first : links_[static_cast<std::size_t>(chain.last)].next) = block;
    chain.last = block;
    is_arranged_ = false;
    return block;
}

// False where they are in order already.
template <class Block>
bool JointPool<Block>::find_order(int bucket, std::span<const Place> places, LaneOrder& order) const {
    const auto row = [&](int body) { return places[static_cast<std::size_t>(body)].row; };
    order.clear();
    for (int block = chains_[static_cast<std::size_t>(bucket)].first; block != kNone;) {
        const auto i = static_cast<std::size_t>(block);
        order.add_block(block);
        for (std::size_t lane = 0; lane < static_cast<std::size_t>(links_[i].used); ++lane) {
            const int row_b = row(anchors_[i].body_b[lane]);
            const bool anchored = joint_block_kind(bucket) == JointBlockKind::Anchored;
            order.add_lane(row_b + (anchored ? row_b : row(anchors_[i].body_a[lane])));
        }
        block = links_[i].next;
    }
    return order.sort();
}

template <class Block>
void JointPool<Block>::take_order(LaneOrder& order) {
    Block kept{};
    AnchorLane kept_anchor;
    const auto copy = [&](LaneAt to, const Block& from, int lane, const AnchorLane& anchor) {
        const auto block = static_cast<std::size_t>(to.block);
        copy_lane(blocks_[block], static_cast<std::size_t>(to.lane), from, static_cast<std::size_t>(lane));
        write_anchor(anchors_[block], static_cast<std::size_t>(to.lane), anchor);
    };
    const auto anchor_at = [&](LaneAt at) {
        return read_anchor(anchors_[static_cast<std::size_t>(at.block)], static_cast<std::size_t>(at.lane));
    };
    order.apply(
        [&](LaneAt from) {
            copy_lane(kept, 0, block(from.block), static_cast<std::size_t>(from.lane));
            kept_anchor = anchor_at(from);
        },
        [&](LaneAt to, LaneAt from) { copy(to, block(from.block), from.lane, anchor_at(from)); },
        [&](LaneAt to) { copy(to, kept, 0, kept_anchor); });
}

template <class Block>
void JointPool<Block>::arrange() {
    if (is_arranged_) return;
    is_arranged_ = true;
    order_.clear();
    used_.clear();
    used_.reserve(chains_.size());
    ranges_.assign(chains_.size(), {});
    const int domains = bucket_end() / kJointBucketsOfDomain;
    for (int domain = 1; domain < domains; ++domain) arrange_domain(domain);
    if (domains > 0) arrange_domain(kInterface);
}

template <class Block>
void JointPool<Block>::arrange_domain(int domain) {
    const int first = joint_bucket(0, JointBlockKind{}, domain);
    for (int bucket = first; bucket < first + kJointBucketsOfDomain; ++bucket) {
        const auto i = static_cast<std::size_t>(bucket);
        if (chains_[i].first == kNone) continue;
        used_.push_back(bucket);
        ranges_[i].first = static_cast<std::uint32_t>(order_.size());
        for (int block = chains_[i].first; block != kNone;
             block = links_[static_cast<std::size_t>(block)].next)
            order_.push_back(block);
        ranges_[i].count = static_cast<std::uint32_t>(order_.size()) - ranges_[i].first;
    }
}

template class JointPool<PinBlock>;
template class JointPool<DriveBlock>;
template class JointPool<WheelBlock>;

}  // namespace cairn::physics
