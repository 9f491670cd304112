// Convex cores with a radius against each other, a pair per SIMD lane. Everything is seen in the frame of A,
// from its centre of mass. Method as in hulls.cpp: the edge that the other core is farthest in front of is
// the reference, the facing edge of the other is clipped to it. Where cores are apart and what was clipped
// is not as near as the reference edge says, two corners are nearest to each other: which, all pairs tell.
// Invariant: a core is padded with its first point and normal up to the greatest count in the block, so the
// point behind the last one is the first, and an edge that is repeated is never better than the original.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collide/hull_lanes.cpp"
#include "collide/hull_lanes.h"

#include <cstddef>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/simd_rows-inl.h"
#include "base/simd_vec-inl.h"
#include "collide/feature_id-inl.h"
#include "collide/manifold.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

// Where the points of an outline begin, in floats: before them stand its kind and count in one, and its
// radius.
constexpr int kPointsAt = 2;
static_assert(offsetof(Outline, count) == 1 && offsetof(Outline, radius_m) == 4 &&
              offsetof(Outline, points_m) == kPointsAt * sizeof(float));

// One side of the pairs, as memory has it.
struct HullRows {
    Lanes<const float*> outlines;
    Lanes<const float*> normals;
};

struct Core {
    std::array<Vec, kMaxPolygonVertices + 1> points;
    std::array<Vec, kMaxPolygonVertices> normals;
    V radius;
    M is_point;  // it has no edges
    M is_thin;   // it has no inside
};

struct Edge {
    V separation;
    Vec normal;
    Vec from, to;
    VI index;
};

struct Corners {
    V distance_squared;
    Vec on_a;
    Vec from_a_to_b;
    VI id;
};

HWY_INLINE M as_float_mask(hn::Mask<DI> mask) {
    return hn::RebindMask(D(), mask);
}

// `count`: points of the largest core of the block. place(p) is where a point of the body's frame is.
template <class Place, class Turn>
HWY_INLINE void load_core(const HullRows& rows, int lane, int count, const Place& place, const Turn& turn,
                          Core& core) {
    int i = 0;
    do {
        const Columns points = load_rows(rows.outlines.data() + lane, kPointsAt + 2 * i);
        const Columns normals = load_rows(rows.normals.data() + lane, 2 * i);
        core.points[i] = place(Vec{points.x, points.y});
        core.points[i + 1] = place(Vec{points.z, points.u});
        core.normals[i] = turn(Vec{normals.x, normals.y});
        core.normals[i + 1] = turn(Vec{normals.z, normals.u});
        i += 2;
    } while (i < count);
    core.points[count] = core.points[0];
    // Not from arrays filled one by one: loading the whole of one would have to wait for all of its stores.
    const Columns head = load_rows(rows.outlines.data() + lane, 0);
    core.radius = head.y;
    const VI counts = hn::And(hn::ShiftRight<8>(hn::BitCast(DI(), head.x)), set_int(0xff));
    core.is_point = as_float_mask(hn::Lt(counts, set_int(2)));
    core.is_thin = as_float_mask(hn::Lt(counts, set_int(3)));
}

// The edge of `of` that the other core is farthest in front of.
HWY_INLINE Edge best_edge(const Core& of, const Core& other, int count) {
    Edge best{set(-HUGE_VALF), of.normals[0], of.points[0], of.points[1], set_int(0)};
    for (int i = 0; i < count; ++i) {
        // Not a copy: g++ would make it in halves of registers, and loading the whole of it would have to
        // wait.
        const Vec& normal = of.normals[i];
        V nearest = dot(normal, other.points[0]);
        for (int j = 1; j < count; ++j) nearest = hn::Min(nearest, dot(normal, other.points[j]));
        const V separation = hn::Sub(nearest, dot(normal, of.points[i]));
        const M better = hn::Gt(separation, best.separation);
        best.separation = hn::Max(separation, best.separation);
        best.normal = select(better, normal, best.normal);
        best.from = select(better, of.points[i], best.from);
        best.to = select(better, of.points[i + 1], best.to);
        best.index = hn::IfThenElse(hn::RebindMask(DI(), better), set_int(i), best.index);
    }
    best.separation = hn::IfThenElse(of.is_point, set(-HUGE_VALF), best.separation);
    return best;
}

