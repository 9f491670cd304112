// Box against box, a pair per SIMD lane. Glossary as in boxes.cpp: the reference is the box of which one side
// is nearest to the other box; everything is seen in its frame, from its centre.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collide/box_lanes.cpp"
#include "collide/box_lanes.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cairn/physics/tuning.h>

#include "base/simd_rows-inl.h"
#include "base/simd_vec-inl.h"

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

    // A is preferred when the two are about equal, so that the reference does not flip back and forth.
    const V about_equal = set(0.1f * tuning::kLinearSlop_m);
    const M flipped = hn::Gt(most_b, hn::Add(most_a, about_equal));
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
    const Vec low_end = add(offset, rotate(turn, add(face_center, along)));
    const Vec high_end = add(offset, rotate(turn, sub(face_center, along)));
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
    const V seen = hn::Add(hn::Max(sep.x, sep.y), set(1e-3f * tuning::kLinearSlop_m));
    const M hidden = hn::Or(beside, hn::Gt(hn::Min(gap0, gap1), seen));
    const V reach = set(reach_m);
    const M near = hn::Le(most, reach);
    const M undecided = hn::And(near, hn::And(hn::Gt(most, about_equal), hidden));

    const Vec q = select(flipped, q_b, q_a);
    const Vec center = select(flipped, center_b, center_a);
    const Vec world_normal = rotate(q, normal);
    const Vec point0 = add(
        center, rotate(q, add(scale(at0, tangent), scale(hn::Add(depth, hn::Mul(set(0.5f), gap0)), normal))));
    const Vec point1 = add(
        center, rotate(q, add(scale(at1, tangent), scale(hn::Add(depth, hn::Mul(set(0.5f), gap1)), normal))));
    const VI which = hn::IfThenElseZero(hn::RebindMask(DI(), flipped), set_int(1));
    const VI id = hn::Or(hn::Or(hn::ShiftLeft<12>(which), hn::ShiftLeft<8>(side_number(along_x, side))),
                         hn::ShiftLeft<4>(side_number(face_x, face_side)));
    const M use0 = hn::And(near, hn::Le(gap0, reach));
    const M use1 = hn::And(near, hn::Le(gap1, reach));
    const auto int0 = hn::RebindMask(DI(), use0);
    const auto int1 = hn::RebindMask(DI(), use1);
    const VI none = set_int(kNoFeature);
    const VI id1 = hn::IfThenElse(int1, hn::Or(id, set_int(1)), none);

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
    return bits_of(undecided);
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
