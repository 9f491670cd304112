// Capsules and polygons, rounded or not, against each other: up to two points.
// Method: the axis of least overlap among the edge normals of both; the facing edge of the other shape is
// clipped to the reference edge. Cores that are apart and meet corner to corner get one point, with the
// normal between the corners. Source: Gregorius, "The Separating Axis Test between Convex Polyhedra", GDC
// 2013.
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

    const bool prefer_b = axis_b.separation > axis_a.separation + kAboutEqual_m;
    const Candidate preferred = prefer_b ? Candidate(b, a, axis_b, true) : Candidate(a, b, axis_a, false);
    // Cores without an inside may lie apart on one line, which none of their normals can tell.
    const bool in_line = a.count == 2 && b.count == 2 && preferred.clipped.beside;
    const bool apart = in_line || std::max(axis_a.separation, axis_b.separation) > kAboutEqual_m;
    if (!apart || preferred.is_nearest()) return preferred.manifold(reach_m);

    const bool other_is_about_equal = std::fabs(axis_a.separation - axis_b.separation) <= kAboutEqual_m;
    if (other_is_about_equal) {
        const Candidate other = prefer_b ? Candidate(a, b, axis_a, false) : Candidate(b, a, axis_b, true);
        if (other.is_nearest()) return other.manifold(reach_m);
    }
    return between_corners(distance_between(shape_a, shape_b, b_in_a), a.radius, b.radius, reach_m);
}

}  // namespace cairn::physics
