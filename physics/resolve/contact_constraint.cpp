// Sequential impulses on contacts. Glossary: v, w velocities of a body; r from its centre of mass to the
// point; n, t normal and tangent; s separation; lambda impulse; K inverse effective mass.
//     Jv = n . (vB + wB x rB - vA - wA x rA),   K = 1/mA + 1/mB + (rA x n)^2/IA + (rB x n)^2/IB
// Source: Catto, "Iterative Dynamics with Temporal Coherence", 2005; soft push-out as in soft.h.
#include "resolve/contact_constraint.h"

#include <algorithm>

#include <cairn/physics/tuning.h>

namespace cairn::physics {
namespace {

Vec2 velocity_at(const Motion& body, Vec2 r) {
    return body.v + cross(body.w, r);
}

Vec2 relative_velocity(const Motion& a, const Motion& b, const ContactPointConstraint& p) {
    return velocity_at(b, p.r_b) - velocity_at(a, p.r_a);
}

void apply(Motion& a, Motion& b, const ContactPointConstraint& p, Vec2 impulse) {
    a.v -= a.inverse_mass * impulse;
    a.w -= a.inverse_inertia * cross(p.r_a, impulse);
    b.v += b.inverse_mass * impulse;
    b.w += b.inverse_inertia * cross(p.r_b, impulse);
}

float effective_mass(const Motion& a, const Motion& b, const ContactPointConstraint& p, Vec2 axis) {
    const float ra = cross(p.r_a, axis);
    const float rb = cross(p.r_b, axis);
    const float k =
        a.inverse_mass + b.inverse_mass + a.inverse_inertia * ra * ra + b.inverse_inertia * rb * rb;
    return k > 0 ? 1 / k : 0;
}

void solve_normal(ContactConstraint& c, ContactPointConstraint& p, Motion& a, Motion& b,
                  const ContactRules& rules, float h_s, Pass pass) {
    const float s = current_separation(a, b, p, c.normal);
    float bias = 0;
    Softness soft = kRigid;
    if (s > 0) {
        bias = s / h_s;  // speculative: may close the gap, but no more
    } else if (pass == Pass::Biased) {
        bias = std::max(c.softness.bias_rate * s, -rules.max_push_out_speed_m_s);
        soft = c.softness;
    }
    const float jv = dot(relative_velocity(a, b, p), c.normal);
    const float wanted = p.normal_impulse - p.normal_mass * soft.mass_scale * (jv + bias) -
                         soft.impulse_scale * p.normal_impulse;
    const float impulse = std::max(wanted, 0.0f);
    const float change = impulse - p.normal_impulse;
    p.normal_impulse = impulse;
    p.largest_normal_impulse = std::max(p.largest_normal_impulse, impulse);
    apply(a, b, p, change * c.normal);
}

void solve_friction(ContactConstraint& c, ContactPointConstraint& p, Motion& a, Motion& b) {
    const Vec2 tangent = right_perp(c.normal);
    const float jv = dot(relative_velocity(a, b, p), tangent);
    const float limit = c.friction * p.normal_impulse;
    const float impulse = std::clamp(p.tangent_impulse - p.tangent_mass * jv, -limit, limit);
    const float change = impulse - p.tangent_impulse;
    p.tangent_impulse = impulse;
    apply(a, b, p, change * tangent);
}

// The speed to leave with. Steps do not end where surfaces meet, so both the closing speed (known at
// separation s0) and the leaving speed (given at s) are carried to s = 0 along the acceleration g of the
// pair:
//     impact^2 = Jv0^2 - 2 g s0,    leave^2 = (e impact)^2 + 2 g s
// Without this a bounce gains or loses height by where in the step it falls.
float leaving_speed(const ContactConstraint& c, const ContactPointConstraint& p, float separation,
                    std::span<const Drive> drives) {
    const float g = dot(drives[c.b].acceleration - drives[c.a].acceleration, c.normal);
    const float impact_squared =
        std::max(p.closing_velocity * p.closing_velocity - 2 * g * p.separation, 0.0f);
    return std::sqrt(std::max(c.restitution * c.restitution * impact_squared + 2 * g * separation, 0.0f));
}

}  // namespace

ContactRules make_contact_rules(float h_s, float max_push_out_speed_m_s, float restitution_speed_m_s) {
    const float frequency = std::min(tuning::kContactFrequency_hz, tuning::kMaxFrequencyShare / h_s);
    return {make_soft(frequency, tuning::kContactDampingRatio, h_s),
            make_soft(tuning::kStaticContactStiffening * frequency, tuning::kContactDampingRatio, h_s),
            max_push_out_speed_m_s, restitution_speed_m_s};
}

float current_separation(const Motion& a, const Motion& b, const ContactPointConstraint& p, Vec2 normal) {
    const Vec2 moved_a = a.dp + rotate(a.dq, p.r_a) - p.r_a;
    const Vec2 moved_b = b.dp + rotate(b.dq, p.r_b) - p.r_b;
    return p.separation + dot(moved_b - moved_a, normal);
}

void prepare_contact(ContactConstraint& c, std::span<const Motion> motions, const ContactRules& rules) {
    const Motion& a = motions[c.a];
    const Motion& b = motions[c.b];
    c.softness = a.inverse_mass == 0 || b.inverse_mass == 0 ? rules.static_softness : rules.dynamic_softness;
    for (int i = 0; i < c.count; ++i) {
        ContactPointConstraint& p = c.points[i];
        p.normal_mass = effective_mass(a, b, p, c.normal);
        p.tangent_mass = effective_mass(a, b, p, right_perp(c.normal));
        p.closing_velocity = dot(relative_velocity(a, b, p), c.normal);
    }
}

void warm_start_contacts(std::span<const ContactConstraint> contacts, std::span<Motion> motions) {
    for (const ContactConstraint& c : contacts) {
        const Vec2 tangent = right_perp(c.normal);
        for (int i = 0; i < c.count; ++i) {
            const ContactPointConstraint& p = c.points[i];
            apply(motions[c.a], motions[c.b], p, p.normal_impulse * c.normal + p.tangent_impulse * tangent);
        }
    }
}

void solve_contacts(std::span<ContactConstraint> contacts, std::span<Motion> motions,
                    const ContactRules& rules, float h_s, Pass pass) {
    for (ContactConstraint& c : contacts) {
        Motion& a = motions[c.a];
        Motion& b = motions[c.b];
        // Normals first, so that friction is limited by their fresh impulses.
        for (int i = 0; i < c.count; ++i) solve_normal(c, c.points[i], a, b, rules, h_s, pass);
        for (int i = 0; i < c.count; ++i) solve_friction(c, c.points[i], a, b);
        if (pass == Pass::Relax) {
            for (int i = 0; i < c.count; ++i) c.points[i].total_normal_impulse += c.points[i].normal_impulse;
        }
    }
}

void apply_restitution(std::span<ContactConstraint> contacts, std::span<Motion> motions,
                       std::span<const Drive> drives, const ContactRules& rules) {
    for (ContactConstraint& c : contacts) {
        if (c.restitution == 0) continue;
        Motion& a = motions[c.a];
        Motion& b = motions[c.b];
        for (int i = 0; i < c.count; ++i) {
            ContactPointConstraint& p = c.points[i];
            if (p.closing_velocity > -rules.restitution_speed_m_s || p.largest_normal_impulse == 0) continue;
            const float jv = dot(relative_velocity(a, b, p), c.normal);
            const float speed = leaving_speed(c, p, current_separation(a, b, p, c.normal), drives);
            const float wanted = p.normal_impulse - p.normal_mass * (jv - speed);
            const float impulse = std::max(wanted, 0.0f);
            const float change = impulse - p.normal_impulse;
            p.normal_impulse = impulse;
            p.total_normal_impulse += change;
            p.largest_normal_impulse = std::max(p.largest_normal_impulse, impulse);
            apply(a, b, p, change * c.normal);
        }
    }
}

}  // namespace cairn::physics
