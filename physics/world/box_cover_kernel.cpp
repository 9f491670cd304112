// Bounds of turned shapes, brought into the world in double and rounded outward.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "world/box_cover_kernel.cpp"
#include "world/box_cover_kernel.h"

#include <cstddef>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cairn/physics/tuning.h>

#include "base/simd_rows-inl.h"
#include "base/simd_turn-inl.h"
#include "base/simd_vec-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

using DD = hn::CappedTag<double, kLanes / 2>;
using DF = hn::Rebind<float, DD>;
using DFI = hn::RebindToSigned<DF>;

constexpr int kDoubleStep = static_cast<int>(hn::MaxLanes(DD()));

struct Bounds {
    Vec lower, upper;
};

// Where a shape begins and where it ends.
struct BothBounds {
    Bounds start, end;
};

HWY_INLINE Bounds select(M mask, const Bounds& yes, const Bounds& no) {
    return {select(mask, yes.lower, no.lower), select(mask, yes.upper, no.upper)};
}

template <class T>
HWY_INLINE Columns load_from(const Lanes<T*>& rows, int lane, std::size_t offset) {
    const float* from[kStep];
    for (int i = 0; i < kStep; ++i)
        from[i] = reinterpret_cast<const float*>(reinterpret_cast<const char*>(rows[lane + i]) + offset);
    return load_rows(from, 0);
}

HWY_INLINE Vec load_centers(const Lanes<const Vec2*>& centers, int lane) {
    alignas(32) float x[kStep];
    alignas(32) float y[kStep];
    for (int i = 0; i < kStep; ++i) {
        x[i] = centers[lane + i]->x;
        y[i] = centers[lane + i]->y;
    }
    return {hn::Load(D(), x), hn::Load(D(), y)};
}

HWY_INLINE Bounds bounds_of_box(Vec q, Vec centroid, Vec half_size) {
    const Vec center = rotate(q, centroid);
    const V c = hn::Abs(q.x);
    const V s = hn::Abs(q.y);
    const Vec half{hn::Add(hn::Mul(c, half_size.x), hn::Mul(s, half_size.y)),
                   hn::Add(hn::Mul(s, half_size.x), hn::Mul(c, half_size.y))};
    return {sub(center, half), add(center, half)};
}

template <bool kMoving>
HWY_INLINE BothBounds bounds_of_boxes(const CoverLanes& lanes, int lane, Vec start, Vec end) {
    static_assert(offsetof(Convex, half_size) == offsetof(Convex, centroid) + sizeof(Vec2));
    const Columns box = load_from(lanes.shapes, lane, offsetof(Convex, centroid));
    BothBounds both;
    both.start = bounds_of_box(start, {box.x, box.y}, {box.z, box.u});
    if constexpr (kMoving) both.end = bounds_of_box(end, {box.x, box.y}, {box.z, box.u});
    return both;
}

HWY_INLINE void widen(Bounds& bounds, M has_point, Vec point) {
    bounds.lower = select(has_point, least(bounds.lower, point), bounds.lower);
    bounds.upper = select(has_point, greatest(bounds.upper, point), bounds.upper);
}

HWY_INLINE void round_off(Bounds& bounds, V radius) {
    bounds = {{hn::Sub(bounds.lower.x, radius), hn::Sub(bounds.lower.y, radius)},
              {hn::Add(bounds.upper.x, radius), hn::Add(bounds.upper.y, radius)}};
}

template <bool kMoving>
HWY_INLINE BothBounds bounds_of_points(const CoverLanes& lanes, int lane, Vec start, Vec end) {
    static_assert(kMaxPolygonVertices % 2 == 0, "two points are one row");
    BothBounds both;
    const VI count = load(lanes.count, lane);
    for (int i = 0; i < lanes.most_points; i += 2) {
        const Columns two = load_from(lanes.shapes, lane,
                                      offsetof(Convex, outline) + offsetof(Outline, points_m) +
                                          static_cast<std::size_t>(i) * sizeof(Vec2));
        const Vec first{two.x, two.y};
        const Vec second{two.z, two.u};
        if (i == 0) {
            both.start.lower = both.start.upper = rotate(start, first);
            if constexpr (kMoving) both.end.lower = both.end.upper = rotate(end, first);
        } else {
            const M has_first = hn::RebindMask(D(), hn::Gt(count, set_int(i)));
            widen(both.start, has_first, rotate(start, first));
            if constexpr (kMoving) widen(both.end, has_first, rotate(end, first));
        }
        const M has_second = hn::RebindMask(D(), hn::Gt(count, set_int(i + 1)));
        widen(both.start, has_second, rotate(start, second));
        if constexpr (kMoving) widen(both.end, has_second, rotate(end, second));
    }
    const V radius = load(lanes.radius, lane);
    round_off(both.start, radius);
    if constexpr (kMoving) round_off(both.end, radius);
    return both;
}

