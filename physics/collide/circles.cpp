// Circle against circle, and circle against capsule or polygon: one point.
#include <limits>

#include "collide/manifold.h"

namespace cairn::physics {
namespace {

// Two discs: the manifold between points pa and pb of A's frame, rounded by ra and rb. When the points are
// nearer than `least` the fallback serves as normal.
Manifold between_points(Vec2 pa, float ra, Vec2 pb, float rb, Vec2 fallback, float least, float reach) {
    const Vec2 d = pb - pa;
    const float distance = length(d);
    const float separation = distance - ra - rb;
    Manifold m;
    if (separation > reach) return m;
    m.normal = distance > least ? (1 / distance) * d : fallback;
    m.count = 1;
    m.points[0] = {0.5f * ((pa + ra * m.normal) + (pb - rb * m.normal)), separation, 0};
    return m;
}

}  // namespace

Manifold collide_circles(const Convex& a, const Convex& b, const RelativePose& b_in_a, float reach_m) {
    const Vec2 center = b_in_a.p + rotate(b_in_a.q, b.point(0));
    return between_points(a.point(0), a.radius(), center, b.radius(), {0, 1}, 1e-12f, reach_m);
}

Manifold collide_hull_and_circle(const Convex& a, const Convex& b, const RelativePose& b_in_a,
                                 float reach_m) {
    const Vec2 center = b_in_a.p + rotate(b_in_a.q, b.point(0));

    // The edge that the centre is farthest outside of (or least inside of).
    int edge = 0;
    float separation = -std::numeric_limits<float>::infinity();
    for (int i = 0; i < a.count(); ++i) {
        const float s = dot(a.normals[i], center - a.point(i));
        if (s > separation) {
            separation = s;
            edge = i;
        }
    }
    if (separation > a.radius() + b.radius() + reach_m) return {};

    // Which part of that edge is nearest: an end, or the inside with the edge's own normal.
    const Vec2 p1 = a.point(edge);
    const Vec2 p2 = a.point(a.next(edge));
    const Vec2 along = p2 - p1;
    const float t = dot(center - p1, along);
    const Vec2 normal = a.normals[edge];
    const auto to_point = [&](Vec2 p) {
        return between_points(p, a.radius(), center, b.radius(), normal, kAllButTouching_m, reach_m);
    };
    if (separation > 0 && t < 0) return to_point(p1);
    if (separation > 0 && t > length_squared(along)) return to_point(p2);
    // A capsule has no inside: its ends round off even when the centre lies on the core's line.
    if (a.count() == 2) {
        if (t <= 0) return to_point(p1);
        if (t >= length_squared(along)) return to_point(p2);
        return to_point(p1 + (t / length_squared(along)) * along);
    }
    Manifold m;
    m.normal = normal;
    m.count = 1;
    const Vec2 on_a = center + (a.radius() - separation) * normal;
    const Vec2 on_b = center - b.radius() * normal;
    m.points[0] = {0.5f * (on_a + on_b), separation - a.radius() - b.radius(), 0};
    return m;
}

}  // namespace cairn::physics
