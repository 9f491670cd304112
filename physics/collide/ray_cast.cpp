// The surface of a rounded convex shape is its edges, moved outward by the radius, and an arc at each corner:
// the ray enters at the first of them that it meets from outside. A segment of a chain has only its front.
// Invariant: no ray slips in between two parts of the surface. On which side of the ray's line a corner lies
// is found in the same way, to the bit, for both parts that share it, so one of them takes the ray.
// Source for that: Woop et al., "Watertight Ray/Triangle Intersection", JCGT 2013.
#include "collide/ray_cast.h"

#include <algorithm>

namespace cairn::physics {
namespace {

struct Ray {
    Vec2 origin;
    Vec2 translation;

    // Whether its line crosses a straight piece of an anticlockwise outline, the ends included, from outside
    // to inside.
    [[nodiscard]] bool enters_between(Vec2 a, Vec2 b) const {
        const float side_a = cross(translation, a - origin);
        const float side_b = cross(translation, b - origin);
        return side_a >= 0 && side_b <= 0 && side_a != side_b;
    }
};

void take_earlier(std::optional<LocalRayHit>& best, float fraction, Vec2 normal) {
    if (fraction < 0 || fraction > 1) return;
    if (!best || fraction < best->fraction) best = LocalRayHit{fraction, normal};
}

void cast_at_edge(std::optional<LocalRayHit>& best, Vec2 a, Vec2 b, Vec2 normal, const Ray& ray) {
    if (!ray.enters_between(a, b)) return;
    const float speed = -dot(ray.translation, normal);
    const float whole = length_squared(ray.translation);
    if (speed <= 0 || whole == 0) return;
    // Where a ray that all but runs along the edge meets its line is known badly; not outside of the edge.
    const float at_a = dot(a - ray.origin, ray.translation) / whole;
    const float at_b = dot(b - ray.origin, ray.translation) / whole;
    const float at_line = dot(ray.origin - a, normal) / speed;
    take_earlier(best, std::clamp(at_line, std::min(at_a, at_b), std::max(at_a, at_b)), normal);
}

// `from` and `to` are the ends of the part of the circle that is the surface. A ray that enters between them
// has met it, even when rounding lets it pass by the circle.
void cast_at_arc(std::optional<LocalRayHit>& best, Vec2 center, float radius, Vec2 from, Vec2 to,
                 const Ray& ray) {
    // |m + t d| = r, with the root found about the nearest point of the line, where nothing cancels.
    const float whole = length(ray.translation);
    if (whole == 0) return;
    const Vec2 d = (1 / whole) * ray.translation;
    const Vec2 m = ray.origin - center;
    const float to_nearest = -dot(m, d);
    const Vec2 nearest = m + to_nearest * d;
    const float half_chord_squared = radius * radius - length_squared(nearest);
    if (half_chord_squared < 0 && !ray.enters_between(from, to)) return;
    const float half_chord = std::sqrt(std::max(half_chord_squared, 0.0f));
    const Vec2 hit = nearest - half_chord * d;
    take_earlier(best, (to_nearest - half_chord) / whole, normalized(hit));
}

}  // namespace

std::optional<LocalRayHit> cast_ray(const Convex& shape, Vec2 origin, Vec2 translation) {
    if (contains_point(shape, origin)) return {};
    if (shape.is_chained()) {
        std::optional<LocalRayHit> hit;
        cast_at_edge(hit, shape.point(0), shape.point(1), shape.normals[0], {origin, translation});
        return hit;
    }
    const auto count = static_cast<std::size_t>(shape.count());
    return cast_ray_at_outline(std::span(shape.outline.points_m).first(count),
                               std::span(shape.normals).first(count), shape.radius(), origin, translation);
}

std::optional<LocalRayHit> cast_ray_at_outline(std::span<const Vec2> points, std::span<const Vec2> normals,
                                               float radius, Vec2 origin, Vec2 translation) {
    const Ray ray{origin, translation};
    std::optional<LocalRayHit> best;
    if (points.size() == 1) {
        cast_at_arc(best, points[0], radius, points[0], points[0], ray);
        return best;
    }
    for (std::size_t i = 0, before = points.size() - 1; i < points.size(); before = i++) {
        const std::size_t next = i + 1 < points.size() ? i + 1 : 0;
        const Vec2 begin = points[i] + radius * normals[i];
        cast_at_edge(best, begin, points[next] + radius * normals[i], normals[i], ray);
        if (radius > 0) {
            cast_at_arc(best, points[i], radius, points[i] + radius * normals[before], begin, ray);
        }
    }
    return best;
}

}  // namespace cairn::physics
