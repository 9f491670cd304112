// The revolute joint. Glossary: d offset of the anchors; r centre of mass to anchor; K the 2 x 2 inverse
// effective mass.
//     C  = xB + rB - xA - rA = d,    JvB = vB + wB x rB - vA - wA x rA
//     K  = (1/mA + 1/mB) E + sum over both bodies of 1/I [ ry^2, -rx ry; -rx ry, rx^2 ]
// Motor and limits act on the relative angle, whose effective mass is 1/(1/IA + 1/IB).
// Source: Catto, "Modeling and Solving Constraints", GDC 2009.
#include "resolve/joints/revolute.h"

#include <algorithm>

namespace cairn::physics {
namespace {

// Solves K x = b by Cramer's rule. When locked axes leave, but for a trifle, one direction to move in, K is
// s u u^T with the trace s, and the smallest x is K b / s^2; when they leave none it is 0.
Vec2 solve_point(const Motion& a, const Motion& b, const AnchorsNow& at, Vec2 rhs) {
    const Vec2 m = velocity_change(a, {1, 1}) + velocity_change(b, {1, 1});
    const float xx = m.x + a.inverse_inertia * at.r_a.y * at.r_a.y + b.inverse_inertia * at.r_b.y * at.r_b.y;
    const float xy = -a.inverse_inertia * at.r_a.x * at.r_a.y - b.inverse_inertia * at.r_b.x * at.r_b.y;
    const float yy = m.y + a.inverse_inertia * at.r_a.x * at.r_a.x + b.inverse_inertia * at.r_b.x * at.r_b.x;
    const float determinant = xx * yy - xy * xy;
    const float trace = xx + yy;
    const bool locked = (a.locked | b.locked) != 0;
    if (determinant <= (locked ? kLeastMobility * trace * trace : 0)) {
        if (trace <= (locked ? kLeastMobility * (a.inverse_mass + b.inverse_mass) : 0)) return {};
        return (1 / (trace * trace)) * Vec2{xx * rhs.x + xy * rhs.y, xy * rhs.x + yy * rhs.y};
    }
    const float inverse = 1 / determinant;
    return {inverse * (yy * rhs.x - xy * rhs.y), inverse * (xx * rhs.y - xy * rhs.x)};
}

// One side of the limit: `gap` radians away from it, closing at `rate`. A gap may close, but no more; an
// overlap is pushed out softly.
float limit_impulse(const RevoluteConstraint& c, float accumulated, float gap_rad, float rate, float h_s,
                    Pass pass) {
    float bias = 0;
    Softness soft = kRigid;
    if (gap_rad > 0) {
        bias = gap_rad / h_s;
    } else if (pass == Pass::Biased) {
        soft = c.softness;
        bias = soft.bias_rate * gap_rad;
    }
    const float wanted =
        accumulated - c.axial_mass * soft.mass_scale * (rate + bias) - soft.impulse_scale * accumulated;
    return std::max(wanted, 0.0f);
}

void solve_motor(RevoluteConstraint& c, Motion& a, Motion& b) {
    const float rate = b.w - a.w - c.motor_speed_rad_s;
    const float impulse =
        std::clamp(c.motor_impulse - c.axial_mass * rate, -c.max_motor_impulse, c.max_motor_impulse);
    apply_angular_impulse(a, b, impulse - c.motor_impulse);
    c.motor_impulse = impulse;
}

void solve_limits(RevoluteConstraint& c, Motion& a, Motion& b, float h_s, Pass pass) {
    const Rotation turned = inverse(a.dq) * b.dq;
    const float angle = c.angle_rad + turned.angle_rad();

    const float lower = limit_impulse(c, c.lower_impulse, angle - c.lower_rad, b.w - a.w, h_s, pass);
    apply_angular_impulse(a, b, lower - c.lower_impulse);
    c.lower_impulse = lower;

    const float upper = limit_impulse(c, c.upper_impulse, c.upper_rad - angle, a.w - b.w, h_s, pass);
    apply_angular_impulse(a, b, c.upper_impulse - upper);
    c.upper_impulse = upper;
}

}  // namespace

void prepare_revolute(RevoluteConstraint& c, const Motions& motions) {
    const float k = motions.inverse_inertia[c.anchors.a] + motions.inverse_inertia[c.anchors.b];
    c.axial_mass = k > 0 ? 1 / k : 0;
    if (!c.motor) c.motor_impulse = 0;
    if (!c.limit) c.lower_impulse = c.upper_impulse = 0;
}

void warm_start_revolute(const RevoluteConstraint& c, Motions& motions) {
    Motion a = motions.get(c.anchors.a);
    Motion b = motions.get(c.anchors.b);
    apply_impulse(anchors_now(c.anchors, a, b), a, b, c.impulse);
    apply_angular_impulse(a, b, c.motor_impulse + c.lower_impulse - c.upper_impulse);
    motions.set_by_joint(c.anchors.a, a);
    motions.set_by_joint(c.anchors.b, b);
}

void solve_revolute(RevoluteConstraint& c, Motions& motions, float h_s, Pass pass) {
    Motion a = motions.get(c.anchors.a);
    Motion b = motions.get(c.anchors.b);
    if (c.motor) solve_motor(c, a, b);
    if (c.limit) solve_limits(c, a, b, h_s, pass);

    const AnchorsNow at = anchors_now(c.anchors, a, b);
    const Softness soft = pass == Pass::Biased ? c.softness : kRigid;
    const Vec2 jv = relative_velocity(at, a, b) + soft.bias_rate * at.offset;
    const Vec2 change = -soft.mass_scale * solve_point(a, b, at, jv) - soft.impulse_scale * c.impulse;
    c.impulse += change;
    apply_impulse(at, a, b, change);
    motions.set_by_joint(c.anchors.a, a);
    motions.set_by_joint(c.anchors.b, b);
}

}  // namespace cairn::physics
