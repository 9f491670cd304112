// Upkeep of rows: the last row fills the gap, and its body learns its new place.
#include "world/body_store.h"

#include "base/ample.h"
#include "base/assert.h"

namespace cairn::physics {

void BodyStore::set_row(int body, RowSet set, int row) {
    slots[body].set = set;
    slots[body].row = row;
    places[body].row = set == RowSet::Awake ? row + 1 : kWorldRow;
    if (set != RowSet::Awake) places[body].flags &= place_flag::kBoxesMoved;
}

void BodyStore::add_row(int body, RowSet set) {
    BodyRows& to = rows(set);
    std::apply([](auto&... column) { (push_amply(column, {}), ...); }, to.columns());
    to.body.back() = body;
    cover_amply(places, static_cast<std::size_t>(body) + 1);
    // What stood in the slot before may be listed as moved still (Stores::boxes_moved), and is so once.
    const std::uint32_t listed = places[body].flags & place_flag::kBoxesMoved;
    places[body] = {};
    places[body].flags = listed;
    set_row(body, set, to.size() - 1);
}

void BodyStore::drop_row(RowSet set, int row) {
    BodyRows& from = rows(set);
    const int moved_body = from.body.back();
    std::apply([row](auto&... column) { ((column[row] = column.back(), column.pop_back()), ...); },
               from.columns());
    if (row < from.size()) set_row(moved_body, set, row);
}

void BodyStore::remove_row(int body) {
    drop_row(slots[body].set, slots[body].row);
    slots[body].row = kNone;
    places[body].row = kWorldRow;
}

void BodyStore::move_row(int body, RowSet set) {
    const RowSet old_set = slots[body].set;
    const int old_row = slots[body].row;
    BodyRows& from = rows(old_set);
    BodyRows& to = rows(set);
    std::apply(
        [&](auto&... target) {
            std::apply([&](auto&... source) { (push_amply(target, source[old_row]), ...); }, from.columns());
        },
        to.columns());
    set_row(body, set, to.size() - 1);
    drop_row(old_set, old_row);
}

void BodyStore::order_awake_rows(std::span<int> from) {
    BodyRows& awake = rows(RowSet::Awake);
    CAIRN_ASSERT(static_cast<int>(from.size()) == awake.size(), "each row has a place");
    const auto move = [&](std::size_t to, std::size_t source) {
        std::apply([&](auto&... column) { ((column[to] = column[source]), ...); }, awake.columns());
    };
    // Along the cycles of the permutation.
    for (std::size_t first = 0; first < from.size(); ++first) {
        if (from[first] == kNone || from[first] == static_cast<int>(first)) continue;
        const auto kept =
            std::apply([&](auto&... column) { return std::tuple(column[first]...); }, awake.columns());
        std::size_t gap = first;
        for (;;) {
            const auto source = static_cast<std::size_t>(from[gap]);
            from[gap] = kNone;
            if (source == first) break;
            move(gap, source);
            gap = source;
        }
        std::apply(
            [&](const auto&... value) {
                std::apply([&](auto&... column) { ((column[gap] = value), ...); }, awake.columns());
            },
            kept);
    }
    for (int row = 0; row < awake.size(); ++row) set_row(awake.body[row], RowSet::Awake, row);
}

Vec2 BodyStore::center_offset(int a, int b) const {
    return places[b].center - places[a].center;
}

}  // namespace cairn::physics
