// The members of the containers that a snapshot looks into, each list once.
// Invariant: as in state/fields.h, a binding names every member, so that a new one does not compile before
// somebody has decided here what becomes of it.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

struct StateAccess {
    /// use(slots, free slots, objects). The tag stays the world's own.
    template <class Map, class Use>
    static auto slots(Map& map, Use&& use) {
        auto& [slots, free, size, world_tag] = map;
        return use(slots, free, size);
    }

    template <class List, class Use>
    static auto list(List& active_list, Use&& use) {
        auto& [list] = active_list;
        return use(list);
    }

    template <class Table, class Use>
    static auto rules(Table& table, Use&& use) {
        auto& [rules] = table;
        return use(rules);
    }

    /// use(levels, level count, items, places, end, live, wear). What sorting cost is left out.
    template <class Tree, class Use>
    static auto tree(Tree& tree, Use&& use) {
        auto& [levels, level_count, items, places, end, live, wear, ordered_count] = tree;
        return use(levels, level_count, items, places, end, live, wear);
    }

    /// use(trees, states, boxes before, ways, ways before, how many have ways, whether any had, moved items,
    /// kin). The rest is of one search.
    template <class Phase, class Use>
    static auto broad(Phase& broad, Use&& use) {
        auto& [trees, states, box_before, kin, ways, way_before, with_ways, had_ways, moved_items,
               moved_groups, group_ways, group_items, moved_index, pairs, beside, order_scratch, radix,
               pair_keys] = broad;
        return use(trees, states, box_before, ways, way_before, with_ways, had_ways, moved_items, kin);
    }

    /// use(layer, listed, moved, touched, unsettled, has way, had way).
    template <class State, class Use>
    static auto item(State& state, Use&& use) {
        auto& [layer, listed, moved, touched, unsettled, has_way, had_way] = state;
        return use(layer, listed, moved, touched, unsettled, has_way, had_way);
    }

    /// use(near pairs, how many of each list are in use), by geometry.
    template <class Lanes, class Use>
    static auto near(Lanes& lanes, Use&& use) {
        auto& [near, near_count, near_shrank, pairs, links, blocks, impacts, turns, free, chains, version,
               is_arranged, order, in_memory, ranges, used] = lanes;
        return use(near, near_count);
    }

    /// use(pairs, links, blocks, what bouncing takes of them, free blocks, chains, is arranged). The order
    /// follows from the chains.
    template <class Lanes, class Use>
    static auto colored(Lanes& lanes, Use&& use) {
        auto& [near, near_count, near_shrank, pairs, links, blocks, impacts, turns, free, chains, version,
               is_arranged, order, in_memory, ranges, used] = lanes;
        return use(pairs, links, blocks, impacts, free, chains, is_arranged);
    }

    /// use(pins, drives, wheels, h, springs changed, has crowded springs, has loads, dt).
    template <class Lanes, class Use>
    static auto joints(Lanes& lanes, Use&& use) {
        auto& [h_s, most_swept_hz, pins, drives, wheels, springs_changed, has_crowded_springs, has_loads,
               dt_s] = lanes;
        return use(pins, drives, wheels, h_s, most_swept_hz, springs_changed, has_crowded_springs, has_loads,
                   dt_s);
    }

    /// use(blocks, anchors, links, free blocks, chains).
    template <class Pool, class Use>
    static auto pool(Pool& pool, Use&& use) {
        auto& [blocks, anchors, links, free, chains, is_arranged, order, ranges, used] = pool;
        return use(blocks, anchors, links, free, chains);
    }

    /// Nothing is in order until the next step has looked at the chains.
    template <class Pool>
    static void disarrange(Pool& pool) {
        pool.is_arranged_ = false;
        pool.order_.clear();
        pool.ranges_.clear();
        pool.used_.clear();
    }
};

/// Calls visit(index, value) for each object, in the order of the slots.
template <class Map, class Visit>
void for_each_alive(Map& map, Visit&& visit) {
    StateAccess::slots(map, [&](auto& slots, auto&, auto&) {
        int index = 0;
        for (auto& slot : slots) {
            if (slot.use.alive()) visit(index, slot.value);
            ++index;
        }
    });
}

}  // namespace cairn::physics
