// Explosions as a pressure on the outline that faces them.
#include <algorithm>

#include "collide/minkowski.h"
#include "collide/outline_pieces.h"
#include "world/queries.h"
#include "world/query_traversal.h"
#include "world/surface_forces.h"

namespace cairn::physics {
namespace {

// Full up to the radius, then fading.
float strength(const ExplosionDef& def, float distance) {
    if (distance <= def.radius_m) return 1;
    if (distance >= def.radius_m + def.falloff_m) return 0;
    return (def.radius_m + def.falloff_m - distance) / def.falloff_m;
}

// The way that the explosion takes to the shape, which tells what faces it: to the nearest point of the
// surface; from inside, inward from there.
Vec2 direction_to(const Convex& shape, Vec2 center) {
    Convex speck;
    speck.outline.count = 1;
    return -clearance(minkowski_difference(shape, speck, {center, {}})).normal;
}

SurfaceForce impulse_on(const Stores& stores, int shape, const ExplosionDef& def) {
    const ShapeRecord& record = stores.shapes[shape];
    const BodyRecord& body = stores.bodies.slots[record.body];
    const Transform xf = stores.bodies.transform(record.body);
    const Vec2 center = inverse_transform_point(xf, def.center_m);
    const Vec2 direction = direction_to(record.convex(), center);
    const QueryFilter shelter{.mask = def.shelter, .ignored_body = stores.bodies.slots.id(record.body)};
    SurfaceForce sum{shelter.ignored_body};
    visit_facing_pieces(
        record.convex(), [&](Vec2) { return direction; },
        [&](const OutlinePiece& piece) {
            const float share = strength(def, length(piece.point - center));
            if (share <= 0) return;
            if (def.shelter != 0 &&
                cast_ray_closest(stores, def.center_m, rotate(xf.q, piece.point - center), shelter)) {
                return;
            }
            const Vec2 impulse = (-share * def.impulse_ns_m) * piece.area;
            sum.linear += impulse;
            sum.angular += cross(piece.point - body.mass.center_m, impulse);
        });
    sum.linear = rotate(xf.q, sum.linear);
    return sum;
}

}  // namespace

check::Fault validate(const ExplosionDef& def) {
    const auto radius = static_cast<double>(def.radius_m);
    const auto falloff = static_cast<double>(def.falloff_m);
    return check::first_of({check::placed("explosion.center_m", def.center_m),
                            check::not_negative("explosion.radius_m", radius),
                            check::require(radius <= 1e9, "explosion.radius_m", radius, "at most 1e9 m"),
                            check::not_negative("explosion.falloff_m", falloff),
                            check::require(falloff <= 1e9, "explosion.falloff_m", falloff, "at most 1e9 m"),
                            check::finite("explosion.impulse_ns_m", static_cast<double>(def.impulse_ns_m))});
}

std::vector<SurfaceForce> explosion_impulses(const Stores& stores, const ExplosionDef& def) {
    const float reach = def.radius_m + def.falloff_m;
    std::vector<int> shapes;
    visit_in_box(stores, make_aabb(def.center_m, {-reach, -reach}, {reach, reach}), def.filter,
                 [&](int shape) {
                     const BodyRecord& body = stores.bodies.slots[stores.shapes[shape].body];
                     if (body.type == BodyType::Dynamic) shapes.push_back(shape);
                 });
    std::sort(shapes.begin(), shapes.end());
    std::vector<SurfaceForce> impulses;
    for (const int shape : shapes) {
        const SurfaceForce impulse = impulse_on(stores, shape, def);
        if (impulse.linear == Vec2{} && impulse.angular == 0) continue;
        impulses.push_back(impulse);
    }
    // Shapes of one body, in the order of their slots, give one impulse.
    std::stable_sort(impulses.begin(), impulses.end(), [](const SurfaceForce& a, const SurfaceForce& b) {
        return a.body.index1 < b.body.index1;
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < impulses.size(); ++i) {
        if (kept > 0 && impulses[kept - 1].body == impulses[i].body) {
            impulses[kept - 1].linear += impulses[i].linear;
            impulses[kept - 1].angular += impulses[i].angular;
        } else {
            impulses[kept++] = impulses[i];
        }
    }
    impulses.resize(kept);
    return impulses;
}

}  // namespace cairn::physics
