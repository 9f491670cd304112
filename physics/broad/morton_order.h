// Boxes in the order of a curve that keeps neighbours together, so that every eight in a row make a small
// group. The curve interleaves the bits of the cell in which a box's centre lies. Cells are about as large as
// the boxes, and their numbers wrap around every half million cells, so the world's size and runaways do not
// coarsen the order: they would if the cells divided the range of what there is. Invariant: equal boxes in
// equal order give equal orders on every machine. Source: Morton 1966; radix sort by counting, Knuth vol.
// 3, 5.2.5.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/radix_sort.h"
#include "broad/box_group.h"

namespace cairn::physics {

class MortonOrder {
  public:
    /// The boxes of the lanes that hold an item (not kNone), in their new order. Valid until the next call.
    std::span<const std::uint64_t> sort(std::span<const BoxGroup> groups, std::span<const int> items);

    /// The place (8 * group + lane) that an element of the result names.
    static int place(std::uint64_t key) { return static_cast<int>(key & ((1u << kPlaceBits) - 1)); }

  private:
    // A key is the number on the curve above the place, so keys are distinct and compare by one operation.
    static constexpr int kPlaceBits = 26;

    void make_keys(std::span<const BoxGroup> groups, std::span<const int> items);

    std::vector<std::uint64_t> keys_;
    RadixSort radix_;
};

}  // namespace cairn::physics
