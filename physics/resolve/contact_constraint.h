// Contacts as the solver sees them: non-penetration with a soft push-out, Coulomb friction, restitution.
// This is the scalar form, in which arms turn with their bodies; contact_blocks.h packs what it can into SIMD
// lanes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "base/motion.h"
#include "resolve/soft.h"

namespace cairn::physics {

/// A contact as collision found it, for the solver to take in.
struct ContactInput {
    struct Point {
        Vec2 r_a;  // from the centres of mass to the point, in world axes
        Vec2 r_b;
        float separation;
        std::int32_t feature;
        float impulse;  // of the last substep, as the first guess
    };
    int a;  // rows
    int b;
    int contact;  // the caller's number
    Vec2 normal;  // unit, from a to b
    int count;
    std::array<Point, 2> points;
    float friction;
    float restitution;
    float friction_impulse;
    float radius_a;  // by which the shapes are rounded
    float radius_b;
    float rolling_m = 0;          // torque that resists rolling, per normal force
    float surface_speed_m_s = 0;  // of b past a along the tangent, which friction brings about
    float unit = 1;               // of lengths (world/tiny_contacts.h)
    float reached_s = 0;          // of what is predicted: when in the step the two meet
};

/// m/s. A new contact that closes slower than this is one of things put down, not of an impact.
inline constexpr float kRestSpeed_m_s = 0.5f;

/// Of contacts that are collided anew in each substep (world/sweeping_contacts.h) arms are those of now, and
/// the closing velocity is the fastest so far.
struct ContactPointConstraint {
    Vec2 r_a;  // from the centres of mass to the point, in world axes, at the start of the step
    Vec2 r_b;
    Vec2 core_r_a;  // the same, to the points of the cores which the surfaces round off
    Vec2 core_r_b;
    float separation = 0;            // m, at the start of the step
    float end_separation = 0;        // m, at the end of the last substep
    float closing_velocity = 0;      // m/s, Jv at the start of the step (negative: approaching)
    float static_impulse = 0;        // N s, the estimate for rest
    float normal_impulse = 0;        // of one substep, N s
    float total_normal_impulse = 0;  // of the whole step, N s
    float normal_mass = 0;
    std::int32_t feature = 0;
};

struct ContactConstraint {
    int a = 0;  // rows
    int b = 0;
    int contact = 0;      // where the impulses go back to
    bool in_lane = true;  // solved there; this form serves restitution and events
    Vec2 normal;          // unit, from a to b
    float friction = 0;
    float restitution = 0;
    float unit = 1;       // of lengths
    float reached_s = 0;  // as in ContactInput
    Softness softness;
    int count = 0;
    std::array<ContactPointConstraint, 2> points{};
    // One friction row midway between the points: on the line of a manifold all points have the same
    // tangential arm.
    Vec2 friction_r_a;
    Vec2 friction_r_b;
    float tangent_mass = 0;
    float friction_impulse = 0;
    float surface_speed_m_s = 0;
    // One row against rolling, which starts from 0 in each step.
    float rolling_m = 0;
    float rolling_mass = 0;
    float rolling_impulse = 0;
};

/// A contact is soft about its static estimate, but about no more than this times what it bore last, so that
/// an estimate that is wrong cannot push. Less than 1.03 loses stacks to noise; without a bound heaps jitter.
inline constexpr float kStaticsTrust = 1.1f;

/// What all contacts of a step share.
struct ContactRules {
    Softness dynamic_softness;
    Softness static_softness;
    float max_push_out_speed_m_s = 0;
    float restitution_speed_m_s = 0;

    bool operator==(const ContactRules&) const = default;
};

ContactRules make_contact_rules(float h_s, float max_push_out_speed_m_s, float restitution_speed_m_s);

/// With what follows from the geometry: effective masses, softness, closing velocities.
ContactConstraint make_contact(const ContactInput& input, const Motions& motions, const ContactRules& rules);

/// The impulse of a point of which nothing is known yet but that it is closed and at rest: its static
/// estimate will stand for it.
inline constexpr float kUnknownImpulse = -1;

/// Impulses grow with the substep, but not beyond what the contact would bear at rest: their noise would grow
/// too.
inline float first_guess(float remembered, float static_impulse, float step_ratio) {
    if (remembered < 0) return static_impulse;
    return std::min(step_ratio * remembered, std::max(remembered, static_impulse));
}

/// Makes the first guess of a step and applies it.
void warm_start_contact(ContactConstraint& c, Motions& motions, float step_ratio, float friction_ratio);

/// Of a point whose bodies have moved since the start of the step, m.
float separation_now(const ContactConstraint& c, const ContactPointConstraint& p, const Motions& motions);

void solve_contact(ContactConstraint& c, Motions& motions, const ContactRules& rules, float h_s, Pass pass);

/// Gives the closing velocity of the impact back, times the restitution. Once, after the last substep.
void apply_restitution(std::span<ContactConstraint> contacts, Motions& motions, std::span<const Drive> drives,
                       const ContactRules& rules);

}  // namespace cairn::physics
