// Units of tiny contacts.
#include "world/tiny_contacts.h"

#include <algorithm>

namespace cairn::physics {
namespace {

Convex scaled(const Convex& shape, float scale) {
    Convex larger = shape;
    for (Vec2& point : larger.outline.points_m) point = scale * point;
    larger.outline.radius_m *= scale;
    larger.centroid = scale * shape.centroid;
    larger.half_size = scale * shape.half_size;
    return larger;
}

}  // namespace

Manifold collide_in_unit(const Convex& a, const Convex& b, const RelativePose& b_in_a, float unit) {
    const float scale = 1 / unit;
    Manifold m = collide(scaled(a, scale), scaled(b, scale), {scale * b_in_a.p, b_in_a.q},
                         tuning::kSpeculativeDistance_m);
    for (ManifoldPoint& p : m.points) {
        p.point = unit * p.point;
        p.separation *= unit;
    }
    return m;
}

float least_unit(const Stores& stores) {
    float least = 1;
    if (stores.contacts.tiny == 0) return least;
    for (const int contact : stores.contacts.loose)
        least = std::min(least, length_unit(stores, stores.contacts.slots[contact]));
    return least;
}

}  // namespace cairn::physics