// The edge that faces the normal most, of a where `of_a` is set and else of b.
HWY_INLINE Edge facing_edge(const Core& a, const Core& b, M of_a, Vec normal, int count) {
    Edge best{};
    V least = set(HUGE_VALF);
    Vec from = select(of_a, a.points[0], b.points[0]);
    best.from = from;
    best.to = from;
    best.index = set_int(0);
    for (int i = 0; i < count; ++i) {
        const Vec to = select(of_a, a.points[i + 1], b.points[i + 1]);
        const V along = dot(select(of_a, a.normals[i], b.normals[i]), normal);
        const M better = hn::Lt(along, least);
        least = hn::Min(along, least);
        best.from = select(better, from, best.from);
        best.to = select(better, to, best.to);
        best.index = hn::IfThenElse(hn::RebindMask(DI(), better), set_int(i), best.index);
        from = to;
    }
    return best;
}

HWY_INLINE Corners nearest_corners(const Core& a, const Core& b, int count) {
    Corners best{set(HUGE_VALF), a.points[0], {}, set_int(0)};
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) {
            const Vec between = sub(b.points[j], a.points[i]);
            const V squared = dot(between, between);
            const M better = hn::Lt(squared, best.distance_squared);
            best.distance_squared = hn::Min(squared, best.distance_squared);
            best.on_a = select(better, a.points[i], best.on_a);
            best.from_a_to_b = select(better, between, best.from_a_to_b);
            best.id = hn::IfThenElse(hn::RebindMask(DI(), better), set_int(1 << 13 | i << 4 | j), best.id);
        }
    }
    return best;
}

HWY_INLINE void store_axis(Vec q_a, Vec normal, V gap, int lane, ManifoldLanes& out) {
    const Vec in_world = rotate(q_a, normal);
    store(in_world.x, out.normal_x, lane);
    store(in_world.y, out.normal_y, lane);
    store(gap, out.gap, lane);
}

HWY_INLINE void store_no_points(int lane, ManifoldLanes& out) {
    for (ManifoldPointLanes& point : out.points) {
        store(hn::Zero(D()), point.x, lane);
        store(hn::Zero(D()), point.y, lane);
        store(hn::Zero(D()), point.separation, lane);
        store(set_int(kNoFeature), point.id, lane);
    }
}

