// The surface of a rounded convex shape is its edges, moved outward by the radius, and an arc at each corner:
// the ray enters at the first of them that it meets from outside. A segment of a chain has only its front.
#include "collide/ray_cast.h"

namespace cairn::physics {
namespace {

void take_earlier(std::optional<LocalRayHit>& best, float fraction, Vec2 normal) {
    if (fraction < 0 || fraction > 1) return;
    if (!best || fraction < best->fraction) best = LocalRayHit{fraction, normal};
}

void cast_at_edge(std::optional<LocalRayHit>& best, Vec2 a, Vec2 b, Vec2 normal, Vec2 origin,
                  Vec2 translation) {
    const float speed = -dot(translation, normal);
    if (speed <= 0) return;  // along the edge, or out of it
    const float fraction = dot(origin - a, normal) / speed;
    const Vec2 edge = b - a;
    const float along = dot(origin + fraction * translation - a, edge);
    if (along >= 0 && along <= length_squared(edge)) take_earlier(best, fraction, normal);
}

void cast_at_disc(std::optional<LocalRayHit>& best, Vec2 center, float radius, Vec2 origin,
                  Vec2 translation) {
    // |m + t d| = r, with the root found about the nearest point of the line, where nothing cancels.
    const float whole = length(translation);
    if (whole == 0) return;
    const Vec2 d = (1 / whole) * translation;
    const Vec2 m = origin - center;
    const float to_nearest = -dot(m, d);
    const Vec2 nearest = m + to_nearest * d;
    const float half_chord_squared = radius * radius - length_squared(nearest);
    if (half_chord_squared < 0) return;
    const float half_chord = std::sqrt(half_chord_squared);
    const Vec2 hit = nearest - half_chord * d;
    take_earlier(best, (to_nearest - half_chord) / whole, normalized(hit));
}

}  // namespace

std::optional<LocalRayHit> cast_ray(const Convex& shape, Vec2 origin, Vec2 translation) {
    if (contains_point(shape, origin)) return {};
    if (shape.is_chained()) {
        std::optional<LocalRayHit> hit;
        cast_at_edge(hit, shape.point(0), shape.point(1), shape.normals[0], origin, translation);
        return hit;
    }
    const auto count = static_cast<std::size_t>(shape.count());
    return cast_ray_at_outline(std::span(shape.outline.points_m).first(count),
                               std::span(shape.normals).first(count), shape.radius(), origin, translation);
}

std::optional<LocalRayHit> cast_ray_at_outline(std::span<const Vec2> points, std::span<const Vec2> normals,
                                               float radius, Vec2 origin, Vec2 translation) {
    std::optional<LocalRayHit> best;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points.size() >= 2) {
            const Vec2 out = radius * normals[i];
            cast_at_edge(best, points[i] + out, points[i + 1 < points.size() ? i + 1 : 0] + out, normals[i],
                         origin, translation);
        }
        if (radius > 0) cast_at_disc(best, points[i], radius, origin, translation);
    }
    return best;
}

}  // namespace cairn::physics
