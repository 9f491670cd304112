// The invariants that the headers of world/ promise, checked over a whole world's data.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include <cairn/physics/tuning.h>

#include "world/contacts.h"
#include "world/filtering.h"
#include "world/world_state.h"

namespace cairn::physics::test {

inline void check_rows(const Stores& stores) {
    const BodyStore& bodies = stores.bodies;
    int rows = 0;
    for (const RowSet set : {RowSet::Static, RowSet::Awake, RowSet::Asleep}) {
        const BodyRows& in = bodies.rows(set);
        rows += in.size();
        for (int row = 0; row < in.size(); ++row) {
            const int body = in.body[row];
            REQUIRE(bodies.slots.alive(body));
            REQUIRE(bodies.slots[body].set == set);
            REQUIRE(bodies.slots[body].row == row);
            REQUIRE((bodies.slots[body].type == BodyType::Static) == (set == RowSet::Static));
            REQUIRE(is_finite(in.center[row]));
            REQUIRE(is_finite(in.velocity[row]));
            REQUIRE(std::isfinite(in.spin[row]));
            const Rotation q = in.rotation[row];
            REQUIRE(q.c * q.c + q.s * q.s == Approx(1).epsilon(1e-5));
            if (set == RowSet::Asleep) REQUIRE((in.velocity[row] == Vec2{} && in.spin[row] == 0));
        }
    }
    REQUIRE(rows == bodies.slots.size());
}

inline void check_shapes(const Stores& stores) {
    int listed = 0;
    int sensors = 0;
    for (int body = 0; body < stores.bodies.slots.end_index(); ++body) {
        if (!stores.bodies.slots.alive(body)) continue;
        const BodyRecord& record = stores.bodies.slots[body];
        int last = kNone;
        for (int shape = record.first_shape; shape != kNone; shape = stores.shapes[shape].next_of_body) {
            REQUIRE(stores.shapes.alive(shape));
            const ShapeRecord& s = stores.shapes[shape];
            REQUIRE(s.body == body);
            const Aabb box = bounds(s.convex, stores.bodies.transform(body));
            // Boxes are made when the shape was a rounding error away from where it is.
            REQUIRE(contains(s.fat_box, grown(box, 0.999f * tuning::kAabbReach_m)));
            REQUIRE(stores.broad.layer(shape) == layer_of(record.set));
            REQUIRE(stores.broad.tree(layer_of(record.set)).holds(shape));
            REQUIRE(stores.broad.box(shape).lower == s.fat_box.lower);
            REQUIRE(stores.broad.box(shape).upper == s.fat_box.upper);
            ++listed;
            last = shape;
        }
        REQUIRE(record.last_shape == last);
        for (int sensor = record.first_sensor; sensor != kNone; sensor = stores.shapes[sensor].next_of_body) {
            REQUIRE(stores.shapes.alive(sensor));
            const ShapeRecord& s = stores.shapes[sensor];
            REQUIRE(s.body == body);
            REQUIRE(s.def.sensor);
            REQUIRE(stores.sensors.all.at(s.sensor).shape == sensor);
            ++sensors;
        }
    }
    REQUIRE(listed + sensors == stores.shapes.size());
    REQUIRE(sensors == static_cast<int>(stores.sensors.all.size()));
    int in_trees = 0;
    for (const Layer layer : kLayers) {
        REQUIRE(stores.broad.tree(layer).is_valid());
        in_trees += stores.broad.tree(layer).size();
    }
    REQUIRE(in_trees == listed);
}

/// Of contacts or joints: each is in the lists of its two bodies once, and active when one of them is awake.
template <class Store, class Head>
void check_links(const Stores& stores, const Store& store, Head&& head) {
    std::multiset<std::pair<int, int>> in_lists;  // record, body
    for (int body = 0; body < stores.bodies.slots.end_index(); ++body) {
        if (!stores.bodies.slots.alive(body)) continue;
        for_each_edge(store.slots, head(stores.bodies.slots[body]), [&](int record, int side) {
            REQUIRE(store.slots.alive(record));
            REQUIRE((side == 0 ? store.slots[record].body_a : store.slots[record].body_b) == body);
            in_lists.emplace(record, body);
        });
    }
    int active = 0;
    for (int record = 0; record < store.slots.end_index(); ++record) {
        if (!store.slots.alive(record)) continue;
        const auto& r = store.slots[record];
        REQUIRE(in_lists.count({record, r.body_a}) == 1);
        REQUIRE(in_lists.count({record, r.body_b}) == 1);
        const bool should_be = stores.bodies.is_awake(r.body_a) || stores.bodies.is_awake(r.body_b);
        REQUIRE((r.active_index != kNone) == should_be);
        if (r.active_index != kNone) REQUIRE(store.active[r.active_index] == record);
        active += r.active_index != kNone ? 1 : 0;
    }
    REQUIRE(store.active.size() == active);
    REQUIRE(in_lists.size() == 2 * static_cast<std::size_t>(store.slots.size()));
}

inline void check_contacts(const Stores& stores) {
    std::set<std::pair<int, int>> pairs;
    for (int contact = 0; contact < stores.contacts.slots.end_index(); ++contact) {
        if (!stores.contacts.slots.alive(contact)) continue;
        const ContactRecord& c = stores.contacts.slots[contact];
        REQUIRE(c.shape_a < c.shape_b);
        REQUIRE(stores.shapes.alive(c.shape_a));
        REQUIRE(stores.shapes.alive(c.shape_b));
        REQUIRE(stores.shapes[c.shape_a].body == c.body_a);
        REQUIRE(stores.shapes[c.shape_b].body == c.body_b);
        REQUIRE(may_collide(stores, c.shape_a, c.shape_b));
        REQUIRE(pairs.emplace(c.shape_a, c.shape_b).second);
        REQUIRE(has_contact(stores, c.shape_a, c.shape_b));
        REQUIRE(c.count <= 2);
        REQUIRE(std::isfinite(c.friction_impulse));
        for (int i = 0; i < c.count; ++i) {
            REQUIRE(std::isfinite(c.points[i].separation));
            REQUIRE(c.points[i].normal_impulse >= 0);
            REQUIRE(std::isfinite(c.points[i].normal_impulse));
        }
    }
}

/// The ring of bodies that fell asleep together closes, and holds sleepers only.
inline void check_sleepers(const Stores& stores) {
    const BodyRows& asleep = stores.bodies.rows(RowSet::Asleep);
    for (const int body : asleep.body) {
        int steps = 0;
        for (int next = stores.bodies.slots[body].next_sleeper; next != body;
             next = stores.bodies.slots[next].next_sleeper) {
            REQUIRE(next != kNone);
            REQUIRE(stores.bodies.slots[next].set == RowSet::Asleep);
            REQUIRE(++steps <= asleep.size());
        }
    }
}

/// Right after pairs were looked for: every pair of fat boxes that overlap and may collide has its contact.
/// (Sensors have empty boxes.)
inline void check_nothing_missed(const Stores& stores) {
    for (int a = 0; a < stores.shapes.end_index(); ++a) {
        for (int b = a + 1; b < stores.shapes.end_index(); ++b) {
            if (!stores.shapes.alive(a) || !stores.shapes.alive(b)) continue;
            const bool meet = overlap(stores.shapes[a].fat_box, stores.shapes[b].fat_box);
            if (!meet || !may_collide(stores, a, b)) continue;
            REQUIRE(has_contact(stores, a, b));
        }
    }
}

inline void check_world(const WorldState& world) {
    check_rows(world.stores);
    check_shapes(world.stores);
    check_links(world.stores, world.stores.contacts,
                [](const BodyRecord& body) { return body.first_contact; });
    check_links(world.stores, world.stores.joints, [](const BodyRecord& body) { return body.first_joint; });
    check_contacts(world.stores);
    check_sleepers(world.stores);
}

}  // namespace cairn::physics::test
