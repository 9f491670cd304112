// Counts and depths, found by walking over everything.
#include "world/measures.h"

#include <algorithm>

#include "collide/manifold.h"
#include "world/contact_events.h"

namespace cairn::physics {
namespace {

// Where the shapes are now: the points that a contact remembers are of the start of the last step.
float penetration_m(const Stores& stores, const ContactRecord& c) {
    const Transform xf_a = stores.bodies.transform(c.body_a);
    const Transform xf_b = stores.bodies.transform(c.body_b);
    const RelativePose b_in_a{inverse_rotate(xf_a.q, xf_b.p - xf_a.p), inverse(xf_a.q) * xf_b.q};
    const Manifold m = collide(stores.shapes[c.shape_a].convex, stores.shapes[c.shape_b].convex, b_in_a, 0);
    float deepest = 0;
    for (int i = 0; i < m.count; ++i) deepest = std::max(deepest, -m.points[i].separation);
    return deepest;
}

}  // namespace

Counts count_objects(const Stores& stores) {
    Counts counts;
    counts.bodies = stores.bodies.slots.size();
    counts.awake_bodies = stores.bodies.rows(RowSet::Awake).size();
    counts.shapes = stores.shapes.size();
    counts.joints = stores.joints.slots.size();
    counts.contacts = stores.contacts.slots.size();
    for (int i = 0; i < stores.contacts.slots.end_index(); ++i) {
        if (stores.contacts.slots.alive(i) && is_touching(stores.contacts, i)) ++counts.touching;
    }
    return counts;
}

float max_penetration_m(const Stores& stores) {
    float deepest = 0;
    for (int i = 0; i < stores.contacts.slots.end_index(); ++i) {
        if (!stores.contacts.slots.alive(i) || !is_touching(stores.contacts, i)) continue;
        deepest = std::max(deepest, penetration_m(stores, stores.contacts.slots[i]));
    }
    return deepest;
}

}  // namespace cairn::physics
