// The search for pairs of boxes that overlap now and did not before. Those that keep apart on their ways
// (broad/box_way.h) count as if they did not overlap, and are told besides.
// One walk of the trees serves a whole group of eight boxes: a node is entered when it overlaps the union of
// those that moved, and only at the bottom are boxes compared one with eight. Of two boxes that moved, the
// one in the earlier group (by layer, then place) looks for the other, so each pair is found once. Items of
// the same kin are no pair. Source:
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

/// Of the boxes of a group.
struct alignas(32) GroupWays {
    BoxGroup::Lanes x{};
    BoxGroup::Lanes y{};

    [[nodiscard]] Vec2 way(int lane) const { return {x[lane], y[lane]}; }
    void set_way(int lane, Vec2 way) {
        x[lane] = way.x;
        y[lane] = way.y;
    }
};

/// A group in which something moved.
struct MovedGroup {
    Layer layer{};
    int group = kNone;
    LaneMask lanes = 0;       // that moved
    BoxGroup before;          // the boxes as of the last search; of a new box: empty
    int ways = kNone;         // index of its GroupWays, if there are any; only what moved may have one
    int ways_before = kNone;  // the same, as of the last search
};

/// Pairs of an item with items of a group.
struct PairsBeside {
    int group;  ///< among those in which something moved
    int item;
    LaneMask lanes;
};

/// What a search finds.
struct FoundPairs {
    std::vector<ItemPair>& fresh;      ///< new pairs
    std::vector<PairsBeside>& beside;  ///< pairs of which one moved, that overlap now, but keep apart
};

/// What a search looks at. Nothing in it changes while searches run.
struct SearchedLayer {
    const BoxTree* tree = nullptr;
    /// By group of the tree, the index of its MovedGroup, or kNone; empty when nothing in the layer moved.
    std::span<const int> moved_index;
};
using SearchedLayers = std::array<SearchedLayer, kLayers.size()>;

/// The groups in which something moved, of all layers.
struct MovedGroups {
    std::span<const MovedGroup> groups;
    std::span<const GroupWays> ways;
    std::span<const int> kin;  // by item, 0: of none; empty where nobody is of any
};

/// Appends what the groups [first, last) of `moved` find.
void find_pairs(const SearchedLayers& layers, const MovedGroups& moved, int first, int last,
                const FoundPairs& found);

}  // namespace cairn::physics
