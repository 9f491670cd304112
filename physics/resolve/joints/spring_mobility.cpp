#include "resolve/joints/spring_mobility.h"

#include <cmath>
#include <utility>

namespace cairn::physics {
namespace {

// Of the trace: axes of what differs by less are rounding.
constexpr float kRound = 1e-5f;

// Of K at rest: what moves less is locked.
constexpr double kLocked = 1e-4;

// K now over that at rest.
double stiffening(const SpringMobility& rest, const SpringMobility& now, int directions) {
    const double xx = static_cast<double>(now.xx) / static_cast<double>(rest.xx);
    if (directions == 1) return xx;
    const double yy = static_cast<double>(now.yy) / static_cast<double>(rest.yy);
    const double xy =
        static_cast<double>(now.xy) / std::sqrt(static_cast<double>(rest.xx) * static_cast<double>(rest.yy));
    return greatest_eigenvalue(xx, xy, yy);
}

}  // namespace

double greatest_eigenvalue(double xx, double xy, double yy) {
    return (xx + yy) / 2 + std::sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
}

float mobility_along(const SpringEnd& a, Vec2 line_a, const SpringEnd& b, Vec2 line_b) {
    const float lever_a = cross(a.arm, line_a);
    const float lever_b = cross(b.arm, line_b);
    return a.inverse_mass + b.inverse_mass + a.inverse_inertia * lever_a * lever_a +
           b.inverse_inertia * lever_b * lever_b;
}

PrincipalMobility principal_mobility(const SpringEnd& a, const SpringEnd& b) {
    const float mass = a.inverse_mass + b.inverse_mass;
    float xx = mass, xy = 0, yy = mass;
    for (const SpringEnd& end : {a, b}) {
        xx += end.inverse_inertia * end.arm.y * end.arm.y;
        xy -= end.inverse_inertia * end.arm.x * end.arm.y;
        yy += end.inverse_inertia * end.arm.x * end.arm.x;
    }
    const float middle = (xx + yy) / 2;
    const float half = (xx - yy) / 2;
    const float radius = std::sqrt(half * half + xy * xy);
    if (!(radius > kRound * middle)) return {{1, 0}, {xx, 0, yy}};
    const Vec2 axis = half >= 0 ? Vec2{half + radius, xy} : Vec2{xy, radius - half};
    // What is lost of the least in the difference, the masses have at least.
    return {normalized(axis), {middle + radius, 0, std::max(middle - radius, mass)}};
}

SpringMobility mobility_of(const JointLaw& spring, const JointPlace& place) {
    if (spring.mobility.xx > 0) return spring.mobility;
    const auto& k = place.inverse_mass;
    const std::size_t i = spring.direction;
    if (spring.count == 1) return {k[i][i], 0, 0};
    return {k[i][i], k[i + 1][i], k[i + 1][i + 1]};
}

void weigh_springs(std::span<JointConstraint> joints, std::span<const JointPlace> places) {
    for (std::size_t i = 0; i < joints.size(); ++i) {
        JointConstraint& c = joints[i];
        if (!c.has_spring) continue;
        for (int l = 0; l < c.law_count; ++l) {
            JointLaw& law = c.laws[static_cast<std::size_t>(l)];
            if (law.kind != LawKind::Spring || !(law.mobility.xx > 0)) continue;
            const SpringMobility rest = std::exchange(law.mobility, {});
            double times = stiffening(rest, mobility_of(law, places[i]), law.count);
            if (!(times > kLocked)) times = 1;
            const auto faster = static_cast<float>(std::sqrt(times));
            law.spring_frequency_hz *= faster;
            law.spring_damping_ratio *= faster;
            law.mobility.xx = rest.xx * static_cast<float>(times);
            law.mobility.yy = rest.yy * static_cast<float>(times);
        }
    }
}

}  // namespace cairn::physics
