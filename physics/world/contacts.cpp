// Contact creation, update and removal.
#include "world/contacts.h"

#include <algorithm>

#include <cairn/physics/tuning.h>

#include "collide/manifold.h"
#include "world/filtering.h"
#include "world/sleep.h"

namespace cairn::physics {
namespace {

void create_contact(Stores& stores, int shape_a, int shape_b) {
    const ShapeRecord& a = stores.shapes[shape_a];
    const ShapeRecord& b = stores.shapes[shape_b];
    ContactRecord c;
    c.shape_a = shape_a;
    c.shape_b = shape_b;
    c.body_a = a.body;
    c.body_b = b.body;
    mix_materials(stores, c);
    c.reports_touch = a.def.contact_events || b.def.contact_events;
    c.reports_hit = a.def.hit_events || b.def.hit_events;

    ContactStore& contacts = stores.contacts;
    const int contact = contacts.slots.insert(c);
    link_edge(contacts.slots, stores.bodies.slots[c.body_a].first_contact, contact, 0);
    link_edge(contacts.slots, stores.bodies.slots[c.body_b].first_contact, contact, 1);
    if (stores.bodies.is_awake(c.body_a) || stores.bodies.is_awake(c.body_b)) {
        contacts.active.add(contacts.slots, contact);
    }
}

void remove_contact(Stores& stores, int contact) {
    ContactStore& contacts = stores.contacts;
    const ContactRecord& c = contacts.slots[contact];
    contacts.pairs.erase(c.shape_a, c.shape_b);
    contacts.active.remove(contacts.slots, contact);
    unlink_edge(contacts.slots, stores.bodies.slots[c.body_a].first_contact, contact, 0);
    unlink_edge(contacts.slots, stores.bodies.slots[c.body_b].first_contact, contact, 1);
    contacts.slots.erase(contact);
}

ContactEnd end_event(const Stores& stores, const ContactRecord& c) {
    return {stores.shapes.id(c.shape_a), stores.shapes.id(c.shape_b), stores.bodies.slots.id(c.body_a),
            stores.bodies.slots.id(c.body_b)};
}

ContactBegin begin_event(const Stores& stores, const ContactRecord& c) {
    Vec2 middle = c.points[0].r_a;
    if (c.count == 2) middle = 0.5f * (middle + c.points[1].r_a);
    const int row = stores.bodies.slots[c.body_a].row;
    return {stores.shapes.id(c.shape_a),
            stores.shapes.id(c.shape_b),
            stores.bodies.slots.id(c.body_a),
            stores.bodies.slots.id(c.body_b),
            stores.bodies.rows_of(c.body_a).center[row] + middle,
            c.normal};
}

void compute_manifold(const Stores& stores, ContactRecord& c) {
    const BodyStore& bodies = stores.bodies;
    const Transform xf_a = bodies.transform(c.body_a);
    const Transform xf_b = bodies.transform(c.body_b);
    const RelativePose b_in_a{inverse_rotate(xf_a.q, xf_b.p - xf_a.p), inverse(xf_a.q) * xf_b.q};
    const Manifold m = collide(stores.shapes[c.shape_a].convex, stores.shapes[c.shape_b].convex, b_in_a,
                               tuning::kSpeculativeDistance_m);

    const auto old_points = c.points;
    const int old_count = c.count;
    const Vec2 center_a = bodies.slots[c.body_a].mass.center_m;
    const Vec2 a_to_b = bodies.center_offset(c.body_a, c.body_b);
    c.normal = rotate(xf_a.q, m.normal);
    c.count = m.count;
    for (int i = 0; i < m.count; ++i) {
        ContactPoint p;
        p.r_a = rotate(xf_a.q, m.points[i].point - center_a);
        p.r_b = p.r_a - a_to_b;
        p.separation = m.points[i].separation;
        p.id = m.points[i].id;
        for (int j = 0; j < old_count; ++j) {
            if (old_points[j].id != p.id) continue;
            p.normal_impulse = old_points[j].normal_impulse;
            p.tangent_impulse = old_points[j].tangent_impulse;
        }
        c.points[i] = p;
    }
}

// For events. Contacts exist from a speculative distance on; touching means that a force acts, or that no gap
// can be seen. Leaving takes twice the gap, so that a trembling pair does not flood its listener.
bool touches(const ContactRecord& c) {
    const float gap = (c.touching ? 2 : 1) * tuning::kLinearSlop_m;
    for (int i = 0; i < c.count; ++i) {
        if (c.points[i].separation < gap || c.points[i].normal_impulse > 0) return true;
    }
    return false;
}

void update_touching(const Stores& stores, ContactRecord& c, Events& events) {
    const bool touching = touches(c);
    if (touching == c.touching) return;
    c.touching = touching;
    if (!c.reports_touch) return;
    if (touching) {
        events.begins.push_back(begin_event(stores, c));
    } else {
        events.ends.push_back(end_event(stores, c));
    }
}

// A kinematic body that stands still disturbs nobody.
bool disturbs(const BodyStore& bodies, int body) {
    const BodyRecord& record = bodies.slots[body];
    if (record.set != RowSet::Awake) return false;
    const BodyRows& awake = bodies.rows(RowSet::Awake);
    return record.type == BodyType::Dynamic || awake.velocity[record.row] != Vec2{} ||
           awake.spin[record.row] != 0;
}

void wake_touched(Stores& stores, const ContactRecord& c) {
    const auto sleeps = [&](int body) {
        const BodyRecord& record = stores.bodies.slots[body];
        return record.set == RowSet::Asleep && record.type == BodyType::Dynamic;
    };
    if (sleeps(c.body_a) && disturbs(stores.bodies, c.body_b)) wake_body(stores, c.body_a);
    if (sleeps(c.body_b) && disturbs(stores.bodies, c.body_a)) wake_body(stores, c.body_b);
}

}  // namespace

void mix_materials(const Stores& stores, ContactRecord& contact) {
    const Material& a = stores.shapes[contact.shape_a].def.material;
    const Material& b = stores.shapes[contact.shape_b].def.material;
    contact.friction = std::sqrt(a.friction * b.friction);
    contact.restitution = std::max(a.restitution, b.restitution);
}

void find_new_pairs(Stores& stores) {
    for (const auto& [a, b] : stores.broad.find_new_pairs()) {
        if (!may_collide(stores, a, b)) continue;
        if (stores.contacts.pairs.insert(a, b)) create_contact(stores, a, b);
    }
}

void update_contacts(Stores& stores, Events& events, std::vector<int>& parted) {
    ContactStore& contacts = stores.contacts;
    parted.clear();
    // Waking appends to the active list, so its size is asked anew each time.
    for (int i = 0; i < contacts.active.size(); ++i) {
        const int contact = contacts.active[i];
        ContactRecord& c = contacts.slots[contact];
        if (!overlap(stores.shapes[c.shape_a].fat_box, stores.shapes[c.shape_b].fat_box)) {
            parted.push_back(contact);
            continue;
        }
        compute_manifold(stores, c);
        if (c.count > 0) wake_touched(stores, c);
        update_touching(stores, c, events);
    }
    for (const int contact : parted) {
        const ContactRecord& c = contacts.slots[contact];
        if (c.touching && c.reports_touch) events.ends.push_back(end_event(stores, c));
        remove_contact(stores, contact);
    }
}

void destroy_contact(Stores& stores, Events& events, int contact) {
    const ContactRecord& c = stores.contacts.slots[contact];
    if (c.count > 0) {
        wake_body(stores, c.body_a);
        wake_body(stores, c.body_b);
    }
    if (c.touching && c.reports_touch) events.pending_ends.push_back(end_event(stores, c));
    remove_contact(stores, contact);
}

}  // namespace cairn::physics
