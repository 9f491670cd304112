// The keys.
#include "broad/morton_order.h"

#include <algorithm>
#include <array>

#include "base/ample.h"
#include "base/assert.h"
#include "base/slot_map.h"

namespace cairn::physics {
namespace {

constexpr int kAxisBits = 19;

struct Grid {
    double x, y;  // where cell (0, 0) begins, m
    double cells_per_m;
};

// Cells of about the width of a typical box; with fewer, neighbours in a cell keep the order they had. The
// harmonic mean of the sizes is that of the small ones, of which there are many in a heap, and a few large
// ones do not count.
Grid make_grid(std::span<const BoxGroup> groups) {
    // One sum per lane: the order of the additions is the same for every width of vectors.
    std::array<double, kGroupSize> inverse_sizes{};
    std::array<double, kGroupSize> counts{};
    BoxGroup::Lanes low_x;
    BoxGroup::Lanes low_y;
    low_x.fill(Aabb{}.lower.x);
    low_y.fill(Aabb{}.lower.y);
    constexpr float kLeastSize_m = 1e-4f;
    for (const BoxGroup& g : groups) {
        for (int i = 0; i < kGroupSize; ++i) {
            const float size = (g.upper_x[i] - g.lower_x[i]) + (g.upper_y[i] - g.lower_y[i]);
            const bool taken = size >= 0;  // the empty box has size -infinity
            inverse_sizes[i] += taken ? 1 / static_cast<double>(std::max(size, kLeastSize_m)) : 0;
            counts[i] += taken ? 1 : 0;
            low_x[i] = std::min(low_x[i], g.lower_x[i]);
            low_y[i] = std::min(low_y[i], g.lower_y[i]);
        }
    }
    double inverse_size = 0;
    double count = 0;
    for (int i = 0; i < kGroupSize; ++i) {
        inverse_size += inverse_sizes[i];
        count += counts[i];
    }
    return {static_cast<double>(*std::min_element(low_x.begin(), low_x.end())),
            static_cast<double>(*std::min_element(low_y.begin(), low_y.end())),
            count > 0 ? 2 * inverse_size / count : 1};
}

std::uint64_t cell(double offset_m, double cells_per_m) {
    constexpr double kFar = 1e15;  // cells; beyond, all are in one
    const double cells = std::min(offset_m * cells_per_m, kFar);
    return static_cast<std::uint64_t>(cells >= 0 ? cells : 0) & ((1u << kAxisBits) - 1);
}

// Bit i goes to bit 2 i.
std::uint64_t spread(std::uint64_t bits) {
    bits = (bits | bits << 16) & 0x0000ffff0000ffffu;
    bits = (bits | bits << 8) & 0x00ff00ff00ff00ffu;
    bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0fu;
    bits = (bits | bits << 2) & 0x3333333333333333u;
    return (bits | bits << 1) & 0x5555555555555555u;
}

}  // namespace

std::span<const std::uint64_t> MortonOrder::sort(std::span<const BoxGroup> groups,
                                                 std::span<const int> items) {
    CAIRN_ASSERT(items.size() < (std::size_t{1} << kPlaceBits), "too many boxes for one tree");
    make_keys(groups, items);
    radix_.sort(keys_);
    return keys_;
}

void MortonOrder::make_keys(std::span<const BoxGroup> groups, std::span<const int> items) {
    const Grid grid = make_grid(groups);
    resize_amply(keys_, items.size());
    std::size_t taken = 0;
    for (std::size_t place = 0; place < items.size(); ++place) {
        if (items[place] == kNone) continue;
        const Aabb box = groups[place / kGroupSize].box(static_cast<int>(place % kGroupSize));
        const double x = 0.5 * (static_cast<double>(box.lower.x) + static_cast<double>(box.upper.x));
        const double y = 0.5 * (static_cast<double>(box.lower.y) + static_cast<double>(box.upper.y));
        const std::uint64_t on_curve =
            spread(cell(x - grid.x, grid.cells_per_m)) | spread(cell(y - grid.y, grid.cells_per_m)) << 1;
        keys_[taken++] = on_curve << kPlaceBits | place;
    }
    keys_.resize(taken);
}

}  // namespace cairn::physics
