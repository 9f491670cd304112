// Contacts that are collided anew in each substep.
#include "world/sweeping_contacts.h"

#include <algorithm>

#include <cairn/physics/tuning.h>

#include "collide/manifold.h"
#include "integrator/integrate.h"
#include "resolve/contact_points.h"

namespace cairn::physics {
namespace {

// One of the bodies, as it lies within the step.
struct Side {
    const BodyRecord& record;
    const Convex& shape;
    Motion motion;
    Rotation rotation;
};

Side side_of(const Stores& stores, const Motions& motions, int body, int shape, int row) {
    const Motion motion = motions.get(row);
    return {stores.bodies.slots[body], stores.shapes[shape].convex(), motion,
            normalized(motion.dq * stores.bodies.places[body].rotation)};
}

// From how far apart the two could meet within a substep, m: no farther than bodies as large as they are turn
// each other's way.
float reach_of(const Side& a, const Side& b, float h_s) {
    const auto turning = [](const Side& side) { return std::fabs(side.motion.w) * side.record.turn_arm_m; };
    const float closing = length(b.motion.v - a.motion.v) + turning(a) + turning(b);
    const float size = a.record.extent_m + b.record.extent_m;
    return std::max(tuning::kSpeculativeDistance_m, std::min(h_s * closing, size));
}

// Where the solver will see a point moved to by which it knows the core, and by how much the body has moved
// it.
struct CoreArm {
    Vec2 at_start;
    Vec2 moved;
};
CoreArm core_arm(const Motion& motion, Vec2 now) {
    const Vec2 at_start = inverse_rotate(motion.dq, now);
    return {at_start, motion.dp + now - at_start};
}

void collide_anew(const Stores& stores, const Motions& motions, const ContactRules& rules, float h_s,
                  ContactConstraint& c) {
    const ContactRecord& record = stores.contacts.slots[c.contact];
    const Side a = side_of(stores, motions, record.body_a, record.shape_a, c.a);
    const Side b = side_of(stores, motions, record.body_b, record.shape_b, c.b);
    const Vec2 between =
        stores.bodies.center_offset(record.body_a, record.body_b) + (b.motion.dp - a.motion.dp);
    const Rotation turn = inverse(a.rotation) * b.rotation;
    const Vec2 origin =
        a.record.mass.center_m + inverse_rotate(a.rotation, between) - rotate(turn, b.record.mass.center_m);
    const Manifold m = collide(a.shape, b.shape, {origin, turn}, reach_of(a, b, h_s));

    ContactInput input{};
    input.a = c.a;
    input.b = c.b;
    input.contact = c.contact;
    input.normal = m.count > 0 ? rotate(a.rotation, m.normal) : c.normal;
    input.count = m.count;
    for (int i = 0; i < m.count; ++i) {
        const Vec2 r_a = rotate(a.rotation, m.points[i].point - a.record.mass.center_m);
        input.points[i] = {r_a, r_a - between, m.points[i].separation, m.points[i].id, 0};
    }
    input.friction = c.friction;
    input.restitution = c.restitution;
    input.radius_a = a.shape.radius();
    input.radius_b = b.shape.radius();
    input.rolling_m = c.rolling_m;
    input.surface_speed_m_s = c.surface_speed_m_s;
    input.unit = c.unit;
    const ContactConstraint before = c;
    c = make_contact(input, motions, rules);
    c.in_lane = false;
    float closing = 0;  // the fastest that any point had
    for (int i = 0; i < before.count; ++i) closing = std::min(closing, before.points[i].closing_velocity);
    for (int i = 0; i < c.count; ++i) {
        ContactPointConstraint& p = c.points[i];
        const CoreArm of_a = core_arm(a.motion, p.core_r_a);
        const CoreArm of_b = core_arm(b.motion, p.core_r_b);
        p.core_r_a = of_a.at_start;
        p.core_r_b = of_b.at_start;
        p.separation -= dot(of_b.moved - of_a.moved, c.normal);
        p.closing_velocity = std::min(p.closing_velocity, closing);
        p.total_normal_impulse = before.points[i].total_normal_impulse;
        p.normal_impulse = total_normal(before) / static_cast<float>(c.count);
    }
    if (before.count == c.count) {
        for (int i = 0; i < c.count; ++i) c.points[i].normal_impulse = before.points[i].normal_impulse;
    }
    c.friction_impulse = before.friction_impulse;
}

// What acts between the two is not taken for impulses that are given again in the next substep.
template <class Act>
void with_both(const ContactConstraint& c, Motions& motions, const Act& act) {
    for (const int row : {c.a, c.b}) begin_joints(motions, row, row + 1);
    act();
    for (const int row : {c.a, c.b}) end_joints(motions, row, row + 1);
}

}  // namespace

void add_sweeping(StepScratch& scratch, int first_substep) {
    scratch.contacts.back().in_lane = false;
    scratch.sweeping.push_back({static_cast<int>(scratch.contacts.size()) - 1, first_substep});
}

void collide_sweeping(const Stores& stores, StepScratch& scratch, int substep, const ContactRules& rules,
                      float h_s) {
    for (const SweepingContact& sweeping : scratch.sweeping) {
        if (substep < sweeping.first_substep) continue;
        ContactConstraint& c = scratch.contacts[static_cast<std::size_t>(sweeping.contact)];
        collide_anew(stores, scratch.motions, rules, h_s, c);
        with_both(c, scratch.motions, [&] { warm_start_contact(c, scratch.motions, 1, 1); });
    }
}

void solve_sweeping(const Stores& stores, StepScratch& scratch, int substep, const ContactRules& rules,
                    float h_s, Pass pass) {
    Motions& motions = scratch.motions;
    for (const SweepingContact& sweeping : scratch.sweeping) {
        if (substep < sweeping.first_substep) continue;
        ContactConstraint& c = scratch.contacts[static_cast<std::size_t>(sweeping.contact)];
        if (pass == Pass::Relax) collide_anew(stores, motions, rules, h_s, c);
        with_both(c, motions, [&] { solve_contact(c, motions, rules, h_s, pass); });
    }
}

}  // namespace cairn::physics
