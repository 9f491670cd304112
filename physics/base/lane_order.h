// Puts what stands in lanes of blocks in another order, in place.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/ample.h"
#include "base/lanes.h"

namespace cairn::physics {

/// A lane of a block.
struct LaneAt {
    int block;
    int lane;
};

/// The order of the lanes of some blocks, which are full but for the last. Its memory serves for others too.
class LaneOrder {
  public:
    /// For so many blocks at most.
    void make_room(std::size_t blocks) {
        reserve_amply(blocks_, blocks);
        reserve_amply(keys_, kLanes * blocks);
    }

    void clear() {
        blocks_.clear();
        keys_.clear();
    }
    void add_block(int block) { blocks_.push_back(block); }
    /// The next lane of the blocks, which belongs at this place among all others.
    void add_lane(int place) {
        keys_.push_back(static_cast<std::uint64_t>(1 + place) << kLowerBits | keys_.size());
    }

    /// False where they are in order already. Lanes of the same place stay in theirs.
    bool sort() {
        if (std::is_sorted(keys_.begin(), keys_.end())) return false;
        std::sort(keys_.begin(), keys_.end());
        return true;
    }

    /// Moves them, along the cycles of the permutation: `keep(LaneAt)` takes one lane out, copy(to, from)
    /// fills a gap, and put_back(to) the last one.
    template <class Keep, class Copy, class PutBack>
    void apply(const Keep& keep, const Copy& copy, const PutBack& put_back) {
        for (std::size_t first = 0; first < keys_.size(); ++first) {
            // A key whose upper half is gone has been dealt with.
            if (keys_[first] <= kLower || (keys_[first] & kLower) == first) continue;
            keep(at(first));
            std::size_t gap = first;
            for (;;) {
                const std::size_t from = keys_[gap] &= kLower;
                if (from == first) break;
                copy(at(gap), at(from));
                gap = from;
            }
            put_back(at(gap));
        }
    }

    /// After that: calls tell(LaneAt) for all that hold something else than before.
    template <class Tell>
    void for_each_changed(const Tell& tell) const {
        for (std::size_t i = 0; i < keys_.size(); ++i) {
            if ((keys_[i] & kLower) != i) tell(at(i));
        }
    }

  private:
    static constexpr int kLowerBits = 32;
    static constexpr std::uint64_t kLower = 0xffffffffu;

    [[nodiscard]] LaneAt at(std::size_t i) const {
        return {blocks_[i / kLanes], static_cast<int>(i % kLanes)};
    }

    std::vector<int> blocks_;
    std::vector<std::uint64_t> keys_;  // by lane: its place, and below it the lane that goes there
};

}  // namespace cairn::physics
