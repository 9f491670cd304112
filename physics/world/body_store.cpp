// Upkeep of rows: the last row fills the gap, and its body learns its new place.
#include "world/body_store.h"

namespace cairn::physics {

void BodyStore::add_row(int body, RowSet set) {
    BodyRows& to = rows(set);
    std::apply([](auto&... column) { (column.emplace_back(), ...); }, to.columns());
    to.body.back() = body;
    slots[body].set = set;
    slots[body].row = to.size() - 1;
}

void BodyStore::drop_row(RowSet set, int row) {
    BodyRows& from = rows(set);
    const int moved_body = from.body.back();
    std::apply([row](auto&... column) { ((column[row] = column.back(), column.pop_back()), ...); },
               from.columns());
    if (row < from.size()) slots[moved_body].row = row;
}

void BodyStore::remove_row(int body) {
    drop_row(slots[body].set, slots[body].row);
    slots[body].row = kNone;
}

void BodyStore::move_row(int body, RowSet set) {
    const RowSet old_set = slots[body].set;
    const int old_row = slots[body].row;
    BodyRows& from = rows(old_set);
    BodyRows& to = rows(set);
    std::apply(
        [&](auto&... target) {
            std::apply([&](auto&... source) { (target.push_back(source[old_row]), ...); }, from.columns());
        },
        to.columns());
    slots[body].set = set;
    slots[body].row = to.size() - 1;
    drop_row(old_set, old_row);
}

Transform BodyStore::transform(int body) const {
    const BodyRecord& record = slots[body];
    const BodyRows& in = rows(record.set);
    const Rotation q = in.rotation[record.row];
    return {in.center[record.row] + -rotate(q, record.mass.center_m), q};
}

Vec2 BodyStore::center_offset(int a, int b) const {
    return rows_of(b).center[slots[b].row] - rows_of(a).center[slots[a].row];
}

}  // namespace cairn::physics
