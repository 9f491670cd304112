// The inside of a world as plain data. Invariant: nothing here changes the world, and no step calls it.
#include <algorithm>

#include <cairn/physics/world.h>

#include "base/union_find.h"
#include "collide/manifold.h"
#include "world/contact_events.h"
#include "world/contact_lists.h"
#include "world/joints.h"

namespace cairn::physics {
namespace {

Position in_world(Vec2 v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

/// What the contact remembers of a point. A feature may have changed since the step found the point; then the
/// impulse of the same place in the list is the likeliest.
float remembered_impulse(const ContactMemory& memory, const Manifold& manifold, int i) {
    float impulse = memory.impulse[i];
    for (int k = 0; k < 2; ++k) {
        if (memory.features[k] == static_cast<std::int32_t>(manifold.points[i].id))
            impulse = memory.impulse[k];
    }
    return std::max(impulse, 0.0f);  // below 0 stands for one that is not known yet
}

DebugContact describe(const Stores& stores, int contact, float substeps) {
    const ContactRecord& c = stores.contacts.slots[contact];
    const Transform xf_a = stores.bodies.transform(c.body_a);
    const Transform xf_b = stores.bodies.transform(c.body_b);
    const RelativePose b_in_a{inverse_rotate(xf_a.q, xf_b.p - xf_a.p), inverse(xf_a.q) * xf_b.q};
    const float reach_m = 2 * tuning::kLinearSlop_m;
    const Manifold manifold =
        collide(stores.shapes[c.shape_a].convex(), stores.shapes[c.shape_b].convex(), b_in_a, reach_m);
    const ContactMemory memory = memory_of(stores.contacts, contact);
    DebugContact told{.shape_a = stores.shapes.id(c.shape_a),
                      .shape_b = stores.shapes.id(c.shape_b),
                      .body_a = stores.bodies.slots.id(c.body_a),
                      .body_b = stores.bodies.slots.id(c.body_b),
                      .normal = rotate(xf_a.q, manifold.normal),
                      .friction_impulse_ns = substeps * memory.friction_impulse,
                      .count = manifold.count};
    for (int i = 0; i < manifold.count; ++i) {
        told.points[i] = {transform_point(xf_a, manifold.points[i].point), manifold.points[i].separation,
                          substeps * remembered_impulse(memory, manifold, i)};
    }
    return told;
}

/// Dynamic bodies hang together through what touches and joins them, as world/sleep.cpp has it; those asleep
/// form the groups in which they fell asleep.
UnionFind linked_bodies(const Stores& stores) {
    const auto& bodies = stores.bodies.slots;
    UnionFind sets;
    sets.reset(bodies.end_index());
    const auto link = [&](int a, int b) {
        const auto joins = [&](int body) {
            return bodies[body].type == BodyType::Dynamic && stores.bodies.is_awake(body);
        };
        if (joins(a) && joins(b)) sets.unite(a, b);
    };
    for (int i = 0; i < stores.contacts.slots.end_index(); ++i) {
        if (!stores.contacts.slots.alive(i)) continue;
        const ContactRecord& c = stores.contacts.slots[i];
        if (c.has_points || c.bucket == kLooseBucket) link(c.body_a, c.body_b);
    }
    for (const int joint : stores.joints.active)
        link(stores.joints.slots[joint].body_a, stores.joints.slots[joint].body_b);
    for (int i = 0; i < bodies.end_index(); ++i) {
        if (bodies.alive(i) && bodies[i].next_sleeper != kNone) sets.unite(i, bodies[i].next_sleeper);
    }
    return sets;
}

}  // namespace

std::vector<DebugContact> World::debug_contacts() const {
    const Stores& stores = state_->stores;
    const auto substeps = static_cast<float>(state_->def.substeps);
    std::vector<DebugContact> contacts;
    for (int i = 0; i < stores.contacts.slots.end_index(); ++i) {
        if (!stores.contacts.slots.alive(i) || !is_touching(stores.contacts, i)) continue;
        contacts.push_back(describe(stores, i, substeps));
    }
    return contacts;
}

std::vector<DebugIsland> World::debug_islands() const {
    const BodyStore& bodies = state_->stores.bodies;
    UnionFind sets = linked_bodies(state_->stores);
    std::vector<int> number(static_cast<std::size_t>(bodies.slots.end_index()), kNone);  // by root
    int count = 0;
    std::vector<DebugIsland> islands;
    for (int i = 0; i < bodies.slots.end_index(); ++i) {
        if (!bodies.slots.alive(i)) continue;
        const BodyRecord& body = bodies.slots[i];
        if (body.type != BodyType::Dynamic && body.next_sleeper == kNone) continue;
        int& island = number[sets.find(i)];
        if (island == kNone) island = count++;
        islands.push_back({bodies.slots.id(i), island, bodies.is_awake(i)});
    }
    return islands;
}

std::vector<DebugBox> World::debug_boxes() const {
    const Stores& stores = state_->stores;
    std::vector<DebugBox> boxes;
    for (int i = 0; i < stores.shapes.end_index(); ++i) {
        if (!stores.shapes.alive(i) || stores.shapes[i].sensor != kNone) continue;
        boxes.push_back(
            {stores.shapes.id(i), in_world(stores.fat_boxes[i].lower), in_world(stores.fat_boxes[i].upper)});
    }
    return boxes;
}

}  // namespace cairn::physics
