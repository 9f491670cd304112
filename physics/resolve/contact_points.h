// What the parts of the scalar contact solver share: speeds and impulses at the points of one contact.
#pragma once

#include "resolve/contact_constraint.h"

namespace cairn::physics {

inline Vec2 velocity_at(const Motion& body, Vec2 r) {
    return body.v + cross(body.w, r);
}

inline Vec2 relative_velocity(const Motion& a, const Motion& b, Vec2 r_a, Vec2 r_b) {
    return velocity_at(b, r_b) - velocity_at(a, r_a);
}

/// Of b from a, along the normal at the point.
inline float normal_velocity(const ContactConstraint& c, const ContactPointConstraint& p, const Motion& a,
                             const Motion& b) {
    return dot(relative_velocity(a, b, p.r_a, p.r_b), c.normal);
}

inline float total_normal(const ContactConstraint& c) {
    float sum = 0;
    for (int i = 0; i < c.count; ++i) sum += c.points[i].normal_impulse;
    return sum;
}

/// Whether the surfaces met there within the step, at a speed at which they bounce.
inline bool met_fast(const ContactPointConstraint& p, const ContactRules& rules) {
    return p.closing_velocity <= -rules.restitution_speed_m_s && p.total_normal_impulse > 0;
}

/// Brings the points to their target velocities: both at once, since sweeping leaves a part.
void reach_targets(ContactConstraint& c, Motion& a, Motion& b, const std::array<float, 2>& targets);

/// Coulomb's law for turning: |lambda| <= rolling_m lambda_n against wB - wA.
void solve_rolling(ContactConstraint& c, Motion& a, Motion& b);

}  // namespace cairn::physics
