// Contacts that are reached in the course of a step.
#include "world/awaited_contacts.h"

#include <algorithm>

#include "integrator/integrate.h"
#include "world/bounce_energy.h"

namespace cairn::physics {
namespace {

// As the bodies are now; both points are moved to the middle between them.
ContactConstraint reached(const AwaitedContact& awaited, const Motions& motions, const ContactRules& rules) {
    ContactInput input = awaited.input;
    const Vec2 moved = motions.pose[input.b].d - motions.pose[input.a].d;
    for (int i = 0; i < input.count; ++i) {
        ContactInput::Point& p = input.points[i];
        const Vec2 gap = awaited.between + moved + p.r_b - p.r_a;
        p.r_a += 0.5f * gap;
        p.r_b -= 0.5f * gap;
        p.separation = 0;
        p.impulse = 0;
    }
    input.friction_impulse = 0;
    ContactConstraint c = make_contact(input, motions, rules);
    c.in_lane = false;
    for (ContactPointConstraint& p : c.points) {
        p.core_r_a = p.core_r_b = {};
        p.separation = -dot(moved, c.normal);  // such that they touch now
    }
    return c;
}

// Nothing carries it on: the bodies turn away from where they met.
void forget_impulses(ContactConstraint& c) {
    for (ContactPointConstraint& p : c.points) p.normal_impulse = 0;
    c.friction_impulse = 0;
    c.restitution = 0;  // was given
}

}  // namespace

void await_contact(const ContactInput& input, Vec2 between, const StepTime& time, StepScratch& scratch) {
    const int substep = std::min(static_cast<int>(input.reached_s / time.h_s), time.substeps - 1);
    scratch.awaited.push_back({static_cast<int>(scratch.contacts.size()) - 1, substep, input, between});
    scratch.contacts.back().in_lane = false;
}

void reach_contacts(StepScratch& scratch, int substep, const ContactRules& rules, const StepTime& time) {
    Motions& motions = scratch.motions;
    for (const AwaitedContact& awaited : scratch.awaited) {
        if (awaited.substep != substep) continue;
        ContactConstraint& c = scratch.contacts[static_cast<std::size_t>(awaited.contact)];
        c = reached(awaited, motions, rules);
        // Like what joints do, it is not taken for an impulse that contacts give in each substep.
        for (const int row : {c.a, c.b}) begin_joints(motions, row, row + 1);
        const std::array came_with{motions.velocity[static_cast<std::size_t>(c.a)],
                                   motions.velocity[static_cast<std::size_t>(c.b)]};
        solve_contact(c, motions, rules, time.h_s, Pass::Relax);
        give_back_speed(c, came_with, scratch, rules);
        for (const int row : {c.a, c.b}) end_joints(motions, row, row + 1);
        forget_impulses(c);
    }
}

}  // namespace cairn::physics
