// A bounding-volume hierarchy of eight children a node, over boxes that come, go and move.
// Boxes stand in groups of eight, groups in nodes of eight, and so on up to one root; which node is whose
// child follows from the numbers alone, so a node is nothing but the eight boxes of its children. New boxes
// are appended; each time a node fills up, all that is below it is put in order anew, so each box is sorted
// once per level. A box that goes leaves an empty box behind; one that moves stays in its place and its
// ancestors grow, or all nodes are made anew where many moved. `rebuild` puts everything in order; what the
// tree then holds follows from the calls alone. Invariant: the boxes of a node enclose its children; each
// item has one place, and the place names the item. Source: wide trees for ray tracing, Dammertz et al. 2008;
// order along a curve, Lauterbach et al. 2009.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/prefetch.h"
#include "base/slot_map.h"
#include "broad/box_cast.h"
#include "broad/box_group.h"
#include "broad/morton_order.h"

namespace cairn::physics {

/// Memory for putting trees in order; several trees may share one.
struct OrderScratch {
    MortonOrder order;
    std::vector<BoxGroup> groups;
    std::vector<int> items;
};

/// How far the order of a tree is from what putting it in order anew would give.
struct TreeWear {
    int disorder = 0;  // boxes that came, went, or grew their group by `move` since then
    // m: half the perimeters of the groups at the bottom, which is what searching costs. As of the last
    // refit, and when they were put in order.
    float girth_m = 0;
    float sorted_girth_m = 0;
};

class BoxTree {
  public:
    static constexpr int kMaxLevels = 9;  // 8^9 boxes

    /// The item (a number that the caller keeps small) is not in the tree.
    void insert(int item, const Aabb& box, OrderScratch& scratch);
    void remove(int item, OrderScratch& scratch);
    void move(int item, const Aabb& box);
    /// The same for many at once: `shift` each, then `refit`, before anything is asked. Nodes are just large
    /// enough then.
    void shift(int item, const Aabb& box) {
        levels_[0][places_[item] / kGroupSize].set_box(places_[item] % kGroupSize, box);
    }
    void refit();
    /// Asks for the memory of a box that will be looked at or shifted soon.
    void ask_for(int item) const { prefetch(&levels_[0][places_[item] / kGroupSize], sizeof(BoxGroup)); }
    /// Puts all boxes in order and drops the places of those that went.
    void rebuild(OrderScratch& scratch);
    /// Whether so much came, went or moved that searching costs more than a rebuild.
    [[nodiscard]] bool is_worn() const {
        return wear_.disorder > live_ / 4 || wear_.girth_m > kWornGirth * wear_.sorted_girth_m;
    }

    [[nodiscard]] int size() const { return live_; }
    [[nodiscard]] bool holds(int item) const {
        return item < static_cast<int>(places_.size()) && places_[item] != kNone;
    }
    [[nodiscard]] Aabb box(int item) const {
        return levels_[0][places_[item] / kGroupSize].box(places_[item] % kGroupSize);
    }

    /// Calls visit(item) for each box that overlaps.
    template <class Visit>
    void query(const Aabb& box, Visit&& visit) const;

    /// Calls visit(item) for each box that the segment from origin to origin + translation meets, in no
    /// order.
    template <class Visit>
    void query_segment(Position origin, Vec2 translation, Visit&& visit) const;

    /// Calls visit(item) for each box that a box of the given half extents meets while it is moved from
    /// center to center + fraction * translation, the nearer ones first as far as the tree tells them apart;
    /// visit returns the fraction up to which the rest is still of interest.
    template <class Visit>
    void cast_box(Position center, Vec2 half_extents, Vec2 translation, float fraction, Visit&& visit) const;

    /// Of a group of boxes, and the level it is on (0: its lanes are items).
    struct Node {
        int level;
        int index;
    };

    /// Walks down from the root: lanes_of(node, boxes) tells which of a node's eight boxes to enter,
    /// visit(group, lanes) gets those of the groups at the bottom.
    template <class LanesOf, class Visit>
    void walk(LanesOf&& lanes_of, Visit&& visit) const;

    // For the search for pairs, which walks several trees at once.
    [[nodiscard]] int level_count() const { return level_count_; }
    [[nodiscard]] std::span<const BoxGroup> level(int k) const { return levels_[k]; }
    /// By place: eight items to a group, kNone in a free lane.
    [[nodiscard]] std::span<const int> items() const { return items_; }
    [[nodiscard]] int place(int item) const { return places_[item]; }

    /// How many boxes all sorting together has put in order. For tests of its cost.
    [[nodiscard]] std::int64_t ordered_count() const { return ordered_count_; }
    /// Checks the invariant of every node; for tests.
    [[nodiscard]] bool is_valid() const;

  private:
    friend struct StateAccess;

    // Of the girth: with 1.5 the time is the same.
    static constexpr float kWornGirth = 1.25f;

