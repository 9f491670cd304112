// Walks of the trees by groups. A box is compared with the eight of a group at once.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "broad/pair_search.cpp"
#include "broad/pair_search.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/simd_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

static_assert(kGroupSize == kLanes);

// The lanes whose boxes overlap the given one.
HWY_INLINE LaneMask overlapping_lanes(const BoxGroup& group, const Aabb& box) {
    const V lower_x = set(box.lower.x);
    const V lower_y = set(box.lower.y);
    const V upper_x = set(box.upper.x);
    const V upper_y = set(box.upper.y);
    LaneMask found = 0;
    for (int lane = 0; lane < kLanes; lane += kStep) {
        const M x =
            hn::And(hn::Le(load(group.lower_x, lane), upper_x), hn::Ge(load(group.upper_x, lane), lower_x));
        const M y =
            hn::And(hn::Le(load(group.lower_y, lane), upper_y), hn::Ge(load(group.upper_y, lane), lower_y));
        found |= bits_of(hn::And(x, y)) << lane;
    }
    return found;
}

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
            if (searched.tree->size() > 0) enter(searched, reach, searched.tree->level_count() - 1, 0);
        }
    }

  private:
    void enter(const SearchedLayer& searched, const Aabb& reach, int level, int node) {
        const std::span<const BoxGroup> groups = searched.tree->level(level);
        if (level == 0) {
            const LaneMask lanes = ~looks_by_itself(searched, node) & kAllLanes;
            if (lanes != 0) compare(searched, node, overlapping_lanes(groups[node], reach) & lanes);
            return;
        }
        for (LaneMask lanes = overlapping_lanes(groups[node], reach); lanes != 0; lanes &= lanes - 1)
            enter(searched, reach, level - 1, kGroupSize * node + std::countr_zero(lanes));
    }

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
        for (; lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            LaneMask found = overlapping_lanes(now_, now.box(lane)) & own_.lanes;
            if (moved == index_) {
                const bool both_look = (own_.lanes >> lane & 1) != 0;
                found &= both_look ? (1u << lane) - 1 : ~(1u << lane);
            }
            if (found == 0) continue;
            found &= ~overlapping_lanes(own_.before, before.box(lane));
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

void find_pairs(const SearchedLayers& layers, std::span<const MovedGroup> moved, int first, int last,
                std::vector<ItemPair>& pairs) {
    for (int i = first; i < last; ++i) GroupSearch(layers, moved, i, pairs).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(find_pairs);

void find_pairs(const SearchedLayers& layers, std::span<const MovedGroup> moved, int first, int last,
                std::vector<ItemPair>& pairs) {
    HWY_DYNAMIC_DISPATCH(find_pairs)(layers, moved, first, last, pairs);
}

}  // namespace cairn::physics
#endif
