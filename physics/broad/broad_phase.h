// Finds pairs of boxes that have come to overlap, by asking only about those that moved.
// Invariant: items of the fixed layer never pair with each other; every overlapping pair of which one box was
// added or moved since the last call is reported once, in an order that depends on the items alone.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "broad/aabb_tree.h"

namespace cairn::physics {

enum class Layer : std::uint8_t { Fixed, Moving };

class BroadPhase {
  public:
    /// `item` is the caller's number for the box; the result is its proxy in the layer.
    int add(Layer layer, const Aabb& box, int item);
    void remove(Layer layer, int proxy);
    void move(Layer layer, int proxy, const Aabb& box);
    /// Asks for the pairs of an unmoved box again, say because a filter changed.
    void touch(Layer layer, int proxy);

    [[nodiscard]] const AabbTree& tree(Layer layer) const { return trees_[index(layer)]; }

    /// Pairs (smaller item, larger item), sorted. Valid until the next call.
    const std::vector<std::pair<int, int>>& find_new_pairs();

  private:
    static std::size_t index(Layer layer) { return static_cast<std::size_t>(layer); }

    struct Moved {
        Layer layer;
        int proxy;
    };

    std::array<AabbTree, 2> trees_;
    std::array<std::vector<std::uint8_t>, 2> is_moved_;  // by proxy
    std::vector<Moved> moved_;
    std::vector<std::pair<int, int>> pairs_;
};

}  // namespace cairn::physics
