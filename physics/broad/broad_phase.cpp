// What moved since the last search, and the search.
#include "broad/broad_phase.h"

#include <atomic>
#include <bit>

#include "base/ample.h"
#include "base/assert.h"

namespace cairn::physics {
namespace {

// What a thread takes at once.
constexpr int kGroupsPerChunk = 64;

}  // namespace

void BroadPhase::add(int item, Layer layer, const Aabb& box) {
    const std::size_t items = static_cast<std::size_t>(item) + 1;
    cover_amply(states_, items);
    cover_amply(box_before_, items);
    if (!ways_.empty()) cover_ways();
    set_kin(item, 0);
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

BroadPhase::Shifted BroadPhase::shift(int item, const Aabb& box, Vec2 way) {
    BoxTree& tree = trees_[index(Layer::Awake)];
    State& state = states_[item];
    const bool is_first = remember(item, tree.box(item));
    const bool had_way = state.has_way;
    state.has_way = way != Vec2{};
    if (had_way || state.has_way) ways_[item] = way;
    tree.shift(item, box);
    return {is_first, (state.has_way ? 1 : 0) - (had_way ? 1 : 0)};
}

void BroadPhase::end_shifts(const ChunkedList<int>& first_moves, int more_ways) {
    first_moves.for_each([&](int item) { push_amply(moved_items_, item); });
    with_ways_ += more_ways;
    had_ways_ |= has_ways();
    trees_[index(Layer::Awake)].refit();
}

void BroadPhase::set_way(int item, Vec2 way) {
    drop_way(item);
    if (way == Vec2{}) return;
    make_room_for_ways();
    had_ways_ = states_[item].has_way = true;
    ways_[item] = way;
    ++with_ways_;
}

void BroadPhase::cover_ways() {
    cover_amply(ways_, states_.size());
    cover_amply(way_before_, states_.size());
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

void BroadPhase::set_kin(int item, int kin) {
    if (kin_.empty() && kin == 0) return;
    cover_amply(kin_, states_.size());
    kin_[item] = kin;
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

void BroadPhase::note_move(int item, const Aabb& before) {
    if (remember(item, before)) push_amply(moved_items_, item);
}

// Remembers where the box was at the last search, if this is its first move since. Whether it is yet to be
// listed.
bool BroadPhase::remember(int item, const Aabb& before) {
    State& state = states_[item];
    if (!state.moved) {
        box_before_[item] = before;
        state.had_way = state.has_way;
        if (state.has_way) way_before_[item] = ways_[item];
    }
    state.moved = true;
    const bool was_listed = state.listed;
    state.listed = true;
    return !was_listed;
}

const std::vector<ItemPair>& BroadPhase::find_new_pairs(TaskPool& tasks) {
    pairs_.clear();
    beside_.clear();
    search(0, start_search(tasks), {pairs_, beside_});
    end_search(pairs_);
    return pairs_;
}

int BroadPhase::start_search(TaskPool& tasks) {
    // Ways are looked at where some item had one.
    if (!had_ways_) group_ways_.clear();
    if (moved_items_.empty()) {
        moved_groups_.clear();
        return 0;
    }
    for (BoxTree& tree : trees_) {
        if (tree.is_worn()) tree.rebuild(order_scratch_);
    }
    collect_moved_groups(tasks);
    return static_cast<int>(moved_groups_.size());
}

// The lanes that moved, by group; then the groups in their order; then where each box was.
void BroadPhase::collect_moved_groups(TaskPool& tasks) {
    mark_moved_lanes(tasks);
    std::size_t count = 0;
    for (const auto& lanes : moved_index_)
        count += lanes.size() - static_cast<std::size_t>(std::ranges::count(lanes, 0));
    resize_amply(moved_groups_, count);
    count = 0;
    for (const Layer layer : kLayers) {
        auto& lanes = moved_index_[index(layer)];
        for (std::size_t group = 0; group < lanes.size(); ++group) {
            const auto moved = static_cast<LaneMask>(lanes[group]);
            lanes[group] = moved == 0 ? kNone : static_cast<int>(count);
            if (moved == 0) continue;
            MovedGroup& to = moved_groups_[count++];
            to.layer = layer;
            to.group = static_cast<int>(group);
            to.lanes = moved;
        }
    }
    if (had_ways_) {
        resize_amply(group_ways_, 2 * count);
        resize_amply(group_items_, count);
    }
    [[maybe_unused]] std::atomic<int> with_ways = 0;
    tasks.parallel_for(static_cast<int>(moved_groups_.size()), kGroupsPerChunk, [&](const Chunk& chunk) {
        int found = 0;
        for (int i = chunk.begin; i < chunk.end; ++i) found += fill_moved_group(static_cast<std::size_t>(i));
        with_ways.fetch_add(found, std::memory_order_relaxed);
    });
    CAIRN_VALIDATE(!had_ways_ || with_ways == with_ways_, "a box was not moved since it had its way");
}

// Where many moved, group by group, on all threads; else from one that moved to the next.
void BroadPhase::mark_moved_lanes(TaskPool& tasks) {
    for (auto& lanes : moved_index_) lanes.clear();
    const BoxTree& awake = tree(Layer::Awake);
    const bool many = 8 * moved_items_.size() >= static_cast<std::size_t>(awake.size());
    if (many) {
        auto& lanes = moved_index_[index(Layer::Awake)];
        resize_amply(lanes, awake.level(0).size());
        const std::span<const int> items = awake.items();
        tasks.parallel_for(static_cast<int>(lanes.size()), kGroupsPerChunk, [&](const Chunk& chunk) {
            for (int group = chunk.begin; group < chunk.end; ++group) {
                unsigned moved = 0;
                for (int lane = 0; lane < kGroupSize; ++lane) {
                    const int item = items[kGroupSize * group + lane];
                    if (item != kNone && states_[item].moved) moved |= 1u << lane;
                }
                lanes[group] = static_cast<int>(moved);
            }
        });
    }
    for (const int item : moved_items_) {
        const State& state = states_[item];
        if (!state.moved || (many && state.layer == Layer::Awake)) continue;
        const BoxTree& tree = this->tree(state.layer);
        auto& lanes = moved_index_[index(state.layer)];
        if (lanes.empty()) assign_amply(lanes, tree.level(0).size(), 0);
        lanes[tree.place(item) / kGroupSize] |= 1 << (tree.place(item) % kGroupSize);
    }
}

// The boxes of a group as of the last search, and the ways of what moved: those of group i have the places 2
// i and 2 i + 1. The result is how many have a way.
int BroadPhase::fill_moved_group(std::size_t at) {
    MovedGroup& moved = moved_groups_[at];
    const BoxTree& tree = this->tree(moved.layer);
    moved.before = tree.level(0)[moved.group];
    if (had_ways_)
        std::copy_n(tree.items().begin() + kGroupSize * moved.group, kGroupSize, group_items_[at].begin());
    moved.ways = moved.ways_before = kNone;
    const auto set_way = [&](int& ways, std::size_t place, int lane, Vec2 way) {
        if (ways == kNone) group_ways_[place] = {};
        ways = static_cast<int>(place);
        group_ways_[place].set_way(lane, way);
    };
    int with_ways = 0;
    for (LaneMask lanes = moved.lanes; lanes != 0; lanes &= lanes - 1) {
        const int lane = std::countr_zero(lanes);
        const int item = tree.items()[kGroupSize * moved.group + lane];
        moved.before.set_box(lane, box_before_[item]);
        if (!had_ways_) continue;
        const State& state = states_[item];
        if (state.has_way) {
            set_way(moved.ways, 2 * at, lane, ways_[item]);
            ++with_ways;
        }
        if (state.had_way) set_way(moved.ways_before, 2 * at + 1, lane, way_before_[item]);
    }
    return with_ways;
}

void BroadPhase::search(int first_group, int last_group, const FoundPairs& found) const {
    SearchedLayers layers;
    for (const Layer layer : kLayers) layers[index(layer)] = {&tree(layer), moved_index_[index(layer)]};
    find_pairs(layers, {moved_groups_, group_ways_, kin_}, first_group, last_group, found);
}

bool BroadPhase::may_be_known(const ItemPair& pair) const {
    const auto doubtful = [](const State& state) { return state.touched || state.unsettled; };
    return doubtful(states_[pair.a]) || doubtful(states_[pair.b]);
}

void BroadPhase::sort(std::vector<ItemPair>& pairs) {
    pair_keys_.clear();
    reserve_amply(pair_keys_, pairs.size());
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
