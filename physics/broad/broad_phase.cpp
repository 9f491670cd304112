// What moved since the last search, and the search.
#include "broad/broad_phase.h"

#include "base/ample.h"
#include "base/assert.h"

namespace cairn::physics {

void BroadPhase::add(int item, Layer layer, const Aabb& box) {
    if (item >= static_cast<int>(states_.size())) {
        states_.resize(item + 1);
        box_before_.resize(item + 1);
        ways_.resize(item + 1);
        way_before_.resize(item + 1);
    }
    states_[item] = {.layer = layer, .listed = states_[item].listed};
    trees_[index(layer)].insert(item, box, order_scratch_);
    note_move(item, Aabb{});
}

void BroadPhase::remove(int item) {
    trees_[index(states_[item].layer)].remove(item, order_scratch_);
    drop_way(item);
    states_[item] = {.listed = states_[item].listed};
}

void BroadPhase::move(int item, const Aabb& box) {
    State& state = states_[item];
    BoxTree& tree = trees_[index(state.layer)];
    note_move(item, tree.box(item));
    drop_way(item);
    tree.move(item, box);
    if (state.layer != Layer::Awake) state.unsettled = true;
}

void BroadPhase::shift(int item, const Aabb& box) {
    BoxTree& tree = trees_[index(Layer::Awake)];
    note_move(item, tree.box(item));
    drop_way(item);
    tree.shift(item, box);
}

void BroadPhase::set_way(int item, Vec2 way) {
    drop_way(item);
    if (way == Vec2{}) return;
    had_ways_ = states_[item].has_way = true;
    ways_[item] = way;
    ++with_ways_;
}

void BroadPhase::drop_way(int item) {
    if (!states_[item].has_way) return;
    states_[item].has_way = false;
    ways_[item] = {};
    --with_ways_;
}

void BroadPhase::touch(int item) {
    note_move(item, Aabb{});
    box_before_[item] = Aabb{};
    states_[item].touched = true;
}

void BroadPhase::set_layer(int item, Layer layer) {
    State& state = states_[item];
    if (state.layer == layer) return;
    const Aabb box = trees_[index(state.layer)].box(item);
    trees_[index(state.layer)].remove(item, order_scratch_);
    trees_[index(layer)].insert(item, box, order_scratch_);
    if (state.layer == Layer::Awake && state.moved) state.unsettled = true;
    state.layer = layer;
    // To be settled by the next search.
    if ((layer == Layer::Awake && state.unsettled) || state.has_way) note_move(item, box);
    drop_way(item);
}

// Remembers where the box was at the last search, if this is its first move since.
void BroadPhase::note_move(int item, const Aabb& before) {
    State& state = states_[item];
    if (!state.moved) {
        box_before_[item] = before;
        state.had_way = state.has_way;
        if (state.has_way) way_before_[item] = ways_[item];
    }
    state.moved = true;
    if (!state.listed) moved_items_.push_back(item);
    state.listed = true;
}

const std::vector<ItemPair>& BroadPhase::find_new_pairs() {
    pairs_.clear();
    beside_.clear();
    search(0, start_search(), {pairs_, beside_});
    end_search(pairs_);
    return pairs_;
}

int BroadPhase::start_search() {
    moved_groups_.clear();
    group_ways_.clear();
    if (moved_items_.empty()) return 0;
    for (BoxTree& tree : trees_) {
        if (tree.is_worn()) tree.rebuild(order_scratch_);
    }
    collect_moved_groups();
    return static_cast<int>(moved_groups_.size());
}

void BroadPhase::collect_moved_groups() {
    // First the lanes that moved, by group; then the groups in their order; then where each box was.
    for (auto& lanes : moved_index_) lanes.clear();
    for (const int item : moved_items_) {
        if (!states_[item].moved) continue;
        const BoxTree& tree = this->tree(layer(item));
        auto& lanes = moved_index_[index(layer(item))];
        if (lanes.empty()) resize_amply(lanes, tree.level(0).size());
        lanes[tree.place(item) / kGroupSize] |= 1 << (tree.place(item) % kGroupSize);
    }
    for (const Layer layer : kLayers) {
        auto& lanes = moved_index_[index(layer)];
        for (std::size_t group = 0; group < lanes.size(); ++group) {
            const auto moved = static_cast<LaneMask>(lanes[group]);
            lanes[group] = moved == 0 ? kNone : static_cast<int>(moved_groups_.size());
            if (moved == 0) continue;
            moved_groups_.push_back({layer, static_cast<int>(group), moved, tree(layer).level(0)[group]});
        }
    }
    [[maybe_unused]] int with_ways = 0;
    for (const int item : moved_items_) {
        if (!states_[item].moved) continue;
        const int place = tree(layer(item)).place(item);
        const int lane = place % kGroupSize;
        MovedGroup& group = moved_groups_[moved_index_[index(layer(item))][place / kGroupSize]];
        group.before.set_box(lane, box_before_[item]);
        if (!had_ways_) continue;
        const State& state = states_[item];
        if (state.has_way) note_way(group.ways, lane, ways_[item]);
        if (state.had_way) note_way(group.ways_before, lane, way_before_[item]);
        with_ways += state.has_way ? 1 : 0;
    }
    CAIRN_VALIDATE(!had_ways_ || with_ways == with_ways_, "a box was not moved since it had its way");
}

// Of a group, which gets an index with the first.
void BroadPhase::note_way(int& index, int lane, Vec2 way) {
    if (index == kNone) {
        index = static_cast<int>(group_ways_.size());
        group_ways_.emplace_back();
    }
    group_ways_[index].set_way(lane, way);
}

void BroadPhase::search(int first_group, int last_group, const FoundPairs& found) const {
    SearchedLayers layers;
    for (const Layer layer : kLayers) layers[index(layer)] = {&tree(layer), moved_index_[index(layer)]};
    find_pairs(layers, {moved_groups_, group_ways_}, first_group, last_group, found);
}

bool BroadPhase::may_be_known(const ItemPair& pair) const {
    const auto doubtful = [](const State& state) { return state.touched || state.unsettled; };
    return doubtful(states_[pair.a]) || doubtful(states_[pair.b]);
}

void BroadPhase::sort(std::vector<ItemPair>& pairs) {
    pair_keys_.clear();
    for (const ItemPair& pair : pairs)
        pair_keys_.push_back(static_cast<std::uint64_t>(pair.a) << 32 | static_cast<std::uint32_t>(pair.b));
    radix_.sort(pair_keys_);
    pairs.clear();
    for (const std::uint64_t key : pair_keys_)
        pairs.push_back({static_cast<int>(key >> 32), static_cast<int>(key & 0xffffffff)});
}

void BroadPhase::end_search(std::vector<ItemPair>& pairs) {
    sort(pairs);
    for (ItemPair& pair : pairs) pair.may_be_known = may_be_known(pair);
    for (const int item : moved_items_) {
        State& state = states_[item];
        state.listed = state.moved = state.touched = false;
        if (state.layer == Layer::Awake) state.unsettled = false;
    }
    moved_items_.clear();
    had_ways_ = with_ways_ > 0;
}

}  // namespace cairn::physics
