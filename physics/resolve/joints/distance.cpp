// The distance joint. Glossary: d offset of the anchors, u = d/|d|.
//     C = |d| - L,    Jv = u . (vB + wB x rB - vA - wA x rA),    K = 1/mA + 1/mB + (rA x u)^2/IA + (rB x
//     u)^2/IB
// Source: Catto, "Modeling and Solving Constraints", GDC 2009.
#include "resolve/joints/distance.h"

#include <algorithm>

namespace cairn::physics {
namespace {

struct Line {
    AnchorsNow at;
    Vec2 u;
    float length = 0;
    float mass = 0;  // effective, along u
};

// Anchors that coincide have no direction; the one of the start of the step serves then.
Line line_now(const DistanceConstraint& c, const Motion& a, const Motion& b) {
    Line line{anchors_now(c.anchors, a, b), {}, 0, 0};
    line.length = length(line.at.offset);
    line.u = line.length > 1e-6f ? (1 / line.length) * line.at.offset : c.axis;
    // From the arms as they are now: a mass kept from the start of the step is too large by up to r^2/I m
    // when an arm has turned across the line since, and the impulses then explode.
    const float ra = cross(line.at.r_a, line.u);
    const float rb = cross(line.at.r_b, line.u);
    const float k = inverse_mass_along(a, line.u) + inverse_mass_along(b, line.u) +
                    a.inverse_inertia * ra * ra + b.inverse_inertia * rb * rb;
    line.mass = effective_mass(a, b, k);
    return line;
}

float rate(const Line& line, const Motion& a, const Motion& b) {
    return dot(relative_velocity(line.at, a, b), line.u);
}

float soft_impulse(float mass, float accumulated, float jv, float error_m, const Softness& soft) {
    return accumulated - mass * soft.mass_scale * (jv + soft.bias_rate * error_m) -
           soft.impulse_scale * accumulated;
}

// Rope (slack is how much is left) and stop alike: a gap may close, but no more.
float limit_impulse(const Line& line, const Softness& softness, float accumulated, float slack_m,
                    float closing, float h_s, Pass pass) {
    if (slack_m > 0) return std::max(accumulated - line.mass * (closing + slack_m / h_s), 0.0f);
    const Softness& soft = pass == Pass::Biased ? softness : kRigid;
    return std::max(soft_impulse(line.mass, accumulated, closing, slack_m, soft), 0.0f);
}

}  // namespace

void prepare_distance(DistanceConstraint& c) {
    const Vec2 offset = c.anchors.center_offset + (c.anchors.r_b - c.anchors.r_a);
    c.axis = length(offset) > 1e-6f ? normalized(offset) : Vec2{0, 1};
    if (!c.limit) c.lower_impulse = c.upper_impulse = 0;
}

void warm_start_distance(const DistanceConstraint& c, Motions& motions) {
    Motion a = motions.get(c.anchors.a);
    Motion b = motions.get(c.anchors.b);
    const Line line = line_now(c, a, b);
    apply_impulse(line.at, a, b, (c.impulse + c.lower_impulse - c.upper_impulse) * line.u);
    motions.set_by_joint(c.anchors.a, a);
    motions.set_by_joint(c.anchors.b, b);
}

void solve_distance(DistanceConstraint& c, Motions& motions, float h_s, Pass pass) {
    Motion a = motions.get(c.anchors.a);
    Motion b = motions.get(c.anchors.b);
    const Line line = line_now(c, a, b);
    const auto add = [&](float& accumulated, float impulse, float sign) {
        apply_impulse(line.at, a, b, sign * (impulse - accumulated) * line.u);
        accumulated = impulse;
    };

    if (!c.spring) {
        const Softness& soft = pass == Pass::Biased ? c.softness : kRigid;
        add(c.impulse, soft_impulse(line.mass, c.impulse, rate(line, a, b), line.length - c.length_m, soft),
            1);
    } else if (pass == Pass::Biased) {
        // Relaxing a spring would take its force out again: that is the damping nobody asked for.
        add(c.impulse,
            soft_impulse(line.mass, c.impulse, rate(line, a, b), line.length - c.length_m, c.spring_softness),
            1);
    }
    if (c.limit) {
        add(c.lower_impulse,
            limit_impulse(line, c.softness, c.lower_impulse, line.length - c.min_length_m, rate(line, a, b),
                          h_s, pass),
            1);
        add(c.upper_impulse,
            limit_impulse(line, c.softness, c.upper_impulse, c.max_length_m - line.length, -rate(line, a, b),
                          h_s, pass),
            -1);
    }
    motions.set_by_joint(c.anchors.a, a);
    motions.set_by_joint(c.anchors.b, b);
}

}  // namespace cairn::physics
