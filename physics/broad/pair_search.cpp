// Walks of the trees by groups. A box is compared with the eight of a group at once.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "broad/pair_search.cpp"
#include "broad/pair_search.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <optional>

#include "base/ample.h"
#include "base/simd_rows-inl.h"
#include "broad/box_way-inl.h"
#include "broad/box_way.h"

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

// A group that moves, and where its boxes set out.
struct GroupOnWay {
    BoxGroup start;
    const GroupWays& ways;

    GroupOnWay(const BoxGroup& group, const GroupWays& of_group) : ways(of_group) {
        for (int lane = 0; lane < kLanes; lane += kStep) {
            const V way_x = load(ways.x, lane);
            const V way_y = load(ways.y, lane);
            store(start_lower(load(group.lower_x, lane), way_x), start.lower_x, lane);
            store(start_upper(load(group.upper_x, lane), way_x), start.upper_x, lane);
            store(start_lower(load(group.lower_y, lane), way_y), start.lower_y, lane);
            store(start_upper(load(group.upper_y, lane), way_y), start.upper_y, lane);
        }
    }

    // The lanes that keep apart from a box.
    [[nodiscard]] LaneMask lanes_apart(const Aabb& box, Vec2 way) const {
        const Aabb other = start_of(box, way);
        const V way_x = set(way.x);
        const V way_y = set(way.y);
        LaneMask apart = 0;
        for (int lane = 0; lane < kLanes; lane += kStep) {
            const M x = keep_apart_along(load(start.lower_x, lane), load(start.upper_x, lane),
                                         load(ways.x, lane), set(other.lower.x), set(other.upper.x), way_x);
            const M y = keep_apart_along(load(start.lower_y, lane), load(start.upper_y, lane),
                                         load(ways.y, lane), set(other.lower.y), set(other.upper.y), way_y);
            apart |= bits_of(hn::Or(x, y)) << lane;
        }
        return apart;
    }
};

Aabb bounds_of(const BoxGroup& group, LaneMask lanes) {
    Aabb all;
    for (; lanes != 0; lanes &= lanes - 1) all = merged(all, group.box(std::countr_zero(lanes)));
    return all;
}

