// Poses are gathered from the places; all but chains go through SIMD, what it cannot decide through the
// general routines.
#include "world/narrow_phase.h"

#include <algorithm>
#include <bit>
#include <limits>

#include <cairn/physics/tuning.h>

#include "base/prefetch.h"
#include "broad/parted_pairs.h"
#include "collide/hull_lanes.h"
#include "world/tiny_contacts.h"

namespace cairn::physics {
namespace {

// How far a shape is in front of the line through a segment.
float height_above(const Convex& segment, const Convex& shape, const RelativePose& shape_in_segment) {
    const Vec2 normal = segment.normals[0];
    float least = std::numeric_limits<float>::infinity();
    for (int i = 0; i < shape.count(); ++i) {
        const Vec2 at = shape_in_segment.p + rotate(shape_in_segment.q, shape.point(i));
        least = std::min(least, dot(at - segment.point(0), normal));
    }
    return least - shape.radius();
}

void collide_lane(const Stores& stores, const PairBlock& pairs, const PoseLanes& poses, int lane,
                  ManifoldLanes& out, float unit) {
    const Rotation q_a{poses.cos_a[lane], poses.sin_a[lane]};
    const Rotation q_b{poses.cos_b[lane], poses.sin_b[lane]};
    const Vec2 center_a = stores.bodies.slots[pairs.body_a[lane]].mass.center_m;
    const Vec2 center_b = stores.bodies.slots[pairs.body_b[lane]].mass.center_m;
    const Rotation turn = inverse(q_a) * q_b;
    const Vec2 between = inverse_rotate(q_a, {poses.dx[lane], poses.dy[lane]});
    const RelativePose b_in_a{center_a + between - rotate(turn, center_b), turn};
    const Convex& a = stores.shapes[pairs.shape_a[lane]].convex();
    const Convex& b = stores.shapes[pairs.shape_b[lane]].convex();
    const Manifold m = unit == 1 ? collide(a, b, b_in_a, tuning::kSpeculativeDistance_m)
                                 : collide_in_unit(a, b, b_in_a, unit);
    const bool in_front = m.count == 0 && a.is_chained();
    const Vec2 normal = rotate(q_a, in_front ? a.normals[0] : m.normal);
    out.normal_x[lane] = normal.x;
    out.normal_y[lane] = normal.y;
    out.gap[lane] = in_front ? height_above(a, b, b_in_a) : 0;
    for (int i = 0; i < 2; ++i) {
        ManifoldPointLanes& to = out.points[i];
        to.id[lane] = i < m.count ? m.points[i].id : kNoFeature;
        if (i >= m.count) continue;
        const Vec2 r_a = rotate(q_a, m.points[i].point - center_a);
        to.x[lane] = r_a.x;
        to.y[lane] = r_a.y;
        to.separation[lane] = m.points[i].separation;
    }
}

// Lanes that are not wanted take the shapes of the first one that is; they are far apart.
HullLanes hulls_of(const Stores& stores, const PairBlock& pairs, unsigned lanes) {
    const int first = std::countr_zero(lanes);
    HullLanes hulls;
    for (int lane = 0; lane < kLanes; ++lane) {
        const int from = (lanes >> lane & 1) != 0 ? lane : first;
        hulls.a[lane] = &stores.shapes[pairs.shape_a[from]].convex();
        hulls.b[lane] = &stores.shapes[pairs.shape_b[from]].convex();
    }
    return hulls;
}

}  // namespace

unsigned gone_lanes(const Stores& stores, const Lanes<std::int32_t>& shape_a,
                    const Lanes<std::int32_t>& shape_b, unsigned lanes) {
    return parted_lanes(stores.fat_boxes, stores.broad.ways(), shape_a, shape_b, lanes);
}

void ask_for_pairs(const Stores& stores, const PairBlock& pairs, PairGeometry geometry, unsigned lanes) {
    for (; lanes != 0; lanes &= lanes - 1) {
        const int lane = std::countr_zero(lanes);
        prefetch(&stores.bodies.places[pairs.body_a[lane]], sizeof(Place));
        prefetch(&stores.bodies.places[pairs.body_b[lane]], sizeof(Place));
        if (geometry == PairGeometry::Boxes) continue;  // the block knows them
        stores.shapes.ask_for(pairs.shape_a[lane]);
        stores.shapes.ask_for(pairs.shape_b[lane]);
    }
}

void collide_block(const Stores& stores, const PairBlock& pairs, PairGeometry geometry, unsigned lanes,
                   const PoseLanes& poses, ManifoldLanes& out, float unit) {
    unsigned general = ~0u;
    switch (geometry) {
        case PairGeometry::Boxes:
            general = collide_box_lanes(poses, pairs.boxes, tuning::kSpeculativeDistance_m, out);
            break;
        case PairGeometry::Hulls:
            general = collide_hull_lanes(poses, pairs.boxes, hulls_of(stores, pairs, lanes),
                                         tuning::kSpeculativeDistance_m, out);
            break;
        case PairGeometry::Chains:
            out = {};
            for (ManifoldPointLanes& point : out.points) point.id.fill(kNoFeature);
            break;
    }
    for (general &= lanes; general != 0; general &= general - 1) {
        collide_lane(stores, pairs, poses, std::countr_zero(general), out, unit);
    }
}

ContactInput make_input(const Stores& stores, const PairBlock& pairs, const BlockPlaces& places,
                        const ManifoldLanes& manifold, int lane) {
    const ContactRecord& record = stores.contacts.slots[pairs.contact[lane]];
    ContactInput input{};
    input.a = places.row_a[lane];
    input.b = places.row_b[lane];
    input.contact = pairs.contact[lane];
    input.normal = {manifold.normal_x[lane], manifold.normal_y[lane]};
    const Vec2 between{places.poses.dx[lane], places.poses.dy[lane]};
    for (int i = 0; i < 2; ++i) {
        const ManifoldPointLanes& from = manifold.points[i];
        if (from.id[lane] == kNoFeature) break;
        const Vec2 r_a{from.x[lane], from.y[lane]};
        input.points[i] = {r_a, r_a - between, from.separation[lane], from.id[lane], 0};
        input.count = i + 1;
    }
    input.friction = record.friction;
    input.restitution = record.restitution;
    input.radius_a = stores.shapes[pairs.shape_a[lane]].convex().radius();
    input.radius_b = stores.shapes[pairs.shape_b[lane]].convex().radius();
    return input;
}

Bows bows_of(const Stores& stores, const PairBlock& pairs, const BlockPlaces& places,
             const ManifoldLanes& manifold, int lane) {
    const ManifoldPointLanes& p = manifold.points[0];
    const ManifoldPointLanes& q = manifold.points[1].id[lane] != kNoFeature ? manifold.points[1] : p;
    const Vec2 normal{manifold.normal_x[lane], manifold.normal_y[lane]};
    const float to_point = dot(normal, {0.5f * (p.x[lane] + q.x[lane]), 0.5f * (p.y[lane] + q.y[lane])});
    const float between = dot(normal, {places.poses.dx[lane], places.poses.dy[lane]});
    // Points lie midway between the surfaces.
    const float half_gap = 0.25f * (p.separation[lane] + q.separation[lane]);
    return {to_point - half_gap - stores.shapes[pairs.shape_a[lane]].convex().radius(),
            to_point - between + half_gap + stores.shapes[pairs.shape_b[lane]].convex().radius()};
}

}  // namespace cairn::physics