    // A walk holds at most seven siblings per level, and the eight children of the last.
    static constexpr int kMaxStack = (kGroupSize - 1) * kMaxLevels + 1;

    [[nodiscard]] Node root() const { return {level_count_ - 1, 0}; }
    void append_group();
    bool enlarge_ancestors(int place, const Aabb& box);
    void sort_groups(int first, int last, OrderScratch& scratch);
    void refit(int first, int last);
    [[nodiscard]] float girth_m() const;
    void clear();

    std::array<std::vector<BoxGroup>, kMaxLevels> levels_;
    int level_count_ = 0;
    std::vector<int> items_;   // by place
    std::vector<int> places_;  // by item
    int end_ = 0;              // one past the last place that was ever taken
    int live_ = 0;
    TreeWear wear_;
    std::int64_t ordered_count_ = 0;
};

template <class LanesOf, class Visit>
void BoxTree::walk(LanesOf&& lanes_of, Visit&& visit) const {
    if (live_ == 0) return;
    std::array<Node, kMaxStack> stack;
    int depth = 0;
    stack[depth++] = root();
    while (depth > 0) {
        const Node node = stack[--depth];
        LaneMask lanes = lanes_of(node, levels_[node.level][node.index]);
        if (node.level == 0) {
            if (lanes != 0) visit(node.index, lanes);
            continue;
        }
        // From the last to the first, so that the first is entered first.
        while (lanes != 0) {
            const int lane = std::bit_width(lanes) - 1;
            lanes ^= 1u << lane;
            stack[depth++] = {node.level - 1, kGroupSize * node.index + lane};
        }
    }
}

template <class Visit>
void BoxTree::query(const Aabb& box, Visit&& visit) const {
    // An infinite box would overlap the empty box too; everything there is overlaps the largest finite one.
    constexpr float kMost = std::numeric_limits<float>::max();
    const Aabb finite{{std::max(box.lower.x, -kMost), std::max(box.lower.y, -kMost)},
                      {std::min(box.upper.x, kMost), std::min(box.upper.y, kMost)}};
    walk([&](Node, const BoxGroup& boxes) { return overlapping(boxes, finite); },
         [&](int group, LaneMask lanes) {
             for (; lanes != 0; lanes &= lanes - 1)
                 visit(items_[kGroupSize * group + std::countr_zero(lanes)]);
         });
}

template <class Visit>
void BoxTree::query_segment(Position origin, Vec2 translation, Visit&& visit) const {
    const BoxCast cast(origin, {}, translation);
    const Aabb all = cast.bounds(1);
    const auto crossed = [&](const BoxGroup& boxes) {
        LaneMask found = 0;
        for (LaneMask lanes = overlapping(boxes, all); lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            if (cast.crosses_line(boxes.box(lane))) found |= 1u << lane;
        }
        return found;
    };
    walk([&](Node, const BoxGroup& boxes) { return crossed(boxes); },
         [&](int group, LaneMask lanes) {
             for (; lanes != 0; lanes &= lanes - 1)
                 visit(items_[kGroupSize * group + std::countr_zero(lanes)]);
         });
}

template <class Visit>
void BoxTree::cast_box(Position center, Vec2 half_extents, Vec2 translation, float fraction,
                       Visit&& visit) const {
    if (live_ == 0) return;
    struct Ahead {
        Node node;
        double enter;  // fraction at which the segment enters its box
    };
    const BoxCast cast(center, half_extents, translation);
    std::array<Ahead, kMaxStack> stack;
    int depth = 0;
    stack[depth++] = {root(), 0};
    Aabb reach = cast.bounds(fraction);
    while (depth > 0) {
        const Ahead ahead = stack[--depth];
        if (ahead.enter > static_cast<double>(fraction)) continue;
        const BoxGroup& group = levels_[ahead.node.level][ahead.node.index];
        // Children that the segment meets, sorted by where; the nearest ends on top of the stack.
        std::array<Ahead, kGroupSize> met;
        int met_count = 0;
        for (LaneMask lanes = overlapping(group, reach); lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            const double enter = cast.enter(group.box(lane));
            if (!(enter <= static_cast<double>(fraction))) continue;
            int at = met_count++;
            for (; at > 0 && met[at - 1].enter < enter; --at) met[at] = met[at - 1];
            met[at] = {{ahead.node.level - 1, kGroupSize * ahead.node.index + lane}, enter};
        }
        if (ahead.node.level > 0) {
            for (int i = 0; i < met_count; ++i) stack[depth++] = met[i];
            continue;
        }
        for (int i = met_count - 1; i >= 0; --i) {
            if (met[i].enter > static_cast<double>(fraction)) break;
            const float old_fraction = fraction;
            fraction = visit(items_[met[i].node.index]);
            if (fraction != old_fraction) reach = cast.bounds(fraction);
        }
    }
}

}  // namespace cairn::physics
