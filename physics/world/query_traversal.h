// Which shapes a query has to look at: one place that knows of the layers of the broad phase and of filters.
// Invariant: each shape that the filter lets through and whose box is met is visited exactly once.
#pragma once

#include <algorithm>

#include "world/filtering.h"

namespace cairn::physics {

inline bool sees(const Stores& stores, const QueryFilter& filter, int shape) {
    const ShapeRecord& record = stores.shapes[shape];
    if (!filter_sees(filter, record.def().filter)) return false;
    const BodyId body = stores.bodies.slots.id(record.body);
    if (body == filter.ignored_body) return false;
    if (!filter.accepts.asks()) return true;
    const FilterCalls::Call call(stores.filter_calls);
    return filter.accepts(stores.shapes.id(shape), body);
}

/// visit(shape) for those whose box overlaps.
template <class Visit>
void visit_in_box(const Stores& stores, const Aabb& box, const QueryFilter& filter, Visit&& visit) {
    for (const Layer layer : kLayers) {
        stores.broad.tree(layer).query(box, [&](int shape) {
            if (sees(stores, filter, shape)) visit(shape);
        });
    }
}

/// visit(shape) for those whose box the ray meets; it returns the fraction up to which the ray is still of
/// interest.
template <class Visit>
void visit_along_ray(const Stores& stores, Position origin_m, Vec2 translation_m, const QueryFilter& filter,
                     Visit&& visit) {
    float fraction = 1;
    for (const Layer layer : kLayers) {
        stores.broad.tree(layer).cast_box(origin_m, {}, translation_m, fraction, [&](int shape) {
            if (sees(stores, filter, shape)) fraction = visit(shape);
            return fraction;
        });
    }
}

/// The same for a box from lower to upper (relative to origin_m) that moves. The way is walked in pieces not
/// much longer than the box, so that a long slanting one does not visit all that lies about it. The pieces
/// that overlap the box of a shape follow one another: the first of them visits.
template <class Visit>
void visit_along_way(const Stores& stores, Position origin_m, Vec2 lower, Vec2 upper, Vec2 translation_m,
                     const QueryFilter& filter, Visit&& visit) {
    constexpr float kPieceInBoxes = 4;
    constexpr float kMaxPieces = 64;
    const float size = std::max(upper.x - lower.x, upper.y - lower.y);
    const float way = std::max(std::fabs(translation_m.x), std::fabs(translation_m.y));
    const float pieces = std::clamp(std::ceil(way / (kPieceInBoxes * size)), 1.0f, kMaxPieces);
    float fraction = 1;
    Aabb before;
    for (float piece = 0; piece < pieces && piece / pieces <= fraction; ++piece) {
        const Vec2 from = (piece / pieces) * translation_m;
        const Vec2 to = ((piece + 1) / pieces) * translation_m;
        const Aabb box = make_aabb(origin_m, lower + Vec2{std::min(from.x, to.x), std::min(from.y, to.y)},
                                   upper + Vec2{std::max(from.x, to.x), std::max(from.y, to.y)});
        for (const Layer layer : kLayers) {
            stores.broad.tree(layer).query(box, [&](int shape) {
                const bool is_visited = overlap(stores.fat_boxes[shape], before);
                if (!is_visited && sees(stores, filter, shape)) fraction = visit(shape);
            });
        }
        before = box;
    }
}

}  // namespace cairn::physics
