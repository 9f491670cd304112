// Contact creation, update and removal.
#include "world/contacts.h"

#include <cairn/physics/tuning.h>

#include "collide/manifold.h"
#include "world/contact_events.h"
#include "world/fast_bodies.h"
#include "world/filtering.h"
#include "world/one_way.h"
#include "world/sleep.h"
#include "world/special_contacts.h"

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
    c.radius_a = a.convex.radius();
    c.radius_b = b.convex.radius();
    mix_materials(stores, c);
    c.reports_touch = a.def.contact_events || b.def.contact_events;
    c.reports_hit = a.def.hit_events || b.def.hit_events;
    mark_special(stores, c);

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
    contacts.active.remove(contacts.slots, contact);
    unlink_edge(contacts.slots, stores.bodies.slots[c.body_a].first_contact, contact, 0);
    unlink_edge(contacts.slots, stores.bodies.slots[c.body_b].first_contact, contact, 1);
    contacts.slots.erase(contact);
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
    bool carried = false;
    for (int i = 0; i < m.count; ++i) {
        ContactPoint p;
        p.r_a = rotate(xf_a.q, m.points[i].point - center_a);
        p.r_b = p.r_a - a_to_b;
        p.separation = m.points[i].separation;
        p.id = m.points[i].id;
        p.is_new = true;
        for (int j = 0; j < old_count; ++j) {
            if (old_points[j].id != p.id) continue;
            p.normal_impulse = old_points[j].normal_impulse;
            carried = true;
            p.is_new = false;
        }
        c.points[i] = p;
    }
    if (!carried) c.friction_impulse = 0;
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

bool has_contact(const Stores& stores, int shape_a, int shape_b) {
    const auto& slots = stores.contacts.slots;
    int of_a = stores.bodies.slots[stores.shapes[shape_a].body].first_contact;
    int of_b = stores.bodies.slots[stores.shapes[shape_b].body].first_contact;
    // Both lists at once, until the shorter one ends: what rests on the ground has few contacts, the ground
    // many.
    const auto is_it = [&](int key) {
        const ContactRecord& c = slots[edge_record(key)];
        return c.shape_a == std::min(shape_a, shape_b) && c.shape_b == std::max(shape_a, shape_b);
    };
    while (of_a != kNone && of_b != kNone) {
        if (is_it(of_a) || is_it(of_b)) return true;
        of_a = slots[edge_record(of_a)].edges[edge_side(of_a)].next;
        of_b = slots[edge_record(of_b)].edges[edge_side(of_b)].next;
    }
    return false;
}

void find_new_pairs(Stores& stores) {
    for (const ItemPair& pair : stores.broad.find_new_pairs()) {
        if (pair.may_be_known && has_contact(stores, pair.a, pair.b)) continue;
        if (may_collide(stores, pair.a, pair.b)) create_contact(stores, pair.a, pair.b);
    }
}

void update_contacts(Stores& stores, Events& events, std::vector<int>& parted, Vec2 gravity_m_s2,
                     float dt_s) {
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
        if (special::has(c, special::kRefused)) continue;
        compute_manifold(stores, c);
        if (c.count == 0) predict_contact(stores, c, gravity_m_s2, dt_s);
        if (special::has(c, special::kOneWay)) screen_one_way(stores, c);
        if (c.count == 0) {
            report_parting(stores, c, events.ends);
        } else {
            wake_touched(stores, c);
        }
    }
    for (const int contact : parted) {
        report_parting(stores, contacts.slots[contact], events.ends);
        remove_contact(stores, contact);
    }
}

void destroy_contact(Stores& stores, Events& events, int contact) {
    ContactRecord& c = stores.contacts.slots[contact];
    if (c.count > 0) {
        wake_body(stores, c.body_a);
        wake_body(stores, c.body_b);
    }
    report_parting(stores, c, events.pending_ends);
    remove_contact(stores, contact);
}

}  // namespace cairn::physics
