// The broad phase as bytes. The boxes of shapes are those of its trees, so of a tree only the order of its
// items and the nodes above them are written; these may be larger than what they hold, until it is put in
// order again.
#include "state/sections.h"
#include "state/slots.h"
#include "world/bodies.h"

namespace cairn::physics {
namespace {

// A tree is put in order long before.
constexpr int kMostDisorder = 1 << 30;

constexpr std::uint8_t kMoved = 1;
constexpr std::uint8_t kTouched = 2;
constexpr std::uint8_t kUnsettled = 4;
constexpr std::uint8_t kHasWay = 8;
constexpr std::uint8_t kHadWay = 16;
constexpr std::uint8_t kAll = 31;

std::size_t groups_for(std::size_t count) {
    return (count + kGroupSize - 1) / kGroupSize;
}

// Calls visit(level, nodes) for the levels above the lowest, of a tree with so many groups there.
template <class Visit>
void for_each_upper_level(std::size_t groups, Visit&& visit) {
    for (std::size_t level = 1; groups > 1; ++level) {
        groups = groups_for(groups);
        visit(level, groups);
    }
}

std::byte* put_group(std::byte* at, const BoxGroup& group) {
    const auto& [lower_x, lower_y, upper_x, upper_y] = group;
    return put(put(put(put(at, lower_x), lower_y), upper_x), upper_y);
}

constexpr std::size_t kGroupBytes = 4 * sizeof(BoxGroup::Lanes);

const std::byte* get_group(const std::byte* at, BoxGroup& group, Reading& reading) {
    auto& [lower_x, lower_y, upper_x, upper_y] = group;
    for (BoxGroup::Lanes* lanes : {&lower_x, &lower_y, &upper_x, &upper_y}) at = get(at, *lanes, reading);
    return at;
}

void save_tree(const BoxTree& tree, Writer& out) {
    StateAccess::tree(tree, [&](const auto& levels, int, const auto& items, const auto&, int end, int,
                                const TreeWear& wear) {
        out.value(end);
        out.value(wear.disorder);
        out.value(wear.girth_m);
        out.value(wear.sorted_girth_m);
        out.list(items);
        for_each_upper_level(levels[0].size(), [&](std::size_t level, std::size_t nodes) {
            std::byte* at = out.room(nodes * kGroupBytes);
            for (const BoxGroup& group : levels[level]) at = put_group(at, group);
            out.end(at);
        });
    });
}

// Whoever walks down a tree enters every child whose box is met: it must be there, and all of it in the box.
bool enclose(const std::vector<BoxGroup>& nodes, const std::vector<BoxGroup>& children) {
    for (std::size_t child = 0; child < kGroupSize * nodes.size(); ++child) {
        const Aabb box = nodes[child / kGroupSize].box(static_cast<int>(child % kGroupSize));
        const bool fits = child < children.size() ? contains(box, bounds(children[child]))
                                                  : box.lower == Aabb{}.lower && box.upper == Aabb{}.upper;
        if (!fits) return false;
    }
    return true;
}

// Whether its items are shapes, and of this layer, is looked at by the shapes, which stand in order.
void load_tree(Reader& in, const Stores& stores, BoxTree& tree) {
    StateAccess::tree(tree, [&](auto& levels, int& level_count, auto& items, auto& places, int& end,
                                int& live, TreeWear& wear) {
        in.value(end);
        in.value(wear.disorder);
        in.value(wear.girth_m);
        in.value(wear.sorted_girth_m);
        in.list(items);
        for (auto& level : levels) level.clear();
        level_count = 0;
        live = 0;
        const int slots = stores.shapes.end_index();
        places.assign(static_cast<std::size_t>(slots), kNone);
        if (!in.ok()) return;
        const bool fits = end >= 0 && items.size() == kGroupSize * groups_for(static_cast<std::size_t>(end));
        if (!in.require(fits && wear.disorder >= 0 && wear.disorder <= kMostDisorder,
                        "a tree has not as many places as it says"))
            return;
        levels[0].resize(items.size() / kGroupSize);
        const Aabb* const boxes = stores.fat_boxes.data();
        int* const place_of = places.data();
        int place = 0;
        for (BoxGroup& group : levels[0]) {
            for (int lane = 0; lane < kGroupSize; ++lane, ++place) {
                const int item = items[static_cast<std::size_t>(place)];
                if (item == kNone) continue;
                const bool may_stand = item >= 0 && item < slots && place_of[item] == kNone && place < end;
                if (!in.require(may_stand, "a tree has an item that there is not, or twice")) return;
                place_of[item] = place;
                group.set_box(lane, boxes[item]);
                ++live;
            }
        }
        if (!in.require(live > 0 || items.empty(), "a tree has places, but no items")) return;
        level_count = levels[0].empty() ? 0 : 1;
        for_each_upper_level(levels[0].size(), [&](std::size_t level, std::size_t nodes) {
            const std::byte* at = in.take(nodes * kGroupBytes);
            if (at == nullptr || !in.require(level < levels.size(), "a tree is too deep")) return;
            levels[level].resize(nodes);
            for (BoxGroup& group : levels[level]) at = get_group(at, group, in.reading);
            level_count = static_cast<int>(level) + 1;
            in.require(enclose(levels[level], levels[level - 1]),
                       "a node of a tree does not hold its children");
        });
    });
}

bool is_boxed(const ShapeRecord& shape) {
    return shape.sensor == kNone;
}

}  // namespace

void save_broad(const Stores& stores, Writer& out) {
    StateAccess::broad(stores.broad, [&](const auto& trees, const auto& states, const auto& box_before,
                                         const auto& ways, const auto& way_before, int with_ways, bool,
                                         const auto& moved_items, const auto&) {
        for (const BoxTree& tree : trees) save_tree(tree, out);
        std::byte* at = out.room(static_cast<std::size_t>(stores.shapes.size()));
        for_each_alive(stores.shapes, [&](int item, const ShapeRecord& shape) {
            if (!is_boxed(shape)) return;
            StateAccess::item(
                states[static_cast<std::size_t>(item)],
                [&](Layer, bool, bool moved, bool touched, bool unsettled, bool has_way, bool had_way) {
                    at = put(
                        at, static_cast<std::uint8_t>((moved ? kMoved : 0) | (touched ? kTouched : 0) |
                                                      (unsettled ? kUnsettled : 0) | (has_way ? kHasWay : 0) |
                                                      (moved && had_way ? kHadWay : 0)));
                });
        });
        out.end(at);
        at = out.room(sizeof(int) + moved_items.size() * (sizeof(int) + sizeof(Aabb) + sizeof(Vec2)));
        at = put(at, static_cast<std::uint32_t>(moved_items.size()));
        for (const int item : moved_items) {
            const auto& state = states[static_cast<std::size_t>(item)];
            at = put(at, item);
            if (!state.moved) continue;
            at = put(at, box_before[static_cast<std::size_t>(item)]);
            if (state.had_way) at = put(at, way_before[static_cast<std::size_t>(item)]);
        }
        out.end(at);
        if (with_ways == 0) return;
        at = out.room(static_cast<std::size_t>(with_ways) * sizeof(Vec2));
        for_each_alive(stores.shapes, [&](int item, const ShapeRecord& shape) {
            if (is_boxed(shape) && states[static_cast<std::size_t>(item)].has_way)
                at = put(at, ways[static_cast<std::size_t>(item)]);
        });
        out.end(at);
    });
}

void load_broad(Reader& in, Stores& stores) {
    in.begin("broad phase");
    StateAccess::broad(
        stores.broad, [&](auto& trees, auto& states, auto& box_before, auto& ways, auto& way_before,
                          int& with_ways, bool& had_ways, auto& moved_items, auto& kin) {
            const auto slots = static_cast<std::size_t>(stores.shapes.end_index());
            states.assign(slots, {});
            kin.clear();
            int live = 0;
            for (const Layer layer : kLayers) {
                BoxTree& tree = trees[static_cast<std::size_t>(layer)];
                load_tree(in, stores, tree);
                if (!in.ok()) return;
                live += tree.size();
            }
            const int boxed = stores.shapes.size() - static_cast<int>(stores.sensors.all.size());
            if (!in.require(live == boxed, "a shape is in no tree, or in two")) return;
            const std::byte* at = in.take(static_cast<std::size_t>(boxed));
            if (at == nullptr) return;
            box_before.resize(slots);
            ways.assign(slots, {});
            way_before.resize(slots);
            with_ways = 0;
            int waiting = 0;  // that moved, and must be listed
            std::uint8_t all_bits = 0;
            bool all_held = true;
            for_each_alive(stores.shapes, [&](int item, const ShapeRecord& shape) {
                if (!is_boxed(shape)) return;
                std::uint8_t bits = 0;
                at = get(at, bits, in.reading);
                auto& state = states[static_cast<std::size_t>(item)];
                state.layer = layer_of(stores.bodies.slots[shape.body].set);
                all_held &= trees[static_cast<std::size_t>(state.layer)].holds(item);
                if (bits == 0) return;
                all_bits |= bits;
                state.moved = (bits & kMoved) != 0;
                state.touched = (bits & kTouched) != 0;
                state.unsettled = (bits & kUnsettled) != 0;
                state.has_way = (bits & kHasWay) != 0;
                state.had_way = (bits & kHadWay) != 0;
                with_ways += state.has_way ? 1 : 0;
                waiting += state.moved ? 1 : 0;
                if (!state.has_way) return;
                const std::uint32_t flags = stores.bodies.places[static_cast<std::size_t>(shape.body)].flags;
                in.require(state.layer == Layer::Awake && (flags & place_flag::kHasWay) != 0,
                           "a box has a way, though its body is not fast");
            });
            had_ways = (all_bits & (kHasWay | kHadWay)) != 0;
            in.require(all_held, "a shape is in the tree of another layer");
            in.require(all_bits <= kAll, "a box has what no box has");
            moved_items.resize(in.count(sizeof(int)));
            for (int& item : moved_items) {
                in.value(item);
                const bool fits = item >= 0 && static_cast<std::size_t>(item) < slots &&
                                  !states[static_cast<std::size_t>(item)].listed;
                if (!in.require(fits, "a box is listed as moved that there is not, or twice")) return;
                auto& state = states[static_cast<std::size_t>(item)];
                state.listed = true;
                if (!state.moved) continue;
                in.value(box_before[static_cast<std::size_t>(item)]);
                if (state.had_way) in.value(way_before[static_cast<std::size_t>(item)]);
                --waiting;
            }
            in.require(waiting == 0, "a box moved that is not listed");
            if (with_ways == 0) return;
            for_each_alive(stores.shapes, [&](int item, const ShapeRecord& shape) {
                if (is_boxed(shape) && states[static_cast<std::size_t>(item)].has_way)
                    in.value(ways[static_cast<std::size_t>(item)]);
            });
        });
    if (!in.settle()) return;
    for_each_alive(stores.shapes, [&](int item, const ShapeRecord& shape) {
        if (is_boxed(shape)) tell_kin(stores, item);
    });
}

}  // namespace cairn::physics
