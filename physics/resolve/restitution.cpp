// Impacts give back a share of their speed, once per step and after its last substep.
#include <algorithm>
#include <cmath>

#include "resolve/contact_points.h"

namespace cairn::physics {
namespace {

// The speed to leave with. Steps do not end where surfaces meet, so both the closing speed (known at
// separation s0) and the leaving speed (given at s) are carried to s = 0 along the acceleration g of the
// pair:
//     impact^2 = Jv0^2 - 2 g s0,    leave^2 = (e impact)^2 + 2 g s
// Without this a bounce gains or loses height by where in the step it falls.
float leaving_speed(const ContactConstraint& c, const ContactPointConstraint& p,
                    std::span<const Drive> drives) {
    const float g = dot(drives[c.b].acceleration - drives[c.a].acceleration, c.normal);
    const float impact_squared =
        std::max(p.closing_velocity * p.closing_velocity - 2 * g * p.separation, 0.0f);
    return std::sqrt(
        std::max(c.restitution * c.restitution * impact_squared + 2 * g * p.end_separation, 0.0f));
}

}  // namespace

void apply_restitution(std::span<ContactConstraint> contacts, Motions& motions, std::span<const Drive> drives,
                       const ContactRules& rules) {
    for (ContactConstraint& c : contacts) {
        if (c.restitution == 0) continue;
        Motion a = motions.get(c.a);
        Motion b = motions.get(c.b);
        // Points that did not meet fast keep the velocity that they have.
        std::array<float, 2> targets{};
        std::array<float, 2> before{};
        bool bounces = false;
        for (int i = 0; i < c.count; ++i) {
            const ContactPointConstraint& p = c.points[i];
            const bool met = met_fast(p, rules);
            targets[i] = met ? leaving_speed(c, p, drives) : normal_velocity(c, p, a, b);
            before[i] = p.normal_impulse;
            bounces |= met;
        }
        if (!bounces) continue;
        reach_targets(c, a, b, targets);
        for (int i = 0; i < c.count; ++i) {
            c.points[i].total_normal_impulse += c.points[i].normal_impulse - before[i];
        }
        motions.set(c.a, a);
        motions.set(c.b, b);
    }
}

}  // namespace cairn::physics
