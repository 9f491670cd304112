// Which shapes meet: bodies, joints, filters.
#pragma once

#include <cairn/physics/query.h>

#include "world/world_state.h"

namespace cairn::physics {

inline bool filters_allow(const Filter& a, const Filter& b) {
    if (a.group != 0 && a.group == b.group) return a.group > 0;
    return (a.categories & b.mask) != 0 && (b.categories & a.mask) != 0;
}

inline bool filter_sees(const QueryFilter& query, const Filter& shape) {
    return (query.mask & shape.categories) != 0 && (query.categories & shape.mask) != 0;
}

/// Whether a contact between the two shapes may be: one body at least is dynamic, one shape at least is no
/// line, no joint forbids it, filters agree.
inline bool may_collide(const Stores& stores, int shape_a, int shape_b) {
    const int a = stores.shapes[shape_a].body;
    const int b = stores.shapes[shape_b].body;
    if (a == b) return false;
    if (stores.shapes[shape_a].convex().is_line() && stores.shapes[shape_b].convex().is_line()) return false;
    const BodyRecord& body_a = stores.bodies.slots[a];
    const BodyRecord& body_b = stores.bodies.slots[b];
    if (body_a.type != BodyType::Dynamic && body_b.type != BodyType::Dynamic) return false;
    if (!filters_allow(stores.shapes[shape_a].def().filter, stores.shapes[shape_b].def().filter))
        return false;
    bool allowed = true;
    for_each_edge(stores.joints.slots, body_a.first_joint, [&](int joint, int side) {
        const JointRecord& j = stores.joints.slots[joint];
        if ((side == 0 ? j.body_b : j.body_a) == b && !j.collide_connected) allowed = false;
    });
    return allowed;
}

/// The host's word on a new pair; see PairFilter.
inline bool host_allows(const Stores& stores, int shape_a, int shape_b) {
    const PairFilter& filter = stores.rules.filter;
    return !filter.may_collide ||
           filter.may_collide(filter.context, stores.shapes.id(shape_a), stores.shapes.id(shape_b));
}

}  // namespace cairn::physics
