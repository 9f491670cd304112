// Contacts as the solver sees them: non-penetration with a soft push-out, Coulomb friction, restitution.
#pragma once

#include <array>
#include <span>

#include "base/motion.h"
#include "resolve/soft.h"

namespace cairn::physics {

struct ContactPointConstraint {
    Vec2 r_a;  // from the centres of mass to the point, in world axes, at the start of the step
    Vec2 r_b;
    float separation = 0;        // m, at the start of the step
    float closing_velocity = 0;  // m/s, Jv at the start of the step (negative: approaching)
    float normal_impulse = 0;    // of one substep, N s
    float tangent_impulse = 0;
    float total_normal_impulse = 0;  // of the whole step, N s
    float largest_normal_impulse = 0;
    float normal_mass = 0;
    float tangent_mass = 0;
};

struct ContactConstraint {
    int a = 0;  // motions
    int b = 0;
    int contact = 0;  // where the impulses go back to
    Vec2 normal;      // unit, from a to b
    float friction = 0;
    float restitution = 0;
    Softness softness;
    int count = 0;
    std::array<ContactPointConstraint, 2> points{};
};

/// What all contacts of a step share.
struct ContactRules {
    Softness dynamic_softness;
    Softness static_softness;
    float max_push_out_speed_m_s = 0;
    float restitution_speed_m_s = 0;
};

ContactRules make_contact_rules(float h_s, float max_push_out_speed_m_s, float restitution_speed_m_s);

/// Fills in what follows from the geometry: effective masses, softness, closing velocities.
void prepare_contact(ContactConstraint& c, std::span<const Motion> motions, const ContactRules& rules);

/// How far apart the point is now: linear in the bodies' motion since the start of the step.
float current_separation(const Motion& a, const Motion& b, const ContactPointConstraint& p, Vec2 normal);

/// Applies the impulses of the previous substep, as a first guess.
void warm_start_contacts(std::span<const ContactConstraint> contacts, std::span<Motion> motions);

void solve_contacts(std::span<ContactConstraint> contacts, std::span<Motion> motions,
                    const ContactRules& rules, float h_s, Pass pass);

/// Gives the closing velocity of the impact back, times the restitution. Once, after the last substep.
void apply_restitution(std::span<ContactConstraint> contacts, std::span<Motion> motions,
                       std::span<const Drive> drives, const ContactRules& rules);

}  // namespace cairn::physics
