// Cells by clipping at the bisectors to other sites.
#include "collide/voronoi.h"

#include <algorithm>
#include <utility>

namespace cairn::physics {
namespace {

// The bisector of two sites, with the first on its left.
DirectedLine bisector(RingPoint a, RingPoint b) {
    const RingPoint between = b - a;
    const double distance = length(between);
    return {0.5 * (a + b), (1 / distance) * RingPoint{-between.y, between.x}};
}

double farthest_corner(const Ring& cell, RingPoint site) {
    double farthest = 0;
    for (const RingPoint p : cell) farthest = std::max(farthest, length(p - site));
    return farthest;
}

}  // namespace

std::vector<Ring> voronoi_cells(std::span<const RingPoint> sites, const Ring& bounds) {
    std::vector<Ring> cells(sites.size());
    std::vector<std::pair<double, std::size_t>> others;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        others.clear();
        for (std::size_t k = 0; k < sites.size(); ++k) {
            if (k != i) others.emplace_back(length(sites[k] - sites[i]), k);
        }
        std::sort(others.begin(), others.end());
        Ring cell = bounds;
        for (const auto& [distance, k] : others) {
            if (cell.empty() || distance > 2 * farthest_corner(cell, sites[i])) break;
            if (distance == 0) {
                if (k < i) cell.clear();
                continue;
            }
            // Both cells must see the same line to the last bit.
            cell = left_part(cell,
                             i < k ? bisector(sites[i], sites[k]) : bisector(sites[k], sites[i]).reversed());
        }
        cells[i] = std::move(cell);
    }
    return cells;
}

}  // namespace cairn::physics
