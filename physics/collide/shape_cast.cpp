// A shape cast is the cast of a ray, from the origin, at the Minkowski difference.
#include "collide/shape_cast.h"

#include <algorithm>
#include <span>

#include "collide/ray_cast.h"

namespace cairn::physics {
namespace {

// m. Shapes as near as rounding can tell from touching; a ray from there could find itself inside.
float touching_distance(const MinkowskiDifference& difference) {
    float size = difference.radius;
    for (int i = 0; i < difference.count; ++i) size = std::max(size, length(difference.points[i]));
    return 1e-6f * size;
}

}  // namespace

std::optional<LocalShapeHit> cast_shape(const Convex& fixed, const Convex& moving,
                                        const RelativePose& moving_in_fixed, Vec2 translation) {
    const MinkowskiDifference difference = minkowski_difference(fixed, moving, moving_in_fixed);
    const Clearance at_start = clearance(difference);
    const auto hit_from_start = [&](float overlap) {
        return LocalShapeHit{0, overlap, at_start.normal,
                             meeting_point(fixed, moving, moving_in_fixed, at_start)};
    };
    if (at_start.distance < 0) return hit_from_start(-at_start.distance);
    if (at_start.distance <= touching_distance(difference)) {
        if (dot(translation, at_start.normal) >= 0) return {};
        return hit_from_start(0);
    }
    const auto count = static_cast<std::size_t>(difference.count);
    const auto ray =
        cast_ray_at_outline(std::span(difference.points).first(count),
                            std::span(difference.normals).first(count), difference.radius, {}, translation);
    if (!ray) return {};
    const RelativePose there{moving_in_fixed.p + ray->fraction * translation, moving_in_fixed.q};
    return LocalShapeHit{ray->fraction, 0, ray->normal,
                         meeting_point(fixed, moving, there, {0, ray->normal})};
}

}  // namespace cairn::physics
