// Finds pairs of boxes that have come to overlap, by asking only about those that moved.
// Boxes stand in three trees: static, asleep, awake. A box that moves keeps the place it had when pairs were
// last looked for; a pair is new when the boxes overlap now and did not then, so nothing has to be looked up.
// Invariant: between searches every tree is fit to be asked. Static items never pair with each other, nor
// items of one kin; any other pair is reported by the first search that finds it overlapping, and again only
// after a search that did not, or when one of the two was touched. Pairs are reported in the order of their
// items: what the caller makes of them then stands in memory as its items do, and the shape of the trees
// shows nowhere.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/chunked_list.h"
#include "base/task_pool.h"
#include "broad/box_way.h"
#include "broad/pair_search.h"

namespace cairn::physics {

class BroadPhase {
  public:
    /// `item` is the caller's number for the box, small and not in use.
    void add(int item, Layer layer, const Aabb& box);
    void remove(int item);
    void move(int item, const Aabb& box);
    /// The same for many at once, all of them awake, by as many threads as there are: each calls `shift` for
    /// items of its own, and keeps what it says; then `end_shifts` is told all of that, in an order that does
    /// not depend on threads. Before it nothing may be asked.
    struct Shifted {
        bool is_first = false;  // of this item since the last search
        int more_ways = 0;  // 1: it has one now, as of `set_way`, and had none; -1: it is the other way round
    };
    Shifted shift(int item, const Aabb& box, Vec2 way = {});
    /// Before the first that has a way.
    void make_room_for_ways() {
        if (ways_.empty()) cover_ways();
    }
    /// Asks for what shifting the item will read.
    void ask_for_shift(int item) const {
        prefetch(&states_[item], sizeof(State));
        prefetch(&box_before_[item], sizeof(Aabb));
        trees_[index(Layer::Awake)].ask_for(item);
    }
    void end_shifts(const ChunkedList<int>& first_moves, int more_ways);
    /// What the box holds moves by so much (m) in the next step, within the box all along. Pairs that keep
    /// apart on their ways (broad/box_way.h) count as if their boxes did not overlap. The box has just been
    /// moved; it keeps the way until it is moved again, which must be before the next search but one. Only
    /// what is awake may have one.
    void set_way(int item, Vec2 way);
    /// Asks for all pairs of a box again, say because a filter changed.
    void touch(int item);
    /// Items of the same kin are never reported as a pair. 0, as of what was just added: it is of none. What
    /// was of the same kin before and is not any more has to be touched.
    void set_kin(int item, int kin);
    /// What falls asleep or wakes changes its layer and nothing else.
    void set_layer(int item, Layer layer);

    [[nodiscard]] Layer layer(int item) const { return states_[item].layer; }
    [[nodiscard]] Aabb box(int item) const { return tree(layer(item)).box(item); }
    [[nodiscard]] const BoxTree& tree(Layer layer) const { return trees_[index(layer)]; }
    [[nodiscard]] bool has_ways() const { return with_ways_ > 0; }
    [[nodiscard]] Vec2 way(int item) const { return has_ways() ? ways_[item] : Vec2{}; }
    /// By item; empty while none has any.
    [[nodiscard]] std::span<const Vec2> ways() const {
        return has_ways() ? std::span<const Vec2>(ways_) : std::span<const Vec2>();
    }

    /// All in one. The pairs are valid until the next call.
    const std::vector<ItemPair>& find_new_pairs(TaskPool& tasks);

    /// The same in parts, for threads: `start_search` gives the number of groups; `search` may run for
    /// disjoint ranges of them at once and appends to `found`; `end_search` takes the new pairs that all of
    /// them appended, in any order, and makes of it what `find_new_pairs` gives.
    int start_search(TaskPool& tasks);
    void search(int first_group, int last_group, const FoundPairs& found) const;
    void end_search(std::vector<ItemPair>& pairs);
    /// As of the last search, where some had ways: the items of each group in which something moved, by lane.
    using GroupItems = std::array<int, kGroupSize>;
    [[nodiscard]] std::span<const GroupItems> group_items() const { return group_items_; }

  private:
    friend struct StateAccess;

    static std::size_t index(Layer layer) { return static_cast<std::size_t>(layer); }

    struct State {
        Layer layer = Layer::Static;
        bool listed = false;   // in moved_items_
        bool moved = false;    // since the last search; box_before_ holds
        bool touched = false;  // all its pairs are reported
        // Contacts of the item may have parted while nobody looked: it moved while or before it slept. Those
        // of its pairs that are new by their boxes may be known to the caller, until it has been awake for a
        // search.
        bool unsettled = false;
        bool has_way = false;
        bool had_way = false;  // at the last search
    };

    void note_move(int item, const Aabb& before);
    bool remember(int item, const Aabb& before);
    void cover_ways();
    void drop_way(int item);
    void collect_moved_groups(TaskPool& tasks);
    void mark_moved_lanes(TaskPool& tasks);
    int fill_moved_group(std::size_t at);
    void sort(std::vector<ItemPair>& pairs);
    [[nodiscard]] bool may_be_known(const ItemPair& pair) const;

    std::array<BoxTree, kLayers.size()> trees_;
    std::vector<State> states_;     // by item
    std::vector<Aabb> box_before_;  // by item
    std::vector<int> kin_;          // by item; empty until one is of any
    // By item; 0 for those that have none, and empty until one has.
    std::vector<Vec2> ways_;
    std::vector<Vec2> way_before_;  // beside them, of those that had one
    int with_ways_ = 0;
    bool had_ways_ = false;         // some item, now or at some time since the last search
    std::vector<int> moved_items_;  // in the order of their first move; some may be gone

    // Of the search that is under way.
    std::vector<MovedGroup> moved_groups_;
    std::vector<GroupWays> group_ways_;
    std::vector<GroupItems> group_items_;
    std::array<std::vector<int>, kLayers.size()> moved_index_;
    std::vector<ItemPair> pairs_;
    std::vector<PairsBeside> beside_;

    OrderScratch order_scratch_;
    RadixSort radix_;
    std::vector<std::uint64_t> pair_keys_;
};

}  // namespace cairn::physics
