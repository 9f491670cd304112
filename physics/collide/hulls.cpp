// Capsules and polygons, rounded or not, against each other: up to two points.
// Method: the axis of least overlap among the edge normals of both; the facing edge of the other shape is
// clipped to the reference edge. Cores that are apart and meet corner to corner get one point, with the
// normal between the corners, or, where they all but touch, that of the axis. Source: Gregorius, "The
// Separating Axis Test between Convex Polyhedra", GDC 2013.
#include "collide/clip.h"
#include "collide/distance.h"
#include "collide/manifold.h"

namespace cairn::physics {
Manifold collide_hulls(const Convex& shape_a, const Convex& shape_b, const RelativePose& b_in_a,
                       float reach_m) {
    const CoreEdges a = edges_of(shape_a);
    const CoreEdges b = edges_of(shape_b, b_in_a);
    const float reach = a.radius + b.radius + reach_m;
    const Axis axis_a = best_axis(a, b);
    if (axis_a.separation > reach) return {};
    const Axis axis_b = best_axis(b, a);
    if (axis_b.separation > reach) return {};

    const bool prefer_b = axis_b.separation > axis_a.separation + kRounding_m;
    const Candidate preferred = prefer_b ? Candidate(b, a, axis_b, true) : Candidate(a, b, axis_a, false);
    const float separation = std::max(axis_a.separation, axis_b.separation);
    // Cores without an inside may lie apart on one line, which none of their normals can tell.
    const bool in_line = a.count == 2 && b.count == 2 && preferred.clipped.beside;
    if (separation < -kRounding_m && !in_line) return preferred.manifold(reach_m);
    // While the cores all but touch, a face counts that is about the nearest: so it lasts as they press
    // together.
    if (preferred.is_nearest(separation > kAboutEqual_m ? kRounding_m : kAboutEqual_m)) {
        return preferred.manifold(reach_m);
    }

    const bool other_is_about_equal = std::fabs(axis_a.separation - axis_b.separation) <= kAboutEqual_m;
    if (other_is_about_equal) {
        const Candidate other = prefer_b ? Candidate(a, b, axis_a, false) : Candidate(b, a, axis_b, true);
        if (other.is_nearest(kRounding_m)) return other.manifold(reach_m);
    }
    const Distance nearest = distance_between(shape_a, shape_b, b_in_a);
    const float cores_apart = nearest.normal == Vec2{} ? 0 : nearest.distance + a.radius + b.radius;
    return between_corners(cores_apart > kAllButTouching_m ? nearest : preferred.to_deepest_corner(),
                           a.radius, b.radius, reach_m);
}

}  // namespace cairn::physics
