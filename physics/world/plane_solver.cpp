// The point nearest to a wish in an intersection of half planes.
// Method: one plane after the other. A point that satisfies the planes so far and the next one stays; else
// the new nearest point lies on the next plane's line, where the planes so far leave an interval. Exact after
// one pass. Source: Seidel, "Small-dimensional linear programming and convex hulls made easy", 1991; as used
// for crowds in van den Berg et al., "Reciprocal n-body Collision Avoidance", 2011.
#include <algorithm>
#include <limits>

#include <cairn/physics/mover.h>

namespace cairn::physics {
namespace {

// How far planes may be overstepped: those of dynamic bodies, and the others.
struct Slack {
    float dynamic = 0;
    float fixed = 0;
};

float least_distance(const CollisionPlane& plane, float gap, const Slack& slack) {
    return gap - plane.separation_m - (plane.is_dynamic ? slack.dynamic : slack.fixed);
}

std::optional<Vec2> nearest_allowed(Vec2 wish, std::span<const CollisionPlane> planes, float gap,
                                    const Slack& slack) {
    constexpr float kRounding_m = 1e-6f;
    Vec2 x = wish;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const Vec2 normal = planes[i].normal;
        const float least = least_distance(planes[i], gap, slack);
        if (dot(normal, x) >= least) continue;
        const Vec2 base = least * normal;
        const Vec2 tangent = left_perp(normal);
        float low = -std::numeric_limits<float>::infinity();
        float high = std::numeric_limits<float>::infinity();
        for (const CollisionPlane& other : planes.first(i)) {
            const float missing = least_distance(other, gap, slack) - dot(other.normal, base);
            const float along = dot(other.normal, tangent);
            if (std::fabs(along) < 1e-6f) {
                if (missing > kRounding_m) return {};
            } else if (along > 0) {
                low = std::max(low, missing / along);
            } else {
                high = std::min(high, missing / along);
            }
        }
        if (low > high + kRounding_m) return {};
        x = base + std::clamp(dot(wish, tangent), std::min(low, high), high) * tangent;
    }
    return x;
}

float worst_violation(Vec2 x, std::span<const CollisionPlane> planes, float gap) {
    float worst = 0;
    for (const CollisionPlane& plane : planes)
        worst = std::max(worst, least_distance(plane, gap, {}) - dot(plane.normal, x));
    return worst;
}

// With the least slack that leaves a place; `x` is one that satisfies all planes with enough slack.
template <class SlackOf>
Vec2 with_least_slack(Vec2 wish, std::span<const CollisionPlane> planes, float gap, Vec2 x,
                      SlackOf&& slack_of) {
    constexpr int kHalvings = 20;  // a metre to a micrometre
    float low = 0;
    float high = worst_violation(x, planes, gap);
    for (int i = 0; i < kHalvings; ++i) {
        const float middle = 0.5f * (low + high);
        const auto found = nearest_allowed(wish, planes, gap, slack_of(middle));
        (found ? high : low) = middle;
        if (found) x = *found;
    }
    return x;
}

}  // namespace

Vec2 solve_planes(Vec2 translation_m, std::span<const CollisionPlane> planes, float gap_m) {
    if (const auto x = nearest_allowed(translation_m, planes, gap_m, {})) return *x;
    constexpr float kAnySlack = 1e9f;
    if (const auto x = nearest_allowed(translation_m, planes, gap_m, {kAnySlack, 0})) {
        return with_least_slack(translation_m, planes, gap_m, *x, [](float s) { return Slack{s, 0}; });
    }
    // With enough slack, staying where it is satisfies every plane.
    return with_least_slack(translation_m, planes, gap_m, {}, [](float s) { return Slack{s, s}; });
}

}  // namespace cairn::physics
