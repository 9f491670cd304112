// Moving deep overlaps apart. Glossary: d motion since the start of the step, theta scaled angle, arm = k (r
// x n), K inverse effective mass (resolve/contact_kernels.cpp).
#include "resolve/deep_overlap.h"

#include <algorithm>
#include <cmath>

namespace cairn::physics {
namespace {

// Ways of so many steps are no overlap that bodies were put into: that of the step in which they met, and
// some more, as impacts take from their speed.
constexpr float kUnseenSteps = 1.5f;

Vec2 movable(const Motions& motions, int row, Vec2 v) {
    return without_locked(motions.velocity[row].inverse_mass * v, motions.locked_axes(row));
}

// How an impulse along the normal at one point moves one body.
struct Mobility {
    Vec2 shift;     // m per N s
    float arm = 0;  // scaled; 0 of what nothing can turn
    float k = 0;    // along the normal, at the point
};

Mobility mobility_of(const Motions& motions, int row, Vec2 r, Vec2 normal) {
    Mobility m;
    m.shift = movable(motions, row, normal);
    if (motions.inverse_inertia[row] > 0) m.arm = motions.pose[row].k * cross(r, normal);
    m.k = dot(m.shift, normal) + m.arm * m.arm;
    return m;
}

// How far the point has gone along the normal since the start of the step; turns are taken as small.
float gone(const Motions& motions, int row, Vec2 r, Vec2 normal) {
    return dot(motions.pose[row].d, normal) + motions.angle(row) * cross(r, normal);
}

// As one push, where the points want it on average: one after the other would turn the bodies.
void push_apart(const DeepOverlap& overlap, const ContactConstraint& c, float most_m, Motions& motions) {
    float furthest = 0;
    float sum = 0;
    Vec2 r_a, r_b;
    for (int i = 0; i < c.count; ++i) {
        const ContactPointConstraint& p = c.points[i];
        const float now = overlap.separation[static_cast<std::size_t>(i)] +
                          gone(motions, c.b, p.r_b, c.normal) - gone(motions, c.a, p.r_a, c.normal);
        const float wanted = std::clamp(-kDeepOverlap_m - now, 0.0f, most_m);
        furthest = std::max(furthest, wanted);
        sum += wanted;
        r_a += wanted * p.r_a;
        r_b += wanted * p.r_b;
    }
    if (!(sum > 0)) return;
    const Mobility a = mobility_of(motions, c.a, (1 / sum) * r_a, c.normal);
    const Mobility b = mobility_of(motions, c.b, (1 / sum) * r_b, c.normal);
    if (!(a.k + b.k > 0)) return;
    const float impulse = furthest / (a.k + b.k);
    motions.pose[c.a].d -= impulse * a.shift;
    motions.pose[c.a].theta -= impulse * a.arm;
    motions.pose[c.b].d += impulse * b.shift;
    motions.pose[c.b].theta += impulse * b.arm;
}

}  // namespace

bool overlaps_deeply(const ContactConstraint& c, float dt_s) {
    for (int i = 0; i < c.count; ++i) {
        const ContactPointConstraint& p = c.points[i];
        const float passed = kUnseenSteps * dt_s * std::fabs(p.closing_velocity);
        if (p.separation < -kDeepOverlap_m - passed) return true;
    }
    return false;
}

void hide_overlap(ContactConstraint& c) {
    for (int i = 0; i < c.count; ++i) {
        ContactPointConstraint& p = c.points[i];
        p.separation = std::max(p.separation, 0.0f);
        p.end_separation = p.separation;
    }
}

void hide_overlap(ContactBlock& block, int lane) {
    for (ContactBlockPoint& p : block.points) {
        p.start_separation[lane] = std::max(p.start_separation[lane], 0.0f);
        p.separation[lane] = p.start_separation[lane];
    }
}

void show_overlap(ContactConstraint& c, const DeepOverlap& overlap) {
    for (int i = 0; i < c.count; ++i)
        c.points[i].separation = c.points[i].end_separation = overlap.separation[static_cast<std::size_t>(i)];
}

void push_apart(std::span<const DeepOverlap> overlaps, std::span<const ContactConstraint> contacts,
                float most_m, Motions& motions) {
    for (const DeepOverlap& overlap : overlaps)
        push_apart(overlap, contacts[static_cast<std::size_t>(overlap.contact)], most_m, motions);
}

}  // namespace cairn::physics