// kThin: no core has more than two points. Loops of known length leave all of them in registers.
template <bool kThin>
HWY_INLINE unsigned collide_part(const PoseLanes& poses, const BoxLanes& offsets, const HullRows& rows_a,
                                 const HullRows& rows_b, int most_points, float reach_m, int lane,
                                 ManifoldLanes& out) {
    const int count = kThin ? 2 : most_points;
    const V zero = hn::Zero(D());
    const V one = set(1);
    const Vec q_a{load(poses.cos_a, lane), load(poses.sin_a, lane)};
    const Vec q_b{load(poses.cos_b, lane), load(poses.sin_b, lane)};
    const Vec between = inverse_rotate(q_a, {load(poses.dx, lane), load(poses.dy, lane)});
    const Vec turn = inverse_rotate(q_a, q_b);
    const Vec offset_a{load(offsets.offset_ax, lane), load(offsets.offset_ay, lane)};
    const Vec offset_b{load(offsets.offset_bx, lane), load(offsets.offset_by, lane)};
    Core a;
    Core b;
    load_core(
        rows_a, lane, count, [&](Vec p) HWY_ATTR { return add(p, offset_a); },
        [](Vec n) HWY_ATTR { return n; }, a);
    load_core(
        rows_b, lane, count, [&](Vec p) HWY_ATTR { return add(between, rotate(turn, add(p, offset_b))); },
        [&](Vec n) HWY_ATTR { return rotate(turn, n); }, b);

    const Edge edge_a = best_edge(a, b, count);
    const Edge edge_b = best_edge(b, a, count);
    const V radii = hn::Add(a.radius, b.radius);
    const V most = hn::Max(edge_a.separation, edge_b.separation);
    const V about_equal = set(kAboutEqual_m);
    const M points = hn::And(a.is_point, b.is_point);
    const M near = hn::Le(most, hn::Add(radii, set(reach_m)));

    const M flipped = hn::Gt(edge_b.separation, hn::Add(edge_a.separation, set(kRounding_m)));
    const V seen = hn::IfThenElse(flipped, edge_b.separation, edge_a.separation);
    const Vec normal = select(flipped, edge_b.normal, edge_a.normal);
    const Vec base = select(flipped, edge_b.from, edge_a.from);
    const Vec base_end = select(flipped, edge_b.to, edge_a.to);
    const Vec tangent = left(normal);
    const V length_base = dot(sub(base_end, base), tangent);

    store_axis(q_a, select(flipped, negate(normal), normal), hn::Sub(most, radii), lane, out);
    if (bits_of(near) == 0) {  // boxes overlap more often than shapes meet
        store_no_points(lane, out);
        return 0;
    }

    // Along the tangent the facing edge runs the other way.
    const Edge face = facing_edge(a, b, flipped, normal, count);
    const Vec first_end = sub(face.to, base);
    const Vec last_end = sub(face.from, base);
    const V first = dot(first_end, tangent);
    const V last = dot(last_end, tangent);
    const V first_gap = dot(first_end, normal);
    const V last_gap = dot(last_end, normal);
    const V width = hn::Sub(last, first);
    const V rise = hn::Sub(last_gap, first_gap);
    const M upright = hn::Le(width, zero);
    const V share = hn::Div(one, hn::IfThenElse(upright, one, width));
    const auto share_at = [&](V along) HWY_ATTR {
        const V within = hn::Max(zero, hn::Min(along, length_base));
        return hn::Max(zero, hn::Min(hn::Mul(hn::Sub(within, first), share), one));
    };
    // The ends of a capsule that stands upright on the base lie above each other: it is between both.
    const V t0 = hn::IfThenZeroElse(upright, share_at(first));
    const V t1 = hn::IfThenElse(upright, one, share_at(last));
    const V gap0 = hn::Add(first_gap, hn::Mul(t0, rise));
    const V gap1 = hn::Add(first_gap, hn::Mul(t1, rise));

    const M beside = hn::Or(hn::Lt(last, zero), hn::Gt(first, length_base));
    const V in_sight = hn::Add(seen, set(kRounding_m));
    const M hidden = hn::Or(beside, hn::Gt(hn::Min(gap0, gap1), in_sight));
    const M in_line = hn::And(hn::And(a.is_thin, b.is_thin), beside);
    const M apart = hn::Or(in_line, hn::Gt(most, about_equal));
    const M tie = hn::Le(hn::Abs(hn::Sub(edge_a.separation, edge_b.separation)), about_equal);
    const M by_corners = hn::And(near, hn::Or(points, hn::And(apart, hidden)));
    const M undecided = hn::AndNot(points, hn::And(by_corners, tie));

    const V reach = set(reach_m);
    const V reference_radius = hn::IfThenElse(flipped, b.radius, a.radius);
    const V incident_radius = hn::IfThenElse(flipped, a.radius, b.radius);
    const V half = set(0.5f);
    // On the facing edge: the base may be long, like a ground, and its ends far away and known less well.
    const Vec face_length = sub(face.from, face.to);
    const auto point_at = [&](V t, V gap) HWY_ATTR {
        const V to_middle = hn::Mul(half, hn::Sub(hn::Sub(reference_radius, incident_radius), gap));
        return add(add(face.to, scale(t, face_length)), scale(to_middle, normal));
    };
    const VI edge = hn::IfThenElse(hn::RebindMask(DI(), flipped), edge_b.index, edge_a.index);
    const VI id0 = feature_id(flipped, edge, face.index);
    const VI id1 = hn::Xor(id0, set_int(1));
    const M faces = hn::AndNot(by_corners, near);
    const M incident_is_point = hn::Or(hn::And(flipped, a.is_point), hn::AndNot(flipped, b.is_point));
    const M use0 = hn::And(faces, hn::Le(hn::Sub(gap0, radii), reach));
    const M reaches1 = hn::And(faces, hn::Le(hn::Sub(gap1, radii), reach));
    const M same = hn::Or(incident_is_point, hn::Eq(t0, t1));
    const M use1 = hn::AndNot(hn::And(use0, same), reaches1);

    const Vec point0 = point_at(t0, gap0);
    const Vec point1 = point_at(t1, gap1);
    const V separation0 = hn::Sub(gap0, radii);
    const V separation1 = hn::Sub(gap1, radii);
    const VI none = set_int(kNoFeature);
    const VI used_id1 = hn::IfThenElse(hn::RebindMask(DI(), use1), id1, none);
    Vec out_point = select(use0, point0, point1);
    V out_separation = hn::IfThenElse(use0, separation0, separation1);
    VI out_id = hn::IfThenElse(hn::RebindMask(DI(), use0), id0, used_id1);
    const VI second_id = hn::IfThenElse(hn::RebindMask(DI(), use0), used_id1, none);

    if (bits_of(by_corners) != 0) {
        const Corners corners = nearest_corners(a, b, count);
        const V distance = hn::Sqrt(corners.distance_squared);
        const M distinct = hn::Gt(distance, set(1e-12f));
        const V inverse = hn::Div(one, hn::IfThenElse(distinct, distance, one));
        const Vec straight = select(distinct, scale(inverse, corners.from_a_to_b), Vec{zero, one});
        const V separation = hn::Sub(distance, radii);
        // Midway between the surfaces.
        const V height = hn::Mul(half, hn::Add(distance, hn::Sub(a.radius, b.radius)));
        const M met = hn::And(by_corners, hn::Le(separation, reach));
        out_point = select(by_corners, add(corners.on_a, scale(height, straight)), out_point);
        out_separation = hn::IfThenElse(by_corners, separation, out_separation);
        out_id = hn::IfThenElse(hn::RebindMask(DI(), met), corners.id, out_id);
        store_axis(q_a, select(by_corners, straight, select(flipped, negate(normal), normal)),
                   hn::IfThenElse(by_corners, separation, hn::Sub(most, radii)), lane, out);
    }

    // Lanes without points have zeros there, so that every level leaves the same bits.
    const Vec world_point = rotate(q_a, out_point);
    const Vec world_point1 = rotate(q_a, point1);
    store(hn::IfThenElseZero(near, world_point.x), out.points[0].x, lane);
    store(hn::IfThenElseZero(near, world_point.y), out.points[0].y, lane);
    store(hn::IfThenElseZero(near, out_separation), out.points[0].separation, lane);
    store(out_id, out.points[0].id, lane);
    store(hn::IfThenElseZero(near, world_point1.x), out.points[1].x, lane);
    store(hn::IfThenElseZero(near, world_point1.y), out.points[1].y, lane);
    store(hn::IfThenElseZero(near, separation1), out.points[1].separation, lane);
    store(second_id, out.points[1].id, lane);
    return bits_of(undecided);
}