template <bool kMoving>
HWY_INLINE BothBounds bounds_of_shapes(const CoverLanes& lanes, int lane, Vec start, Vec end) {
    const unsigned in_part = ((1u << kStep) - 1) << lane;
    const unsigned boxes = lanes.right_boxes & in_part;
    if (boxes == in_part) return bounds_of_boxes<kMoving>(lanes, lane, start, end);
    const BothBounds of_points = bounds_of_points<kMoving>(lanes, lane, start, end);
    if (boxes == 0) return of_points;
    const BothBounds of_boxes = bounds_of_boxes<kMoving>(lanes, lane, start, end);
    const M is_box = wanted_lanes(boxes, lane);
    BothBounds both;
    both.start = select(is_box, of_boxes.start, of_points.start);
    if constexpr (kMoving) both.end = select(is_box, of_boxes.end, of_points.end);
    return both;
}

// round_down of base/aabb.h.
HWY_INLINE hn::Vec<DF> rounded_down(hn::Vec<DD> x) {
    const DF df;
    const DFI bits_tag;
    const auto nearest = hn::DemoteTo(df, x);
    const auto above = hn::IfThenElseZero(hn::Gt(hn::PromoteTo(DD(), nearest), x), hn::Set(DD(), 1.0));
    const auto is_above = hn::Ne(hn::DemoteTo(df, above), hn::Zero(df));
    const auto bits = hn::BitCast(bits_tag, nearest);
    const auto away_from_zero = hn::Or(hn::ShiftRight<31>(bits), hn::Set(bits_tag, 1));
    return hn::IfThenElse(is_above, hn::BitCast(df, hn::Sub(bits, away_from_zero)), nearest);
}

// make_aabb of base/aabb.h along one axis: origins are the centres of mass and what leads from there to the
// bodies' own.
HWY_INLINE void place_along(const double* center, V to_origin, V& lower, V& upper) {
    alignas(32) float offset[kStep];
    alignas(32) float low[kStep];
    alignas(32) float high[kStep];
    hn::Store(to_origin, D(), offset);
    hn::Store(lower, D(), low);
    hn::Store(upper, D(), high);
    const DD dd;
    const DF df;
    for (int i = 0; i < kStep; i += kDoubleStep) {
        const auto origin = hn::Add(hn::Load(dd, center + i), hn::PromoteTo(dd, hn::Load(df, offset + i)));
        hn::Store(rounded_down(hn::Add(origin, hn::PromoteTo(dd, hn::Load(df, low + i)))), df, low + i);
        const auto end = hn::Add(origin, hn::PromoteTo(dd, hn::Load(df, high + i)));
        hn::Store(hn::Neg(rounded_down(hn::Neg(end))), df, high + i);
    }
    lower = hn::Load(D(), low);
    upper = hn::Load(D(), high);
}

