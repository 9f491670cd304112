// Chooses the routine for a pair of kinds.
#include "collide/manifold.h"

namespace cairn::physics {
namespace {

// The manifold of (a, b), expressed in the frame of a, from that of (b, a) in the frame of b.
Manifold swapped(Manifold m, const RelativePose& b_in_a) {
    m.normal = -rotate(b_in_a.q, m.normal);
    for (int i = 0; i < m.count; ++i) m.points[i].point = b_in_a.p + rotate(b_in_a.q, m.points[i].point);
    return m;
}

RelativePose inverse(const RelativePose& pose) {
    return {-inverse_rotate(pose.q, pose.p), cairn::physics::inverse(pose.q)};
}

}  // namespace

Manifold collide(const Convex& a, const Convex& b, const RelativePose& b_in_a, float reach_m) {
    if (a.is_line() && b.is_line()) return {};
    if (b.is_chained()) return swapped(collide(b, a, inverse(b_in_a), reach_m), b_in_a);
    if (a.is_chained()) {
        return b.outline.kind == ShapeKind::Circle ? collide_chain_and_circle(a, b, b_in_a, reach_m)
                                                   : collide_chain_and_hull(a, b, b_in_a, reach_m);
    }
    const bool circle_a = a.outline.kind == ShapeKind::Circle;
    const bool circle_b = b.outline.kind == ShapeKind::Circle;
    if (circle_a && circle_b) return collide_circles(a, b, b_in_a, reach_m);
    if (circle_b) return collide_hull_and_circle(a, b, b_in_a, reach_m);
    if (circle_a) return swapped(collide_hull_and_circle(b, a, inverse(b_in_a), reach_m), b_in_a);
    if (a.is_box && b.is_box) {
        if (const auto manifold = collide_boxes(a, b, b_in_a, reach_m)) return *manifold;
    }
    return collide_hulls(a, b, b_in_a, reach_m);
}

}  // namespace cairn::physics
