// Box against box, a pair per SIMD lane. Glossary as in boxes.cpp: the reference is the box of which one side
// is nearest to the other box; everything is seen in its frame, from its centre.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collide/box_lanes.cpp"
#include "collide/box_lanes.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/simd_rows-inl.h"
#include "base/simd_vec-inl.h"
#include "collide/feature_id-inl.h"
#include "collide/manifold.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

HWY_INLINE V clamp(V x, V limit) {
    return hn::Max(hn::Neg(limit), hn::Min(x, limit));
}
HWY_INLINE V sign(V x) {
    return hn::IfThenElse(hn::Lt(x, hn::Zero(D())), set(-1), set(1));
}
// The axis of a side: its unit normal, along x or along y.
HWY_INLINE Vec side_normal(M along_x, V side) {
    return {hn::IfThenElseZero(along_x, side), hn::IfThenZeroElse(along_x, side)};
}
HWY_INLINE VI side_number(M along_x, V side) {
    const VI axis = hn::IfThenZeroElse(hn::RebindMask(DI(), along_x), set_int(2));
    const M positive = hn::Gt(side, hn::Zero(D()));
    return hn::Add(axis, hn::IfThenElseZero(hn::RebindMask(DI(), positive), set_int(1)));
}

// Separations along the two axes of the reference.
HWY_INLINE Vec separations(Vec half, Vec other_half, Vec offset, V cosine, V sine) {
    const Vec extent{hn::Add(hn::Mul(other_half.x, cosine), hn::Mul(other_half.y, sine)),
                     hn::Add(hn::Mul(other_half.x, sine), hn::Mul(other_half.y, cosine))};
    return sub(sub({hn::Abs(offset.x), hn::Abs(offset.y)}, half), extent);
}

// Which corner of a box it is, counted as in its outline.
HWY_INLINE VI corner_number(Vec corner) {
    const M right = hn::Gt(corner.x, hn::Zero(D()));
    const M above = hn::Gt(corner.y, hn::Zero(D()));
    return hn::Add(hn::IfThenElseZero(hn::RebindMask(DI(), above), set_int(2)),
                   hn::IfThenElseZero(hn::RebindMask(DI(), hn::Xor(right, above)), set_int(1)));
}

// Whether nothing of a box is nearer to what lies in a direction from a corner than that corner.
HWY_INLINE M is_nearest(Vec corner, Vec direction) {
    const auto past = [](V at, V way) HWY_ATTR { return hn::Gt(hn::Mul(sign(at), way), set(kRounding_m)); };
    return hn::And(past(corner.x, direction.x), past(corner.y, direction.y));
}

// One corner near another. All as the reference sees it, but the corner of the other as that does.
struct BoxCorners {
    Vec of_reference;
    Vec of_other;
    Vec between;  // from the corner of the reference to the other's
    V distance_squared;
};

