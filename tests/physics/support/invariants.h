// The invariants that the headers of world/ promise, checked over a whole world's data.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <cairn/physics/tuning.h>

#include "world/breakables.h"
#include "world/contact_lists.h"
#include "world/filtering.h"
#include "world/new_contacts.h"
#include "world/special_contacts.h"
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
            const Place& place = bodies.places[body];
            REQUIRE(place.row == (set == RowSet::Awake ? row + 1 : kWorldRow));
            REQUIRE(is_finite(place.center));
            REQUIRE(is_finite(in.velocity[row]));
            REQUIRE(std::isfinite(in.spin[row]));
            const Rotation q = place.rotation;
            REQUIRE(q.c * q.c + q.s * q.s == Approx(1).epsilon(1e-5));
            if (set == RowSet::Asleep) REQUIRE((in.velocity[row] == Vec2{} && in.spin[row] == 0));
        }
    }
    REQUIRE(rows == bodies.slots.size());
}

inline void check_shapes(const Stores& stores) {
    int listed = 0;
    int sensors = 0;
    std::map<const ShapePrototype*, int> made_of;
    for (int shape = 0; shape < stores.shapes.end_index(); ++shape) {
        if (stores.shapes.alive(shape)) ++made_of[stores.shapes[shape].prototype];
    }
    REQUIRE(made_of.size() == stores.prototypes.size());
    for (const auto& [prototype, count] : made_of) REQUIRE(prototype->users == count);
    for (int body = 0; body < stores.bodies.slots.end_index(); ++body) {
        if (!stores.bodies.slots.alive(body)) continue;
        const BodyRecord& record = stores.bodies.slots[body];
        int last = kNone;
        for (int shape = record.first_shape; shape != kNone; shape = stores.shapes[shape].next_of_body) {
            REQUIRE(stores.shapes.alive(shape));
            const ShapeRecord& s = stores.shapes[shape];
            REQUIRE(s.body == body);
            REQUIRE(s.previous_of_body == last);
            REQUIRE((s.chain == kNone || stores.chains.alive(s.chain)));
            const Aabb box = bounds(s.convex(), stores.bodies.transform(body));
            // Boxes are made when the shape was a rounding error away from where it is.
            REQUIRE(contains(stores.fat_boxes[shape], grown(box, 0.999f * tuning::kAabbReach_m)));
            REQUIRE(stores.broad.layer(shape) == layer_of(record.set));
            REQUIRE(stores.broad.tree(layer_of(record.set)).holds(shape));
            REQUIRE(stores.broad.box(shape).lower == stores.fat_boxes[shape].lower);
            REQUIRE(stores.broad.box(shape).upper == stores.fat_boxes[shape].upper);
            ++listed;
            last = shape;
        }
        REQUIRE(record.last_shape == last);
        for (int sensor = record.first_sensor; sensor != kNone; sensor = stores.shapes[sensor].next_of_body) {
            REQUIRE(stores.shapes.alive(sensor));
            const ShapeRecord& s = stores.shapes[sensor];
            REQUIRE(s.body == body);
            REQUIRE(s.def().sensor);
            REQUIRE(stores.sensors.all.at(s.sensor).shape == sensor);
            ++sensors;
        }
    }
    for (int chain = 0; chain < stores.chains.end_index(); ++chain) {
        if (!stores.chains.alive(chain)) continue;
        const ChainRecord& record = stores.chains[chain];
        REQUIRE(record.segments.size() + (record.closed ? 0 : 1) == record.points_m.size());
        for (const int shape : record.segments) {
            REQUIRE(stores.shapes.alive(shape));
            REQUIRE((stores.shapes[shape].chain == chain && stores.shapes[shape].body == record.body));
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

/// Of contacts or joints: each is in the lists of its two bodies once, and listed when `takes_part(record)`.
/// `is_listed(record)` says so, and checks that the list knows the record too.
template <class Store, class Head, class IsListed, class TakesPart>
void check_links(const Stores& stores, const Store& store, int listed, Head&& head, IsListed&& is_listed,
                 TakesPart&& takes_part) {
    std::multiset<std::pair<int, int>> in_lists;  // record, body
    for (int body = 0; body < stores.bodies.slots.end_index(); ++body) {
        if (!stores.bodies.slots.alive(body)) continue;
        for_each_edge(store.slots, head(stores.bodies.slots[body]), [&](int record, int side) {
            REQUIRE(store.slots.alive(record));
            REQUIRE((side == 0 ? store.slots[record].body_a : store.slots[record].body_b) == body);
            in_lists.emplace(record, body);
        });
    }
    int found = 0;
    for (int record = 0; record < store.slots.end_index(); ++record) {
        if (!store.slots.alive(record)) continue;
        const auto& r = store.slots[record];
        REQUIRE(in_lists.count({record, r.body_a}) == 1);
        REQUIRE(in_lists.count({record, r.body_b}) == 1);
        const bool is_there = is_listed(record);
        REQUIRE(is_there == takes_part(r));
        found += is_there ? 1 : 0;
    }
    REQUIRE(listed == found);
    REQUIRE(in_lists.size() == 2 * static_cast<std::size_t>(store.slots.size()));
}

inline void check_contacts(const Stores& stores) {
    std::set<std::pair<int, int>> pairs;
    for (int contact = 0; contact < stores.contacts.slots.end_index(); ++contact) {
        if (!stores.contacts.slots.alive(contact)) continue;
        const ContactRecord& c = stores.contacts.slots[contact];
        REQUIRE(stores.shapes.alive(c.shape_a));
        REQUIRE(stores.shapes.alive(c.shape_b));
        REQUIRE(stores.shapes[c.shape_a].body == c.body_a);
        REQUIRE(stores.shapes[c.shape_b].body == c.body_b);
        REQUIRE(may_collide(stores, c.shape_a, c.shape_b));
        REQUIRE(pairs.emplace(std::minmax(c.shape_a, c.shape_b)).second);
        REQUIRE(stores.bodies.slots[c.body_b].type == BodyType::Dynamic);
        REQUIRE(has_contact(stores, c.shape_a, c.shape_b));
        const ContactMemory memory = memory_of(stores.contacts, contact);
        REQUIRE(std::isfinite(memory.friction_impulse));
        for (const float impulse : memory.impulse) {
            REQUIRE(std::isfinite(impulse));
            REQUIRE(impulse >= 0);
        }
    }
}

/// Whether the contact is in a list, after a look that its lane is its own.
inline bool contact_is_listed(const ContactStore& contacts, int contact) {
    const ContactRecord& c = contacts.slots[contact];
    if (c.bucket == kNone) return false;
    if (c.bucket == kLooseBucket) {
        REQUIRE(contacts.loose[c.lane] == contact);
        return true;
    }
    if (!is_colored(c.bucket)) {
        const auto& near = contacts.lanes.near_pairs(geometry_of(c.bucket));
        const NearPair& pair = near.at(static_cast<std::size_t>(c.lane));
        REQUIRE(pair.contact == contact);
        REQUIRE(pair.body_a == c.body_a);
        REQUIRE(pair.body_b == c.body_b);
        return true;
    }
    const int block = c.lane / kLanes;
    const PairBlock& pairs = contacts.lanes.pairs(block);
    REQUIRE(contacts.lanes.link(block).bucket == c.bucket);
    REQUIRE(pairs.contact[c.lane % kLanes] == contact);
    REQUIRE(pairs.body_a[c.lane % kLanes] == c.body_a);
    REQUIRE(pairs.body_b[c.lane % kLanes] == c.body_b);
    return true;
}

/// What is kept of a near pair is what its shapes and bodies say, or will be after the next look at bodies
/// whose shapes changed.
inline void check_near_pairs(const Stores& stores) {
    const ContactLanes& lanes = stores.contacts.lanes;
    for (int g = 0; g < kPairGeometries; ++g) {
        const auto geometry = static_cast<PairGeometry>(g);
        for (int lane = 0; lane < lanes.near_count(geometry); ++lane) {
            const NearPair& pair = lanes.near_pairs(geometry).at(static_cast<std::size_t>(lane));
            const auto changes = [&](int body) { return stores.masses.entries.at(body).is_outdated; };
            if (changes(pair.body_a) || changes(pair.body_b)) continue;
            REQUIRE(geometry_of(stores, stores.contacts.slots[pair.contact]) == geometry);
            NearPair made;
            fill_near_pair(stores, stores.contacts.slots[pair.contact], pair.contact, geometry, made);
            const auto reach_of = [&](int body, int shape) {
                return farthest_distance(stores.shapes[shape].convex(),
                                         stores.bodies.slots[body].mass.center_m);
            };
            REQUIRE(pair.reach_m ==
                    reach_of(pair.body_a, pair.shape_a) + reach_of(pair.body_b, pair.shape_b));
            REQUIRE(pair.shape_a == made.shape_a);
            REQUIRE(pair.shape_b == made.shape_b);
            REQUIRE(pair.offset_a == made.offset_a);
            REQUIRE(pair.offset_b == made.offset_b);
        }
    }
}

inline int count_listed(const ContactStore& contacts) {
    int count = static_cast<int>(contacts.loose.size());
    for (int geometry = 0; geometry < kPairGeometries; ++geometry)
        count += contacts.lanes.near_count(static_cast<PairGeometry>(geometry));
    for (int bucket = kFirstColored; bucket < kBuckets; ++bucket) {
        for (int block = contacts.lanes.first_block(bucket); block != kNone;
             block = contacts.lanes.link(block).next) {
            const BlockLink& link = contacts.lanes.link(block);
            REQUIRE((link.next == kNone ? link.used > 0 : link.used == kLanes));
            count += link.used;
        }
    }
    return count;
}

/// No moving body stands in two lanes of a colour, or in lanes of two domains, or sleeps; and the bits of
/// each body are those of its lanes.
inline void check_colors(const Stores& stores) {
    std::vector<std::uint32_t> colors(static_cast<std::size_t>(stores.bodies.slots.end_index()), 0);
    const auto take = [&](int body, int color) {
        REQUIRE((colors[body] >> color & 1) == 0);
        REQUIRE(stores.bodies.is_awake(body));
        colors[body] |= 1u << color;
    };
    const ContactLanes& lanes = stores.contacts.lanes;
    const Domains& domains = stores.domains;
    for (int bucket = kFirstColored; bucket < kBuckets; ++bucket) {
        for (int block = lanes.first_block(bucket); block != kNone; block = lanes.link(block).next) {
            const PairBlock& pairs = lanes.pairs(block);
            for (int lane = 0; lane < lanes.link(block).used; ++lane) {
                if (const int domain = domain_of(bucket); domain != kInterface) {
                    REQUIRE(domain <= domains.count);
                    REQUIRE(domains.of_body.at(pairs.body_b[lane]) == domain);
                    if (kind_of(bucket) == BlockKind::TwoBodies)
                        REQUIRE(domains.of_body.at(pairs.body_a[lane]) == domain);
                }
                take(pairs.body_b[lane], color_of(bucket));
                if (kind_of(bucket) == BlockKind::TwoBodies) take(pairs.body_a[lane], color_of(bucket));
            }
        }
    }
    for (std::size_t body = 0; body < stores.contacts.colors.size() && body < colors.size(); ++body) {
        REQUIRE(stores.contacts.colors[body] == colors[body]);
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

/// A body is listed once as one of which a box was moved, and flagged for as long as it is.
inline void check_moved_boxes(const Stores& stores) {
    std::set<int> listed;
    for (const int body : stores.boxes_moved) REQUIRE(listed.insert(body).second);
    for (int body = 0; body < stores.bodies.slots.end_index(); ++body) {
        const std::uint32_t flags = stores.bodies.places[static_cast<std::size_t>(body)].flags;
        REQUIRE(((flags & place_flag::kBoxesMoved) != 0) == (listed.count(body) == 1));
    }
}

/// Whether two shapes are a pair: their fat boxes overlap, and they do not keep apart on their ways.
inline bool are_near(const Stores& stores, int a, int b) {
    const Aabb& box_a = stores.fat_boxes[a];
    const Aabb& box_b = stores.fat_boxes[b];
    return overlap(box_a, box_b) && !keep_apart(box_a, stores.broad.way(a), box_b, stores.broad.way(b));
}

/// Right after pairs were looked for: every pair that may collide has its contact. (Sensors have empty
/// boxes.)
inline void check_nothing_missed(const Stores& stores) {
    for (int a = 0; a < stores.shapes.end_index(); ++a) {
        for (int b = a + 1; b < stores.shapes.end_index(); ++b) {
            if (!stores.shapes.alive(a) || !stores.shapes.alive(b)) continue;
            if (!are_near(stores, a, b) || !may_collide(stores, a, b)) continue;
            REQUIRE(has_contact(stores, a, b));
        }
    }
}

/// An active joint is swept or has a lane of its own, in a colour that both its bodies know of, and in a
/// domain that those of them which it moves are of.
inline void check_seats(const Stores& stores) {
    const JointStore& joints = stores.joints;
    std::set<std::pair<JointLaneKind, int>> lanes;
    for (int joint = 0; joint < joints.slots.end_index(); ++joint) {
        if (!joints.slots.alive(joint)) continue;
        const JointRecord& j = joints.slots[joint];
        const bool seated = j.seat.lane != kNone;
        REQUIRE((j.active_index != kNone) == (seated || j.swept_index != kNone));
        REQUIRE(!(seated && j.swept_index != kNone));
        if (j.swept_index != kNone) REQUIRE(joints.swept[j.swept_index] == joint);
        if (!seated) continue;
        REQUIRE(lanes.insert({j.seat.kind, j.seat.lane}).second);
        const std::uint32_t bit = 1u << joint_color(j.seat.bucket);
        REQUIRE((joints.colors[static_cast<std::size_t>(j.body_b)] & bit) != 0);
        const bool both = joint_block_kind(j.seat.bucket) == JointBlockKind::TwoBodies;
        if (both) REQUIRE((joints.colors[static_cast<std::size_t>(j.body_a)] & bit) != 0);
        const int domain = joint_domain(j.seat.bucket);
        if (domain == kInterface) continue;
        REQUIRE(domain <= stores.domains.count);
        REQUIRE(stores.domains.of_body.at(static_cast<std::size_t>(j.body_b)) == domain);
        if (both) REQUIRE(stores.domains.of_body.at(static_cast<std::size_t>(j.body_a)) == domain);
    }
}

inline void check_breakables(const Stores& stores) {
    for (std::size_t i = 0; i < stores.breakables.size(); ++i) {
        const int body = stores.breakables[i].body;
        REQUIRE(stores.bodies.slots.alive(body));
        REQUIRE(stores.bodies.slots[body].breakable == static_cast<int>(i));
        REQUIRE(stores.breakables[i].def.generations > 0);
    }
    int breakable = 0;
    for (int body = 0; body < stores.bodies.slots.end_index(); ++body) {
        if (stores.bodies.slots.alive(body) && is_breakable(stores, body)) ++breakable;
    }
    REQUIRE(breakable == static_cast<int>(stores.breakables.size()));
    for (int contact = 0; contact < stores.contacts.slots.end_index(); ++contact) {
        if (!stores.contacts.slots.alive(contact)) continue;
        const ContactRecord& c = stores.contacts.slots[contact];
        REQUIRE(special::has(c, special::kWatched) ==
                (is_breakable(stores, c.body_a) || is_breakable(stores, c.body_b)));
    }
}

inline void check_world(const WorldState& world) {
    check_rows(world.stores);
    check_seats(world.stores);
    check_shapes(world.stores);
    const Stores& stores = world.stores;
    check_links(
        stores, stores.contacts, count_listed(stores.contacts),
        [](const BodyRecord& body) { return body.first_contact; },
        [&](int contact) { return contact_is_listed(stores.contacts, contact); },
        [&](const ContactRecord& c) {
            return stores.bodies.is_awake(c.body_a) || stores.bodies.is_awake(c.body_b);
        });
    check_links(
        stores, stores.joints, stores.joints.active.size(),
        [](const BodyRecord& body) { return body.first_joint; },
        [&](int joint) {
            const int index = stores.joints.slots[joint].active_index;
            if (index != kNone) REQUIRE(stores.joints.active[index] == joint);
            return index != kNone;
        },
        // Where a joint has bodies that it can move, one of those is awake.
        [&](const JointRecord& j) {
            int awake = 0;
            int moved = 0;
            int moved_awake = 0;
            for (const int body : {j.body_a, j.body_b}) {
                const bool is_moved = stores.bodies.slots[body].type == BodyType::Dynamic;
                awake += stores.bodies.is_awake(body) ? 1 : 0;
                moved += is_moved ? 1 : 0;
                moved_awake += is_moved && stores.bodies.is_awake(body) ? 1 : 0;
            }
            return kind_of(j) != JointKind::Filter && (moved > 0 ? moved_awake : awake) > 0;
        });
    check_colors(stores);
    check_near_pairs(stores);
    check_contacts(world.stores);
    check_sleepers(world.stores);
    check_moved_boxes(world.stores);
    check_breakables(world.stores);
}

}  // namespace cairn::physics::test