class GroupSearch {
  public:
    GroupSearch(const SearchedLayers& layers, const MovedGroups& moved, int index, const FoundPairs& found)
        : layers_(layers),
          moved_(moved.groups),
          ways_(moved.ways),
          kin_(moved.kin),
          index_(index),
          own_(moved.groups[index]),
          tree_(*layers[static_cast<std::size_t>(own_.layer)].tree),
          now_(tree_.level(0)[own_.group]),
          found_(found) {
        if (!kin_.empty()) note_kin();
        if (ways_.empty()) return;
        on_way_.emplace(now_, ways_of(own_.ways));
        was_on_way_.emplace(own_.before, ways_of(own_.ways_before));
    }

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
        if (level == 0) return look_at(searched, reach, node);
        LaneMask lanes = overlapping_lanes(searched.tree->level(level)[node], reach);
        for (; lanes != 0; lanes &= lanes - 1) {
            const int child = kGroupSize * node + std::countr_zero(lanes);
            // Most nodes are groups at the bottom, and a call would cost as much as a look at one.
            if (level == 1) {
                look_at(searched, reach, child);
            } else {
                enter(searched, reach, level - 1, child);
            }
        }
    }

    HWY_INLINE void look_at(const SearchedLayer& searched, const Aabb& reach, int group) {
        const LaneMask lanes = ~looks_by_itself(searched, group) & kAllLanes;
        if (lanes == 0) return;
        compare(searched, group, overlapping_lanes(searched.tree->level(0)[group], reach) & lanes);
    }

    // The lanes of an earlier group that moved: they look for those of this one.
    [[nodiscard]] LaneMask looks_by_itself(const SearchedLayer& searched, int group) const {
        const int moved = searched.moved_index.empty() ? kNone : searched.moved_index[group];
        return moved != kNone && moved < index_ ? moved_[moved].lanes : 0;
    }

    // With the boxes of another group, or of this one.
    HWY_INLINE void compare(const SearchedLayer& searched, int group, LaneMask lanes) {
        const int moved = searched.moved_index.empty() ? kNone : searched.moved_index[group];
        const MovedGroup* const other = moved == kNone ? nullptr : &moved_[moved];
        const BoxGroup& now = searched.tree->level(0)[group];
        const BoxGroup& before = other == nullptr ? now : other->before;
        const int* const items = &searched.tree->items()[kGroupSize * group];
        const bool some_have_ways =
            !ways_.empty() && (has_ways(own_) || (other != nullptr && has_ways(*other)));
        for (; lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            LaneMask found = overlapping_lanes(now_, now.box(lane)) & own_.lanes;
            if (moved == index_) {
                const bool both_look = (own_.lanes >> lane & 1) != 0;
                found &= both_look ? (1u << lane) - 1 : ~(1u << lane);
            }
            if (found == 0) continue;
            if (some_have_ways) {
                found &= ~lanes_of_kin(items[lane]);
                if (found != 0) compare_ways(now, other, lane, items[lane], found);
            } else {
                found &= ~overlapping_lanes(own_.before, before.box(lane));
                if (found != 0) tell(found & ~lanes_of_kin(items[lane]), items[lane]);
            }
        }
    }

    void note_kin() {
        for (int lane = 0; lane < kLanes; ++lane) {
            const int item = tree_.items()[kGroupSize * own_.group + lane];
            own_kin_[lane] = item == kNone ? 0 : kin_[item];
        }
    }
    [[nodiscard]] HWY_INLINE LaneMask lanes_of_kin(int item) const {
        const int kin = kin_.empty() ? 0 : kin_[item];
        if (kin == 0) return 0;
        LaneMask alike = 0;
        for (int lane = 0; lane < kLanes; lane += kStep)
            alike |= bits_of(hn::RebindMask(D(), hn::Eq(load(own_kin_, lane), set_int(kin)))) << lane;
        return alike;
    }

    // A lane of another group, or of this one, with those that its box overlaps now.
    HWY_NOINLINE void compare_ways(const BoxGroup& group, const MovedGroup* other, int lane, int item,
                                   LaneMask found) {
        const Aabb now = group.box(lane);
        const LaneMask apart = found & on_way_->lanes_apart(now, way_of(other, &MovedGroup::ways, lane));
        if (apart != 0) push_amply(found_.beside, PairsBeside{index_, item, apart});
        const LaneMask meeting = found & ~apart;
        if (meeting == 0) return;
        const Aabb before = other == nullptr ? now : other->before.box(lane);
        const LaneMask known =
            overlapping_lanes(own_.before, before) &
            ~was_on_way_->lanes_apart(before, way_of(other, &MovedGroup::ways_before, lane));
        tell(meeting & ~known, item);
    }
    [[nodiscard]] static bool has_ways(const MovedGroup& group) {
        return group.ways != kNone || group.ways_before != kNone;
    }
    [[nodiscard]] const GroupWays& ways_of(int index) const {
        static constexpr GroupWays kAllStand;
        return index == kNone ? kAllStand : ways_[index];
    }
    [[nodiscard]] Vec2 way_of(const MovedGroup* group, int MovedGroup::*ways, int lane) const {
        return group == nullptr ? Vec2{} : ways_of(group->*ways).way(lane);
    }

    HWY_INLINE void tell(LaneMask lanes, int item) const {
        for (; lanes != 0; lanes &= lanes - 1) {
            const int own = tree_.items()[kGroupSize * own_.group + std::countr_zero(lanes)];
            push_amply(found_.fresh, ItemPair{std::min(own, item), std::max(own, item)});
        }
    }

    const SearchedLayers& layers_;
    std::span<const MovedGroup> moved_;
    std::span<const GroupWays> ways_;
    std::span<const int> kin_;
    const int index_;
    const MovedGroup& own_;
    const BoxTree& tree_;
    const BoxGroup& now_;
    const FoundPairs& found_;
    alignas(32) Lanes<std::int32_t> own_kin_;  // where some item is of any
    // Where some item has a way:
    std::optional<GroupOnWay> on_way_;
    std::optional<GroupOnWay> was_on_way_;
};

void find_pairs(const SearchedLayers& layers, const MovedGroups& moved, int first, int last,
                const FoundPairs& found) {
    for (int i = first; i < last; ++i) GroupSearch(layers, moved, i, found).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(find_pairs);

void find_pairs(const SearchedLayers& layers, const MovedGroups& moved, int first, int last,
                const FoundPairs& found) {
    HWY_DYNAMIC_DISPATCH(find_pairs)(layers, moved, first, last, found);
}

}  // namespace cairn::physics
#endif