// The result is the greatest count.
HWY_INLINE int fill_rows(const Lanes<const Convex*>& shapes, HullRows& rows) {
    int most = 0;
    for (int lane = 0; lane < kLanes; ++lane) {
        const Convex& shape = *shapes[lane];
        rows.outlines[lane] = reinterpret_cast<const float*>(&shape.outline);
        rows.normals[lane] = &shape.normals[0].x;
        most = shape.count() > most ? shape.count() : most;
    }
    return most;
}

unsigned collide_hull_lanes(const PoseLanes& poses, const BoxLanes& offsets, const HullLanes& hulls,
                            float reach_m, ManifoldLanes& out) {
    HullRows rows_a;
    HullRows rows_b;
    const int count_a = fill_rows(hulls.a, rows_a);
    const int count_b = fill_rows(hulls.b, rows_b);
    const int count = count_a > count_b ? count_a : count_b;
    unsigned undecided = 0;
    for (int lane = 0; lane < kLanes; lane += kStep) {
        const unsigned part =
            count <= 2 ? collide_part<true>(poses, offsets, rows_a, rows_b, count, reach_m, lane, out)
                       : collide_part<false>(poses, offsets, rows_a, rows_b, count, reach_m, lane, out);
        undecided |= part << lane;
    }
    return undecided;
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(collide_hull_lanes);

unsigned collide_hull_lanes(const PoseLanes& poses, const BoxLanes& offsets, const HullLanes& hulls,
                            float reach_m, ManifoldLanes& out) {
    return HWY_DYNAMIC_DISPATCH(collide_hull_lanes)(poses, offsets, hulls, reach_m, out);
}

}  // namespace cairn::physics
#endif