HWY_INLINE Bounds grown(const Bounds& bounds, V by) {
    return {{hn::Sub(bounds.lower.x, by), hn::Sub(bounds.lower.y, by)},
            {hn::Add(bounds.upper.x, by), hn::Add(bounds.upper.y, by)}};
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE void store_boxes(const Lanes<Aabb*>& boxes, int lane, const Bounds& b) {
    *boxes[lane] = {{hn::GetLane(b.lower.x), hn::GetLane(b.lower.y)},
                    {hn::GetLane(b.upper.x), hn::GetLane(b.upper.y)}};
}

#else

HWY_INLINE void store_boxes(const Lanes<Aabb*>& boxes, int lane, const Bounds& b) {
    static_assert(sizeof(Aabb) == 16);
    Columns c{b.lower.x, b.lower.y, b.upper.x, b.upper.y};
    transpose(c.x, c.y, c.z, c.u);
    const hn::FixedTag<float, 4> quad;
    const V rows[] = {c.x, c.y, c.z, c.u};
    for (int i = 0; i < 4; ++i) {
#if HWY_MAX_BYTES >= 32
        hn::StoreU(hn::LowerHalf(quad, rows[i]), quad, &boxes[lane + i]->lower.x);
        hn::StoreU(hn::UpperHalf(quad, rows[i]), quad, &boxes[lane + i + 4]->lower.x);
#else
        hn::StoreU(rows[i], quad, &boxes[lane + i]->lower.x);
#endif
    }
}

#endif

template <bool kMoving>
HWY_INLINE unsigned cover_part(CoverLanes& lanes, int lane) {
    const Columns turns = load_from(lanes.places, lane, offsetof(Place, rotation));
    const Vec start_turn{turns.x, turns.y};
    const Vec to_center = rotate(start_turn, load_centers(lanes.centers, lane));
    Bounds all;
    if constexpr (kMoving) {
        const Vec turn = small_turn(load(lanes.turn, lane));
        // Rotation's product.
        const Vec end_turn{hn::Sub(hn::Mul(turn.x, turns.x), hn::Mul(turn.y, turns.y)),
                           hn::Add(hn::Mul(turn.y, turns.x), hn::Mul(turn.x, turns.y))};
        const BothBounds both = bounds_of_shapes<true>(lanes, lane, start_turn, end_turn);
        const Vec swing = sub(to_center, rotate(end_turn, load_centers(lanes.centers, lane)));
        const Vec way{load(lanes.way_x, lane), load(lanes.way_y, lane)};
        const M goes_along = wanted_lanes(lanes.going_along, lane);
        const Vec zero{hn::Zero(D()), hn::Zero(D())};
        const Vec end = select(goes_along, swing, add(way, swing));
        const Vec along_lower = select(goes_along, least(zero, way), zero);
        const Vec along_upper = select(goes_along, greatest(zero, way), zero);
        all.lower = add(least(both.start.lower, add(both.end.lower, end)), along_lower);
        all.upper = add(greatest(both.start.upper, add(both.end.upper, end)), along_upper);
    } else {
        all = bounds_of_shapes<false>(lanes, lane, start_turn, start_turn).start;
    }
    alignas(32) double center_x[kStep];
    alignas(32) double center_y[kStep];
    for (int i = 0; i < kStep; ++i) {
        center_x[i] = lanes.places[lane + i]->center.x;
        center_y[i] = lanes.places[lane + i]->center.y;
    }
    place_along(center_x, hn::Neg(to_center.x), all.lower.x, all.upper.x);
    place_along(center_y, hn::Neg(to_center.y), all.lower.y, all.upper.y);
    all = grown(all, load(lanes.room, lane));
    const Bounds reach = grown(all, set(tuning::kAabbReach_m));
    const Columns box = load_from(lanes.boxes, lane, 0);
    const M holds = hn::And(hn::And(hn::Le(box.x, reach.lower.x), hn::Le(box.y, reach.lower.y)),
                            hn::And(hn::Le(reach.upper.x, box.z), hn::Le(reach.upper.y, box.u)));
    const M anew = hn::Or(hn::Not(holds), wanted_lanes(lanes.going_along, lane));
    const Bounds now = select(anew, grown(all, load(lanes.margin, lane)), {{box.x, box.y}, {box.z, box.u}});
    store_boxes(lanes.boxes, lane, now);
    const Vec low = sub(reach.lower, now.lower);
    const Vec high = sub(now.upper, reach.upper);
    store(least(least(low.x, low.y), least(high.x, high.y)), lanes.slack, lane);
    return bits_of(anew) << lane;
}

LaneBits cover_boxes(CoverLanes& lanes, bool moving) {
    unsigned anew = 0;
    for (int lane = 0; lane < kLanes; lane += kStep)
        anew |= moving ? cover_part<true>(lanes, lane) : cover_part<false>(lanes, lane);
    return static_cast<LaneBits>(anew);
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(cover_boxes);

LaneBits cover_boxes(CoverLanes& lanes, bool moving) {
    return HWY_DYNAMIC_DISPATCH(cover_boxes)(lanes, moving);
}

}  // namespace cairn::physics
#endif
