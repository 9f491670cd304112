// Contact events.
#include "world/contact_events.h"

#include <cmath>

namespace cairn::physics {
namespace {

// Where a contact point of body a is at the end of the step.
Position place_of(const Stores& stores, const ContactRecord& contact, const Motion& a, Vec2 r_a) {
    return stores.bodies.places[contact.body_a].center + (a.dp + rotate(a.dq, r_a));
}

ContactBegin begin_event(const Stores& stores, const ContactRecord& c, const ContactConstraint& constraint,
                         const Motion& a) {
    Vec2 middle = constraint.points[0].r_a;
    if (constraint.count == 2) middle = 0.5f * (middle + constraint.points[1].r_a);
    return {stores.shapes.id(c.shape_a),      stores.shapes.id(c.shape_b),
            stores.bodies.slots.id(c.body_a), stores.bodies.slots.id(c.body_b),
            place_of(stores, c, a, middle),   constraint.normal};
}

ContactHit hit_event(const Stores& stores, const ContactRecord& c, const ContactConstraint& constraint,
                     const ContactPointConstraint& fastest, const Motion& a) {
    float impulse = 0;
    for (int i = 0; i < constraint.count; ++i) impulse += constraint.points[i].total_normal_impulse;
    return {stores.shapes.id(c.shape_a),         stores.shapes.id(c.shape_b),
            stores.bodies.slots.id(c.body_a),    stores.bodies.slots.id(c.body_b),
            place_of(stores, c, a, fastest.r_a), constraint.normal,
            -fastest.closing_velocity,           impulse};
}

const ContactPointConstraint* fastest_hit(const ContactConstraint& c, float hit_speed_m_s) {
    const ContactPointConstraint* fastest = nullptr;
    for (int i = 0; i < c.count; ++i) {
        const ContactPointConstraint& p = c.points[i];
        if (p.total_normal_impulse == 0 || -p.closing_velocity <= hit_speed_m_s) continue;
        if (!fastest || p.closing_velocity < fastest->closing_velocity) fastest = &p;
    }
    return fastest;
}

}  // namespace

void report_parting(const Stores& stores, ContactRecord& contact, std::vector<ContactEnd>& ends) {
    if (!contact.touching) return;
    contact.touching = false;
    if (!contact.reports_touch) return;
    ends.push_back({stores.shapes.id(contact.shape_a), stores.shapes.id(contact.shape_b),
                    stores.bodies.slots.id(contact.body_a), stores.bodies.slots.id(contact.body_b)});
}

void report_contacts(Stores& stores, const StepScratch& scratch, float hit_speed_m_s, Events& events) {
    const Motions& motions = scratch.motions;
    for (const ContactConstraint& c : scratch.contacts) {
        ContactRecord& record = stores.contacts.slots[c.contact];
        const bool touching =
            touches(c.count, {c.points[0].total_normal_impulse, c.points[1].total_normal_impulse},
                    {c.points[0].end_separation, c.points[1].end_separation}, record.touching);
        if (record.touching && !touching) report_parting(stores, record, events.ends);
        if (touching && !record.touching) {
            record.touching = true;
            if (record.reports_touch)
                events.begins.push_back(begin_event(stores, record, c, motions.get(c.a)));
        }
        if (!record.reports_hit) continue;
        if (const auto* fastest = fastest_hit(c, hit_speed_m_s)) {
            const ContactHit hit = hit_event(stores, record, c, *fastest, motions.get(c.a));
            // Beyond all measure: one of the two is put back and halted, and has hit nothing.
            if (std::isfinite(hit.approach_speed_m_s) && std::isfinite(hit.impulse_ns)) {
                events.hits.push_back(hit);
            }
        }
    }
}

}  // namespace cairn::physics
