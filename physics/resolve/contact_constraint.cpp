// Sequential impulses on contacts. Glossary: v, w velocities of a body; r from its centre of mass to the
// point; n, t normal and tangent; s separation; lambda impulse; K inverse effective mass.
//     Jv = n . (vB + wB x rB - vA - wA x rA),   K = 1/mA + 1/mB + (rA x n)^2/IA + (rB x n)^2/IB
// Source: Catto, "Iterative Dynamics with Temporal Coherence", 2005; soft push-out as in soft.h.
#include "resolve/contact_constraint.h"

#include <algorithm>
#include <optional>

#include <cairn/physics/tuning.h>

#include "resolve/contact_points.h"

namespace cairn::physics {
namespace {

void apply(Motion& a, Motion& b, Vec2 r_a, Vec2 r_b, Vec2 impulse) {
    a.v -= velocity_change(a, impulse);
    a.w -= a.inverse_inertia * cross(r_a, impulse);
    b.v += velocity_change(b, impulse);
    b.w += b.inverse_inertia * cross(r_b, impulse);
}

float effective_mass(const Motion& a, const Motion& b, Vec2 r_a, Vec2 r_b, Vec2 axis) {
    const float ra = cross(r_a, axis);
    const float rb = cross(r_b, axis);
    const float k = inverse_mass_along(a, axis) + inverse_mass_along(b, axis) + a.inverse_inertia * ra * ra +
                    b.inverse_inertia * rb * rb;
    return effective_mass(a, b, k);
}

// The arms to the cores turn with the bodies; a rounded surface does not: turning its arm would lift a
// rolling wheel.
float current_separation(const Motion& a, const Motion& b, const ContactPointConstraint& p, Vec2 normal) {
    const Vec2 moved_a = a.dp + rotate(a.dq, p.core_r_a) - p.core_r_a;
    const Vec2 moved_b = b.dp + rotate(b.dq, p.core_r_b) - p.core_r_b;
    return p.separation + dot(moved_b - moved_a, normal);
}

void set_impulse(ContactConstraint& c, ContactPointConstraint& p, Motion& a, Motion& b, float impulse) {
    apply(a, b, p.r_a, p.r_b, (impulse - p.normal_impulse) * c.normal);
    p.normal_impulse = impulse;
}

// The impulse about which the point is soft.
float base_of(const ContactPointConstraint& p) {
    return std::min(p.static_impulse, kStaticsTrust * p.normal_impulse);
}

// A loaded point that opens by less than can be seen stays soft: a hard stop there would ratchet.
bool is_apart(const ContactConstraint& c, float separation, float base_impulse) {
    return separation > (base_impulse > 0 ? c.unit * tuning::kLinearSlop_m : 0);
}

// What a normal row is to come to: Jv + bias + give (impulse - base) = 0, or more than 0 without impulse,
// where give = K impulse_scale / mass_scale.
struct NormalRow {
    float bias = 0;
    float mass_scale = 1;
    float impulse_scale = 0;
    float base = 0;
};

struct Impulses {
    float first;
    float second;
};

// Two points, each of which may push but not pull: the impulses x >= 0 with K x + r >= 0 and x . (K x + r) =
// 0, r being what the rows miss without them, and K with what they give. There are four cases: both push,
// either, none.
std::optional<Impulses> solve_both(const ContactConstraint& c, const Motion& a, const Motion& b,
                                   const std::array<NormalRow, 2>& rows) {
    const ContactPointConstraint& p = c.points[0];
    const ContactPointConstraint& q = c.points[1];
    const float k00 = 1 / p.normal_mass;
    const float k11 = 1 / q.normal_mass;
    const float k01 = inverse_mass_along(a, c.normal) + inverse_mass_along(b, c.normal) +
                      a.inverse_inertia * cross(p.r_a, c.normal) * cross(q.r_a, c.normal) +
                      b.inverse_inertia * cross(p.r_b, c.normal) * cross(q.r_b, c.normal);
    if (!(k00 * k11 - k01 * k01 > 1e-3f * k00 * k11)) return {};  // too near each other to be told apart
    const float soft00 = k00 / rows[0].mass_scale;                // K + give, since the scales add up to 1
    const float soft11 = k11 / rows[1].mass_scale;
    const float r0 = normal_velocity(c, p, a, b) + rows[0].bias - (soft00 - k00) * rows[0].base -
                     (k00 * p.normal_impulse + k01 * q.normal_impulse);
    const float r1 = normal_velocity(c, q, a, b) + rows[1].bias - (soft11 - k11) * rows[1].base -
                     (k01 * p.normal_impulse + k11 * q.normal_impulse);
    const float determinant = soft00 * soft11 - k01 * k01;
    const Impulses both{(k01 * r1 - soft11 * r0) / determinant, (k01 * r0 - soft00 * r1) / determinant};
    if (both.first >= 0 && both.second >= 0) return both;
    const float first = -r0 / soft00;
    if (first >= 0 && k01 * first + r1 >= 0) return Impulses{first, 0};
    const float second = -r1 / soft11;
    if (second >= 0 && k01 * second + r0 >= 0) return Impulses{0, second};
    return Impulses{0, 0};
}

void sweep_rows(ContactConstraint& c, Motion& a, Motion& b, const std::array<NormalRow, 2>& rows) {
    for (int i = 0; i < c.count; ++i) {
        ContactPointConstraint& p = c.points[i];
        const NormalRow& row = rows[i];
        const float wanted = p.normal_impulse -
                             p.normal_mass * row.mass_scale * (normal_velocity(c, p, a, b) + row.bias) -
                             row.impulse_scale * (p.normal_impulse - row.base);
        set_impulse(c, p, a, b, std::max(wanted, 0.0f));
    }
}

// Both points at once, if they can be told apart. One after the other, what lands flat would turn about the
// first within the substep.
void solve_rows(ContactConstraint& c, Motion& a, Motion& b, const std::array<NormalRow, 2>& rows) {
    const auto both = c.count == 2 ? solve_both(c, a, b, rows) : std::nullopt;
    if (!both) return sweep_rows(c, a, b, rows);
    set_impulse(c, c.points[0], a, b, both->first);
    set_impulse(c, c.points[1], a, b, both->second);
}

// Non-penetration with a soft push-out.
void solve_biased(ContactConstraint& c, Motion& a, Motion& b, const ContactRules& rules, float h_s) {
    std::array<NormalRow, 2> rows;
    for (int i = 0; i < c.count; ++i) {
        ContactPointConstraint& p = c.points[i];
        const float s = current_separation(a, b, p, c.normal);
        p.end_separation = s;
        const float base = base_of(p);
        // A gap may close, but no more; an overlap is pushed out.
        if (is_apart(c, s, base)) {
            rows[i].bias = s / h_s;
        } else {
            const float bias = std::max(c.softness.bias_rate * s, -rules.max_push_out_speed_m_s);
            rows[i] = {bias, c.softness.mass_scale, c.softness.impulse_scale, base};
        }
    }
    solve_rows(c, a, b, rows);
}

// Of joints that are solved directly, before contacts and after them. What it did to the bodies in the
// meantime (mend its joints, take energy back) is not in the impulses of contacts: what these gave in the
// last step, or in this substep, may be far more than what is there to be stopped, and to be let go.
bool touches_structure(const ContactConstraint& c, const Motions& motions) {
    return motions.mover[c.a] == MovedBy::Direct || motions.mover[c.b] == MovedBy::Direct;
}

// Gaps may close within the substep, but no more; what touches comes to rest.
std::array<float, 2> relaxed_targets(ContactConstraint& c, const Motion& a, const Motion& b, float h_s,
                                     bool of_structure) {
    std::array<float, 2> targets{};
    for (int i = 0; i < c.count; ++i) {
        ContactPointConstraint& p = c.points[i];
        p.end_separation = current_separation(a, b, p, c.normal);
        targets[i] = is_apart(c, p.end_separation, base_of(p)) ? -p.end_separation / h_s : 0;
        if (of_structure && targets[i] < 0)
            targets[i] = std::clamp(normal_velocity(c, p, a, b), targets[i], 0.0f);
    }
    return targets;
}

void solve_friction(ContactConstraint& c, Motion& a, Motion& b) {
    const Vec2 tangent = right_perp(c.normal);
    const float jv =
        dot(relative_velocity(a, b, c.friction_r_a, c.friction_r_b), tangent) - c.surface_speed_m_s;
    const float limit = c.friction * total_normal(c);
    const float impulse = std::clamp(c.friction_impulse - c.tangent_mass * jv, -limit, limit);
    const float change = impulse - c.friction_impulse;
    c.friction_impulse = impulse;
    apply(a, b, c.friction_r_a, c.friction_r_b, change * tangent);
}

}  // namespace

void reach_targets(ContactConstraint& c, Motion& a, Motion& b, const std::array<float, 2>& targets) {
    solve_rows(c, a, b, {NormalRow{.bias = -targets[0]}, NormalRow{.bias = -targets[1]}});
}

float separation_now(const ContactConstraint& c, const ContactPointConstraint& p, const Motions& motions) {
    return current_separation(motions.get(c.a), motions.get(c.b), p, c.normal);
}

ContactRules make_contact_rules(float h_s, float max_push_out_speed_m_s, float restitution_speed_m_s) {
    const float frequency = std::min(tuning::kContactFrequency_hz, tuning::kMaxFrequencyShare / h_s);
    return {make_soft(frequency, tuning::kContactDampingRatio, h_s),
            make_soft(tuning::kStaticContactStiffening * frequency, tuning::kContactDampingRatio, h_s),
            max_push_out_speed_m_s, restitution_speed_m_s};
}

ContactConstraint make_contact(const ContactInput& input, const Motions& motions, const ContactRules& rules) {
    ContactConstraint c;
    c.a = input.a;
    c.b = input.b;
    c.contact = input.contact;
    c.normal = input.normal;
    c.friction = input.friction;
    c.restitution = input.restitution;
    c.unit = input.unit;
    c.reached_s = input.reached_s;
    c.friction_impulse = input.friction_impulse;
    c.surface_speed_m_s = input.surface_speed_m_s;
    c.rolling_m = input.rolling_m;
    c.count = input.count;
    for (int i = 0; i < c.count; ++i) {
        c.points[i].r_a = input.points[i].r_a;
        c.points[i].r_b = input.points[i].r_b;
        // The point lies midway between the surfaces.
        const float half_gap = 0.5f * input.points[i].separation;
        c.points[i].core_r_a = input.points[i].r_a - (half_gap + input.radius_a) * input.normal;
        c.points[i].core_r_b = input.points[i].r_b + (half_gap + input.radius_b) * input.normal;
        c.points[i].separation = input.points[i].separation;
        c.points[i].normal_impulse = input.points[i].impulse;
        c.points[i].feature = input.points[i].feature;
    }
    const Motion a = motions.get(c.a);
    const Motion b = motions.get(c.b);
    c.softness = a.inverse_mass == 0 || b.inverse_mass == 0 ? rules.static_softness : rules.dynamic_softness;
    c.friction_r_a = c.points[0].r_a;
    c.friction_r_b = c.points[0].r_b;
    if (c.count == 2) {
        c.friction_r_a = 0.5f * (c.friction_r_a + c.points[1].r_a);
        c.friction_r_b = 0.5f * (c.friction_r_b + c.points[1].r_b);
    }
    c.tangent_mass = effective_mass(a, b, c.friction_r_a, c.friction_r_b, right_perp(c.normal));
    const float turning = a.inverse_inertia + b.inverse_inertia;
    c.rolling_mass = turning > 0 ? 1 / turning : 0;
    for (int i = 0; i < c.count; ++i) {
        ContactPointConstraint& p = c.points[i];
        p.normal_mass = effective_mass(a, b, p.r_a, p.r_b, c.normal);
        p.closing_velocity = dot(relative_velocity(a, b, p.r_a, p.r_b), c.normal);
        p.end_separation = p.separation;
    }
    return c;
}

void warm_start_contact(ContactConstraint& c, Motions& motions, float step_ratio, float friction_ratio) {
    Motion a = motions.get(c.a);
    Motion b = motions.get(c.b);
    c.friction_impulse *= friction_ratio;
    const bool of_structure = touches_structure(c, motions);
    for (int i = 0; i < c.count; ++i) {
        ContactPointConstraint& p = c.points[i];
        p.normal_impulse = first_guess(p.normal_impulse, p.static_impulse, step_ratio);
        if (of_structure) {
            const float stopping = p.normal_mass * std::max(0.0f, -normal_velocity(c, p, a, b));
            p.normal_impulse = std::min(p.normal_impulse, p.static_impulse + stopping);
        }
        apply(a, b, c.points[i].r_a, c.points[i].r_b, c.points[i].normal_impulse * c.normal);
    }
    if (of_structure) {
        const float limit = c.friction * total_normal(c);
        c.friction_impulse = std::clamp(c.friction_impulse, -limit, limit);
    }
    apply(a, b, c.friction_r_a, c.friction_r_b, c.friction_impulse * right_perp(c.normal));
    motions.set(c.a, a);
    motions.set(c.b, b);
}

void solve_contact(ContactConstraint& c, Motions& motions, const ContactRules& rules, float h_s, Pass pass) {
    Motion a = motions.get(c.a);
    Motion b = motions.get(c.b);
    if (pass == Pass::Relax) {
        const std::array<float, 2> targets = relaxed_targets(c, a, b, h_s, touches_structure(c, motions));
        reach_targets(c, a, b, targets);
        solve_rolling(c, a, b);
        solve_friction(c, a, b);
        // Again, since friction turns the bodies and what comes last is satisfied best.
        reach_targets(c, a, b, targets);
        for (int i = 0; i < c.count; ++i) c.points[i].total_normal_impulse += c.points[i].normal_impulse;
    } else {
        // Normals first, so that friction is limited by their fresh impulses.
        solve_biased(c, a, b, rules, h_s);
        solve_rolling(c, a, b);
        solve_friction(c, a, b);
    }
    motions.set(c.a, a);
    motions.set(c.b, b);
}

}  // namespace cairn::physics
