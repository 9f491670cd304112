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

// As if the two were apart by so much: what the contact did so far in the step stands for bounces and events.
void set_apart(const Motion& a, const Motion& b, float distance_m, Pass pass, ContactConstraint& c) {
    for (int i = 0; i < c.count; ++i) {
        ContactPointConstraint& p = c.points[i];
        const Vec2 moved_a = a.dp + rotate(a.dq, p.core_r_a) - p.core_r_a;
        const Vec2 moved_b = b.dp + rotate(b.dq, p.core_r_b) - p.core_r_b;
        p.separation = distance_m - dot(moved_b - moved_a, c.normal);
        if (pass == Pass::Relax) p.total_normal_impulse += p.normal_impulse;
        p.normal_impulse = 0;
    }
    c.friction_impulse = c.rolling_impulse = 0;
}

// Each point goes on with what the one of its feature did; what has no successor is the first one's.
void carry_on(const ContactConstraint& before, Pass pass, ContactConstraint& c) {
    const bool turned_round = dot(before.normal, c.normal) <= 0;
    for (int i = 0; i < before.count; ++i) {
        const ContactPointConstraint& from = before.points[i];
        const bool is_second = c.count == 2 && c.points[1].feature == from.feature;
        ContactPointConstraint& to = c.points[is_second ? 1 : 0];
        to.total_normal_impulse += from.total_normal_impulse;
        to.closing_velocity = std::min(to.closing_velocity, from.closing_velocity);
        if (!turned_round) to.normal_impulse += std::max(from.normal_impulse, 0.0f);
    }
    c.friction_impulse = turned_round ? 0 : before.friction_impulse;
    // At the start of a substep nothing applies it again.
    c.rolling_impulse = pass == Pass::Relax ? before.rolling_impulse : 0;
}

void collide_anew(const Stores& stores, const Motions& motions, const ContactRules& rules, float h_s,
                  Pass pass, ContactConstraint& c) {
    const ContactRecord& record = stores.contacts.slots[c.contact];
    const Side a = side_of(stores, motions, record.body_a, record.shape_a, c.a);
    const Side b = side_of(stores, motions, record.body_b, record.shape_b, c.b);
    const Vec2 between =
        stores.bodies.center_offset(record.body_a, record.body_b) + (b.motion.dp - a.motion.dp);
    const Rotation turn = inverse(a.rotation) * b.rotation;
    const Vec2 origin =
        a.record.mass.center_m + inverse_rotate(a.rotation, between) - rotate(turn, b.record.mass.center_m);
    const float reach = reach_of(a, b, h_s);
    const Manifold m = collide(a.shape, b.shape, {origin, turn}, reach);
    if (m.count == 0) return set_apart(a.motion, b.motion, reach, pass, c);

    ContactInput input{};
    input.a = c.a;
    input.b = c.b;
    input.contact = c.contact;
    input.normal = rotate(a.rotation, m.normal);
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
    for (int i = 0; i < c.count; ++i) {
        ContactPointConstraint& p = c.points[i];
        const CoreArm of_a = core_arm(a.motion, p.core_r_a);
        const CoreArm of_b = core_arm(b.motion, p.core_r_b);
        p.core_r_a = of_a.at_start;
        p.core_r_b = of_b.at_start;
        p.separation -= dot(of_b.moved - of_a.moved, c.normal);
    }
    carry_on(before, pass, c);
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
    scratch.sweeping.push_back(
        {static_cast<int>(scratch.contacts.size()) - 1, first_substep, scratch.contacts.back().normal});
}

void collide_sweeping(const Stores& stores, StepScratch& scratch, int substep, const ContactRules& rules,
                      float h_s) {
    for (const SweepingContact& sweeping : scratch.sweeping) {
        if (substep < sweeping.first_substep) continue;
        ContactConstraint& c = scratch.contacts[static_cast<std::size_t>(sweeping.contact)];
        collide_anew(stores, scratch.motions, rules, h_s, Pass::Biased, c);
        with_both(c, scratch.motions, [&] { warm_start_contact(c, scratch.motions, 1, 1); });
    }
}

void solve_sweeping(const Stores& stores, StepScratch& scratch, int substep, const ContactRules& rules,
                    float h_s, Pass pass) {
    Motions& motions = scratch.motions;
    for (const SweepingContact& sweeping : scratch.sweeping) {
        if (substep < sweeping.first_substep) continue;
        ContactConstraint& c = scratch.contacts[static_cast<std::size_t>(sweeping.contact)];
        if (pass == Pass::Relax) collide_anew(stores, motions, rules, h_s, pass, c);
        with_both(c, motions, [&] { solve_contact(c, motions, rules, h_s, pass); });
    }
}

void turn_arms_back(StepScratch& scratch, int substeps) {
    for (const SweepingContact& sweeping : scratch.sweeping) {
        if (sweeping.first_substep >= substeps) continue;
        ContactConstraint& c = scratch.contacts[static_cast<std::size_t>(sweeping.contact)];
        for (int i = 0; i < c.count; ++i) {
            ContactPointConstraint& p = c.points[i];
            p.r_a = inverse_rotate(scratch.motions.turned[static_cast<std::size_t>(c.a)], p.r_a);
            p.r_b = inverse_rotate(scratch.motions.turned[static_cast<std::size_t>(c.b)], p.r_b);
        }
    }
}

}  // namespace cairn::physics
