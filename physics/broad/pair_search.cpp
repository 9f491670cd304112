// Walks of the trees by groups.
#include "broad/pair_search.h"

namespace cairn::physics {
namespace {

Aabb bounds_of(const BoxGroup& group, LaneMask lanes) {
    Aabb all;
    for (; lanes != 0; lanes &= lanes - 1) all = merged(all, group.box(std::countr_zero(lanes)));
    return all;
}

class GroupSearch {
  public:
    GroupSearch(const SearchedLayers& layers, std::span<const MovedGroup> moved, int index,
                std::vector<ItemPair>& pairs)
        : layers_(layers),
          moved_(moved),
          index_(index),
          own_(moved[index]),
          tree_(*layers[static_cast<std::size_t>(own_.layer)].tree),
          now_(tree_.level(0)[own_.group]),
          pairs_(pairs) {}

    void run() {
        const Aabb reach = bounds_of(now_, own_.lanes);
        for (const Layer layer : kLayers) {
            if (own_.layer == Layer::Static && layer == Layer::Static) continue;
            const SearchedLayer& searched = layers_[static_cast<std::size_t>(layer)];
            searched.tree->walk(
                [&](BoxTree::Node node, const BoxGroup& boxes) {
                    const bool is_done =
                        node.level == 0 && looks_by_itself(searched, node.index) == kAllLanes;
                    return is_done ? 0 : overlapping(boxes, reach);
                },
                [&](int group, LaneMask lanes) { compare(searched, group, lanes); });
        }
    }

  private:
    // The lanes of an earlier group that moved: they look for those of this one.
    [[nodiscard]] LaneMask looks_by_itself(const SearchedLayer& searched, int group) const {
        const int moved = searched.moved_index.empty() ? kNone : searched.moved_index[group];
        return moved != kNone && moved < index_ ? moved_[moved].lanes : 0;
    }

    // With the boxes of another group, or of this one.
    void compare(const SearchedLayer& searched, int group, LaneMask lanes) {
        const int moved = searched.moved_index.empty() ? kNone : searched.moved_index[group];
        const BoxGroup& now = searched.tree->level(0)[group];
        const BoxGroup& before = moved == kNone ? now : moved_[moved].before;
        lanes &= ~looks_by_itself(searched, group);
        for (; lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            LaneMask found = overlapping(now_, now.box(lane)) & own_.lanes;
            if (moved == index_) {
                const bool both_look = (own_.lanes >> lane & 1) != 0;
                found &= both_look ? (1u << lane) - 1 : ~(1u << lane);
            }
            if (found == 0) continue;
            found &= ~overlapping(own_.before, before.box(lane));
            for (; found != 0; found &= found - 1) {
                const int a = tree_.items()[kGroupSize * own_.group + std::countr_zero(found)];
                const int b = searched.tree->items()[kGroupSize * group + lane];
                pairs_.push_back({std::min(a, b), std::max(a, b)});
            }
        }
    }

    const SearchedLayers& layers_;
    std::span<const MovedGroup> moved_;
    const int index_;
    const MovedGroup& own_;
    const BoxTree& tree_;
    const BoxGroup& now_;
    std::vector<ItemPair>& pairs_;
};

}  // namespace

void find_pairs(const SearchedLayers& layers, std::span<const MovedGroup> moved, int first, int last,
                std::vector<ItemPair>& pairs) {
    for (int i = first; i < last; ++i) GroupSearch(layers, moved, i, pairs).run();
}

}  // namespace cairn::physics
