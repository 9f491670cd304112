// Bounces within a step. Substeps are semi-implicit Euler, whose place lags behind free flight by a h T / 2
// in a time T: energy that a body loses each time it comes near to what it bounces from. And an impact is
// solved in the substep in which it happens, but gives its speed back only when the step is over, so the body
// would wait until then. Invariant: only places change; the centre of mass of a pair stays where it is.
//
// Impact of a pair that is s0 apart (less than 0 when it met in the step before, unseen) and closes at u0 >
// 0, both along the normal, under a relative acceleration g: it meets with u = sqrt(u0^2 - 2 g s0) at the
// time t = 2 s0 / (u0 + u). In what is left of the step, T - t, it comes s = e u (T - t) + g (T - t)^2 / 2
// apart.
#include "world/bounces.h"

#include <algorithm>
#include <cmath>

#include "integrator/integrate.h"
#include "resolve/contact_points.h"

namespace cairn::physics {
namespace {

// Of a speed: what the rounding of a step may make of it.
constexpr float kFreeShare = 1e-5f;

// Of an impulse or an arm: the same, where differences of speeds are compared.
constexpr float kRoundingShare = 1e-3f;

class Placing {
  public:
    Placing(const BodyRows& awake, StepScratch& scratch, const StepTime& time, const ContactRules& rules)
        : awake_(awake), motions_(scratch.motions), drives_(scratch.drives), time_(time), rules_(rules) {}

    void place(ContactConstraint& c) {
        // Structures of joints move exactly, and never alone.
        if (is_direct(c.a) || is_direct(c.b)) return;
        fly_if_free(c.a);
        fly_if_free(c.b);
        if (c.count == 1) rebound(c);
    }

  private:
    [[nodiscard]] bool is_direct(int row) const { return motions_.mover[row] == MovedBy::Direct; }

    [[nodiscard]] bool moves(int row) const { return motions_.velocity[row].inverse_mass > 0; }

    [[nodiscard]] Vec2 velocity_before(int row) const { return awake_.velocity[row - 1]; }

    [[nodiscard]] Vec2 free_velocity(int row) const {
        return freely_moving(velocity_before(row), drives_[row], time_.h_s, time_.substeps);
    }

    // A first guess that was taken out again leaves rounding behind.
    void fly_if_free(int row) {
        if (!moves(row)) return;
        const Vec2 before = velocity_before(row);
        const Vec2 after = motions_.velocity[row].v;
        const float tolerance = kFreeShare * (length(before) + length(after));
        if (length(after - free_velocity(row)) > tolerance) return;
        motions_.pose[row].d = 0.5f * time_.dt_s * (before + after);
    }

    // Whether nothing but this impulse has pushed the body along the axis.
    [[nodiscard]] bool feels_only(int row, Vec2 axis, float impulse) const {
        if (!moves(row)) return true;
        const float gained = dot(motions_.velocity[row].v - free_velocity(row), axis);
        const float expected = motions_.velocity[row].inverse_mass * impulse;
        return std::fabs(gained - expected) <= kRoundingShare * expected;
    }

    // Whether an impulse along the normal turns it.
    [[nodiscard]] static bool is_central(Vec2 arm, Vec2 normal) {
        return std::fabs(cross(arm, normal)) <= kRoundingShare * length(arm);
    }

    void rebound(ContactConstraint& c) {
        ContactPointConstraint& p = c.points[0];
        const float impulse = p.total_normal_impulse;
        if (!met_fast(p, rules_)) return;
        if (moves(c.a) && !is_central(p.r_a, c.normal)) return;
        if (moves(c.b) && !is_central(p.r_b, c.normal)) return;
        if (!feels_only(c.a, -c.normal, impulse) || !feels_only(c.b, c.normal, impulse)) return;

        const float u0 = -p.closing_velocity;
        const float g = dot(drives_[c.b].acceleration - drives_[c.a].acceleration, c.normal);
        const float s0 = p.separation;
        const float u = std::sqrt(std::max(u0 * u0 - 2 * g * s0, 0.0f));
        const float left_s = time_.dt_s - 2 * s0 / (u0 + u);
        const float leaving = c.restitution * u;
        // Not in this step or the one before, or back within it.
        if (!(left_s > 0) || left_s > 2 * time_.dt_s || leaving + g * left_s <= 0) return;
        move_apart(c, p, left_s * (leaving + 0.5f * g * left_s) - p.end_separation);
    }

    // At most until the centre of mass is where the far surface was: then it has passed nothing that the body
    // did not overlap, and what it overlaps now pushes it back.
    void move_apart(ContactConstraint& c, ContactPointConstraint& p, float further_m) {
        const float inverse_a = motions_.velocity[c.a].inverse_mass;
        const float inverse_b = motions_.velocity[c.b].inverse_mass;
        float unit = further_m / (inverse_a + inverse_b);
        if (moves(c.a)) unit = std::min(unit, length(p.r_a) / inverse_a);
        if (moves(c.b)) unit = std::min(unit, length(p.r_b) / inverse_b);
        if (unit <= 0) return;
        motions_.pose[c.a].d -= unit * inverse_a * c.normal;
        motions_.pose[c.b].d += unit * inverse_b * c.normal;
        p.end_separation += unit * (inverse_a + inverse_b);
    }

    const BodyRows& awake_;
    Motions& motions_;
    const std::vector<Drive>& drives_;
    const StepTime& time_;
    const ContactRules& rules_;
};

bool met(const ContactConstraint& c, const ContactRules& rules) {
    return std::any_of(c.points.begin(), c.points.begin() + c.count,
                       [&](const ContactPointConstraint& p) { return met_fast(p, rules); });
}

}  // namespace

void place_bounces(const BodyRows& awake, StepScratch& scratch, const StepTime& time,
                   const ContactRules& rules) {
    Placing placing(awake, scratch, time, rules);
    scratch.impacts.met.clear();
    scratch.impacts.met.reserve(scratch.contacts.capacity());
    for (std::size_t i = 0; i < scratch.contacts.size(); ++i) {
        ContactConstraint& c = scratch.contacts[i];
        if (c.restitution == 0) continue;
        placing.place(c);
        if (met(c, rules)) scratch.impacts.met.push_back(static_cast<int>(i));
    }
}

}  // namespace cairn::physics
