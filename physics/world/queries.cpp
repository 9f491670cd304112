// Ray cast and point query.
#include "world/queries.h"

#include "collide/ray_cast.h"
#include "world/filtering.h"

namespace cairn::physics {
std::optional<RayHit> cast_ray_closest(const Stores& stores, Position origin_m, Vec2 translation_m,
                                       const QueryFilter& filter) {
    std::optional<RayHit> best;
    const auto visit = [&](int shape) {
        const ShapeRecord& record = stores.shapes[shape];
        if (!filter_sees(filter, record.def.filter)) return;
        const Transform xf = stores.bodies.transform(record.body);
        const auto hit = cast_ray(record.convex, inverse_transform_point(xf, origin_m),
                                  inverse_rotate(xf.q, translation_m));
        // Of equally near shapes the one made first counts, so the answer does not depend on the tree.
        const bool nearer =
            hit && (!best || hit->fraction < best->fraction ||
                    (hit->fraction == best->fraction && stores.shapes.id(shape).index1 < best->shape.index1));
        if (!nearer) return;
        best = RayHit{stores.shapes.id(shape), stores.bodies.slots.id(record.body),
                      origin_m + hit->fraction * translation_m, rotate(xf.q, hit->normal), hit->fraction};
    };
    for (const Layer layer : kLayers) {
        stores.broad.tree(layer).cast_ray(origin_m, translation_m, [&](int shape) {
            visit(shape);
            return best ? best->fraction : 1;
        });
    }
    return best;
}

std::optional<ShapeId> shape_at(const Stores& stores, Position point_m, const QueryFilter& filter) {
    std::optional<ShapeId> last;
    for (const Layer layer : kLayers) {
        stores.broad.tree(layer).query(make_aabb(point_m, {}, {}), [&](int shape) {
            const ShapeRecord& record = stores.shapes[shape];
            if (!filter_sees(filter, record.def.filter)) return;
            const Vec2 local = inverse_transform_point(stores.bodies.transform(record.body), point_m);
            if (!contains_point(record.convex, local)) return;
            if (!last || stores.shapes.id(shape).index1 > last->index1) last = stores.shapes.id(shape);
        });
    }
    return last;
}

}  // namespace cairn::physics
