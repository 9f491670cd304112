// Insertion, removal and upkeep of the tree.
#include "broad/box_tree.h"

#include "base/ample.h"
#include "base/assert.h"

namespace cairn::physics {
namespace {

// Below this many places, holes are too few to be worth a rebuild.
constexpr int kFewPlaces = 64;

int groups_for(int count) {
    return (count + kGroupSize - 1) / kGroupSize;
}

}  // namespace

void BoxTree::insert(int item, const Aabb& box, OrderScratch& scratch) {
    CAIRN_ASSERT(!holds(item), "an item was added to a tree twice");
    cover_amply(places_, static_cast<std::size_t>(item) + 1, kNone);
    if (end_ % kGroupSize == 0) append_group();
    const int place = end_++;
    places_[item] = place;
    items_[place] = item;
    levels_[0][place / kGroupSize].set_box(place % kGroupSize, box);
    enlarge_ancestors(place, box);
    ++live_;
    ++wear_.disorder;
    // The largest node that is full now.
    int full = kGroupSize;
    while (end_ % (full * kGroupSize) == 0) full *= kGroupSize;
    if (full > kGroupSize) sort_groups((end_ - full) / kGroupSize, end_ / kGroupSize, scratch);
}

void BoxTree::remove(int item, OrderScratch& scratch) {
    CAIRN_ASSERT(holds(item), "an item was removed that is not in the tree");
    const int place = places_[item];
    places_[item] = kNone;
    items_[place] = kNone;
    levels_[0][place / kGroupSize].set_box(place % kGroupSize, Aabb{});
    --live_;
    ++wear_.disorder;
    if (live_ == 0) {
        clear();
    } else if (end_ > kFewPlaces && live_ < end_ / 2) {
        rebuild(scratch);
    }
}

void BoxTree::move(int item, const Aabb& box) {
    const int place = places_[item];
    levels_[0][place / kGroupSize].set_box(place % kGroupSize, box);
    if (enlarge_ancestors(place, box)) ++wear_.disorder;
}

void BoxTree::rebuild(OrderScratch& scratch) {
    if (live_ == 0) return;
    sort_groups(0, static_cast<int>(levels_[0].size()), scratch);
    // Free lanes are at the end now.
    end_ = live_;
    int groups = groups_for(end_);
    items_.resize(kGroupSize * groups);
    level_count_ = 0;
    for (auto& level : levels_) {
        level.resize(groups);
        if (groups > 0) ++level_count_;
        groups = groups > 1 ? groups_for(groups) : 0;
    }
    const float girth = girth_m();
    wear_ = {0, girth, girth};
}

void BoxTree::refit() {
    refit(0, static_cast<int>(levels_[0].size()));
    wear_.girth_m = girth_m();
}

float BoxTree::girth_m() const {
    if (level_count_ < 2) return 0;
    float sum = 0;
    for (const BoxGroup& groups : levels_[1]) {
        for (int lane = 0; lane < kGroupSize; ++lane) sum += std::max(half_perimeter(groups.box(lane)), 0.0f);
    }
    return sum;
}

void BoxTree::clear() {
    for (auto& level : levels_) level.clear();
    level_count_ = 0;
    items_.clear();
    end_ = 0;
    wear_ = {};
}

// One more group at the bottom, and the nodes above it that are not there yet.
void BoxTree::append_group() {
    cover_amply(items_, items_.size() + kGroupSize, kNone);
    push_amply(levels_[0], {});
    level_count_ = std::max(level_count_, 1);
    for (int k = 1; levels_[k - 1].size() > 1; ++k) {
        CAIRN_ASSERT(k < kMaxLevels, "too many boxes for one tree");
        if (static_cast<int>(levels_[k].size()) == groups_for(static_cast<int>(levels_[k - 1].size()))) break;
        push_amply(levels_[k], {});
        if (k < level_count_) continue;
        // A new root: what was the root is its first child.
        levels_[k][0].set_box(0, bounds(levels_[k - 1][0]));
        level_count_ = k + 1;
    }
}

// Whether the group at the bottom grew.
bool BoxTree::enlarge_ancestors(int place, const Aabb& box) {
    int child = place / kGroupSize;
    for (int k = 1; k < level_count_; ++k) {
        BoxGroup& node = levels_[k][child / kGroupSize];
        const Aabb old = node.box(child % kGroupSize);
        if (contains(old, box)) return k > 1;
        node.set_box(child % kGroupSize, merged(old, box));
        child /= kGroupSize;
    }
    return level_count_ > 1;
}

void BoxTree::sort_groups(int first, int last, OrderScratch& scratch) {
    const auto groups = std::span(levels_[0]).subspan(first, last - first);
    const auto items = std::span(items_).subspan(kGroupSize * first, kGroupSize * (last - first));
    const std::span<const std::uint64_t> order = scratch.order.sort(groups, items);
    assign_amply(scratch.groups, groups.size(), BoxGroup{});
    assign_amply(scratch.items, items.size(), kNone);
    for (std::size_t to = 0; to < order.size(); ++to) {
        const int from = MortonOrder::place(order[to]);
        const int item = items[from];
        scratch.groups[to / kGroupSize].set_box(to % kGroupSize,
                                                groups[from / kGroupSize].box(from % kGroupSize));
        scratch.items[to] = item;
        places_[item] = kGroupSize * first + static_cast<int>(to);
    }
    std::copy(scratch.groups.begin(), scratch.groups.end(), groups.begin());
    std::copy(scratch.items.begin(), scratch.items.end(), items.begin());
    ordered_count_ += static_cast<std::int64_t>(order.size());
    refit(first, last);
}

// Makes the ancestors of these groups just large enough.
void BoxTree::refit(int first, int last) {
    for (int k = 1; k < level_count_; ++k) {
        for (int child = first; child < last; ++child) {
            levels_[k][child / kGroupSize].set_box(child % kGroupSize, bounds(levels_[k - 1][child]));
        }
        first /= kGroupSize;
        last = groups_for(last);
    }
}

bool BoxTree::is_valid() const {
    int taken = 0;
    for (int place = 0; place < static_cast<int>(items_.size()); ++place) {
        const int item = items_[place];
        if (item == kNone) continue;
        if (place >= end_ || !holds(item) || places_[item] != place) return false;
        ++taken;
    }
    if (taken != live_ || (level_count_ == 0) != (live_ == 0)) return false;
    for (int k = 1; k < level_count_; ++k) {
        for (int child = 0; child < static_cast<int>(levels_[k - 1].size()); ++child) {
            const Aabb of_parent = levels_[k][child / kGroupSize].box(child % kGroupSize);
            if (!contains(of_parent, bounds(levels_[k - 1][child]))) return false;
        }
    }
    return level_count_ == 0 || levels_[level_count_ - 1].size() == 1;
}

}  // namespace cairn::physics