HWY_INLINE unsigned collide_part(const PoseLanes& poses, const BoxLanes& boxes, float reach_m, int lane,
                                 ManifoldLanes& out) {
    const Vec q_a{load(poses.cos_a, lane), load(poses.sin_a, lane)};
    const Vec q_b{load(poses.cos_b, lane), load(poses.sin_b, lane)};
    const Vec half_a{load(boxes.half_ax, lane), load(boxes.half_ay, lane)};
    const Vec half_b{load(boxes.half_bx, lane), load(boxes.half_by, lane)};
    const Vec d{load(poses.dx, lane), load(poses.dy, lane)};
    const Vec center_a = rotate(q_a, {load(boxes.offset_ax, lane), load(boxes.offset_ay, lane)});
    const Vec center_b = add(d, rotate(q_b, {load(boxes.offset_bx, lane), load(boxes.offset_by, lane)}));
    const Vec between = sub(center_b, center_a);
    const V cosine = hn::Add(hn::Mul(q_a.x, q_b.x), hn::Mul(q_a.y, q_b.y));
    const V sine = hn::Sub(hn::Mul(q_a.x, q_b.y), hn::Mul(q_a.y, q_b.x));
    const V abs_cosine = hn::Abs(cosine);
    const V abs_sine = hn::Abs(sine);

    const Vec offset_a = inverse_rotate(q_a, between);
    const Vec offset_b = negate(inverse_rotate(q_b, between));
    const Vec sep_a = separations(half_a, half_b, offset_a, abs_cosine, abs_sine);
    const Vec sep_b = separations(half_b, half_a, offset_b, abs_cosine, abs_sine);
    const V most_a = hn::Max(sep_a.x, sep_a.y);
    const V most_b = hn::Max(sep_b.x, sep_b.y);
    const V most = hn::Max(most_a, most_b);

    const M flipped = hn::Gt(most_b, hn::Add(most_a, set(kRounding_m)));
    const Vec half = select(flipped, half_b, half_a);
    const Vec other_half = select(flipped, half_a, half_b);
    const Vec offset = select(flipped, offset_b, offset_a);
    const Vec sep = select(flipped, sep_b, sep_a);
    const Vec turn{cosine, hn::IfThenElse(flipped, hn::Neg(sine), sine)};  // of the other

    const M along_x = hn::Ge(sep.x, sep.y);
    const V side = sign(hn::IfThenElse(along_x, offset.x, offset.y));
    const Vec normal = side_normal(along_x, side);
    const Vec tangent = left(normal);
    const V depth = hn::IfThenElse(along_x, half.x, half.y);
    const V width = hn::IfThenElse(along_x, half.y, half.x);

    // The facing side of the other, from its low to its high end along the tangent.
    const Vec facing = inverse_rotate(turn, negate(normal));
    const M face_x = hn::Gt(hn::Abs(facing.x), hn::Abs(facing.y));
    const V face_side = sign(hn::IfThenElse(face_x, facing.x, facing.y));
    const Vec face_normal = side_normal(face_x, face_side);
    const Vec face_center{hn::Mul(face_normal.x, other_half.x), hn::Mul(face_normal.y, other_half.y)};
    const Vec along = scale(hn::IfThenElse(face_x, other_half.y, other_half.x), left(face_normal));
    const Vec low_corner = add(face_center, along);
    const Vec high_corner = sub(face_center, along);
    const Vec low_end = add(offset, rotate(turn, low_corner));
    const Vec high_end = add(offset, rotate(turn, high_corner));
    const V low = dot(low_end, tangent);
    const V high = dot(high_end, tangent);
    const V low_gap = hn::Sub(dot(low_end, normal), depth);
    const V high_gap = hn::Sub(dot(high_end, normal), depth);

    const V slope = hn::Div(hn::Sub(high_gap, low_gap), hn::Max(hn::Sub(high, low), set(1e-9f)));
    const V at0 = clamp(low, width);
    const V at1 = clamp(high, width);
    const V gap0 = hn::Add(low_gap, hn::Mul(hn::Sub(at0, low), slope));
    const V gap1 = hn::Sub(high_gap, hn::Mul(hn::Sub(high, at1), slope));

    const M beside = hn::Or(hn::Lt(high, hn::Neg(width)), hn::Gt(low, width));
    const V seen = hn::Add(hn::Max(sep.x, sep.y), set(kRounding_m));
    const M hidden = hn::Or(beside, hn::Gt(hn::Min(gap0, gap1), seen));
    const V reach = set(reach_m);
    const M near = hn::Le(most, reach);
    const M undecided = hn::And(near, hn::And(hn::Gt(most, set(kAboutEqual_m)), hidden));

    const Vec q = select(flipped, q_b, q_a);
    const Vec center = select(flipped, center_b, center_a);
    const Vec world_normal = rotate(q, normal);
    const Vec point0 = add(
        center, rotate(q, add(scale(at0, tangent), scale(hn::Add(depth, hn::Mul(set(0.5f), gap0)), normal))));
    const Vec point1 = add(
        center, rotate(q, add(scale(at1, tangent), scale(hn::Add(depth, hn::Mul(set(0.5f), gap1)), normal))));
    const VI id = feature_id(flipped, side_number(along_x, side), side_number(face_x, face_side));
    const M use0 = hn::And(near, hn::Le(gap0, reach));
    const M use1 = hn::And(near, hn::Le(gap1, reach));
    const auto int0 = hn::RebindMask(DI(), use0);
    const auto int1 = hn::RebindMask(DI(), use1);
    const VI none = set_int(kNoFeature);
    const VI id1 = hn::IfThenElse(int1, hn::Xor(id, set_int(1)), none);

    store(hn::IfThenElse(flipped, hn::Neg(world_normal.x), world_normal.x), out.normal_x, lane);
    store(hn::IfThenElse(flipped, hn::Neg(world_normal.y), world_normal.y), out.normal_y, lane);
    store(hn::Max(sep.x, sep.y), out.gap, lane);
    const Vec first = select(use0, point0, point1);
    store(first.x, out.points[0].x, lane);
    store(first.y, out.points[0].y, lane);
    store(hn::IfThenElse(use0, gap0, gap1), out.points[0].separation, lane);
    store(hn::IfThenElse(int0, id, id1), out.points[0].id, lane);
    store(point1.x, out.points[1].x, lane);
    store(point1.y, out.points[1].y, lane);
    store(gap1, out.points[1].separation, lane);
    store(hn::IfThenElse(int0, id1, none), out.points[1].id, lane);
    if (bits_of(undecided) == 0) return 0;

    // Between two corners, where each of them is the nearest that its box has.
    const auto meet = [&](Vec end, V at, Vec corner) HWY_ATTR {
        const Vec of_reference = add(scale(depth, normal), scale(hn::Mul(sign(at), width), tangent));
        const Vec way = sub(end, of_reference);
        return BoxCorners{of_reference, corner, way, dot(way, way)};
    };
    const BoxCorners by_low = meet(low_end, low, low_corner);
    const BoxCorners by_high = meet(high_end, high, high_corner);
    const M low_is_nearer = hn::Lt(by_low.distance_squared, by_high.distance_squared);
    const Vec of_reference = select(low_is_nearer, by_low.of_reference, by_high.of_reference);
    const Vec of_other = select(low_is_nearer, by_low.of_other, by_high.of_other);
    const Vec way = select(low_is_nearer, by_low.between, by_high.between);
    const V distance = hn::Sqrt(hn::Min(by_low.distance_squared, by_high.distance_squared));
    const M nearest =
        hn::And(is_nearest(of_reference, way), is_nearest(of_other, negate(inverse_rotate(turn, way))));
    const M corners = hn::And(undecided, hn::And(nearest, hn::Gt(distance, set(kAllButTouching_m))));
    const Vec straight = rotate(q, scale(hn::Div(set(1), distance), way));
    const Vec middle = add(center, rotate(q, add(of_reference, scale(set(0.5f), way))));
    const VI of_a =
        hn::IfThenElse(hn::RebindMask(DI(), flipped), corner_number(of_other), corner_number(of_reference));
    const VI of_b =
        hn::IfThenElse(hn::RebindMask(DI(), flipped), corner_number(of_reference), corner_number(of_other));
    const VI corner_id = hn::Or(hn::Or(set_int(1 << 13), hn::ShiftLeft<4>(of_a)), of_b);
    const auto replace = [&](V value, Lanes<float>& lanes) HWY_ATTR {
        store(hn::IfThenElse(corners, value, load(lanes, lane)), lanes, lane);
    };
    const auto replace_id = [&](VI value, Lanes<std::int32_t>& lanes) HWY_ATTR {
        store(hn::IfThenElse(hn::RebindMask(DI(), corners), value, load(lanes, lane)), lanes, lane);
    };
    replace(hn::IfThenElse(flipped, hn::Neg(straight.x), straight.x), out.normal_x);
    replace(hn::IfThenElse(flipped, hn::Neg(straight.y), straight.y), out.normal_y);
    replace(distance, out.gap);
    replace(middle.x, out.points[0].x);
    replace(middle.y, out.points[0].y);
    replace(distance, out.points[0].separation);
    replace_id(hn::IfThenElse(hn::RebindMask(DI(), hn::Le(distance, reach)), corner_id, none),
               out.points[0].id);
    replace_id(none, out.points[1].id);
    return bits_of(hn::AndNot(corners, undecided));
}

unsigned collide_box_lanes(const PoseLanes& poses, const BoxLanes& boxes, float reach_m, ManifoldLanes& out) {
    unsigned undecided = 0;
    for (int lane = 0; lane < kLanes; lane += kStep) {
        undecided |= collide_part(poses, boxes, reach_m, lane, out) << lane;
    }
    return undecided;
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(collide_box_lanes);

unsigned collide_box_lanes(const PoseLanes& poses, const BoxLanes& boxes, float reach_m, ManifoldLanes& out) {
    return HWY_DYNAMIC_DISPATCH(collide_box_lanes)(poses, boxes, reach_m, out);
}

}  // namespace cairn::physics
#endif
