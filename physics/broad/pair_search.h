// The search for pairs of boxes that overlap now and did not before.
// One walk of the trees serves a whole group of eight boxes: a node is entered when it overlaps the union of
// those that moved, and only at the bottom are boxes compared one with eight. Of two boxes that moved, the
// one in the earlier group (by layer, then place) looks for the other, so each pair is found once. Source:
// the traversal by groups of Wald et al. 2008 ("packets"), applied to a tree against itself.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "broad/box_tree.h"

namespace cairn::physics {

/// The layers that boxes stand in. Static ones never pair with each other.
enum class Layer : std::uint8_t { Static, Asleep, Awake };
inline constexpr std::array kLayers{Layer::Static, Layer::Asleep, Layer::Awake};

struct ItemPair {
    int a;  // the smaller item
    int b;
    bool may_be_known = false;  ///< to the caller already; such a pair is rare
};

/// A group in which something moved.
struct MovedGroup {
    Layer layer;
    int group;
    LaneMask lanes;   // that moved
    BoxGroup before;  // the boxes as of the last search; of a new box: empty
};

/// What a search looks at. Nothing in it changes while searches run.
struct SearchedLayer {
    const BoxTree* tree = nullptr;
    /// By group of the tree, the index of its MovedGroup, or kNone; empty when nothing in the layer moved.
    std::span<const int> moved_index;
};
using SearchedLayers = std::array<SearchedLayer, kLayers.size()>;

/// Appends the new pairs that the groups [first, last) of `moved` find.
void find_pairs(const SearchedLayers& layers, std::span<const MovedGroup> moved, int first, int last,
                std::vector<ItemPair>& pairs);

}  // namespace cairn::physics
