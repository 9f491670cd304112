// Boxes of pairs, gathered for SIMD.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "broad/parted_pairs.cpp"
#include "broad/parted_pairs.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/simd_rows-inl.h"
#include "base/simd_vec-inl.h"
#include "broad/box_way-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

struct BoxColumns {
    Vec lower;
    Vec upper;
};

HWY_INLINE BoxColumns load_boxes(const Aabb* boxes, const std::int32_t* items) {
    static_assert(sizeof(Aabb) == 16 && offsetof(Aabb, upper) == 8);
    const float* from[kStep];
    for (int i = 0; i < kStep; ++i) from[i] = &boxes[items[i]].lower.x;
    const Columns c = load_rows(from, 0);
    return {{c.x, c.y}, {c.z, c.u}};
}

HWY_INLINE M do_overlap(const BoxColumns& a, const BoxColumns& b) {
    const M x = hn::And(hn::Le(a.lower.x, b.upper.x), hn::Le(b.lower.x, a.upper.x));
    const M y = hn::And(hn::Le(a.lower.y, b.upper.y), hn::Le(b.lower.y, a.upper.y));
    return hn::And(x, y);
}

HWY_INLINE M keep_apart(const BoxColumns& a, Vec way_a, const BoxColumns& b, Vec way_b) {
    const M x = keep_apart_along(start_lower(a.lower.x, way_a.x), start_upper(a.upper.x, way_a.x), way_a.x,
                                 start_lower(b.lower.x, way_b.x), start_upper(b.upper.x, way_b.x), way_b.x);
    const M y = keep_apart_along(start_lower(a.lower.y, way_a.y), start_upper(a.upper.y, way_a.y), way_a.y,
                                 start_lower(b.lower.y, way_b.y), start_upper(b.upper.y, way_b.y), way_b.y);
    return hn::Or(x, y);
}

void parted_lanes(const Aabb* boxes, const Vec2* ways, const Lanes<std::int32_t>& item_a,
                  const Lanes<std::int32_t>& item_b, unsigned lanes, unsigned& parted) {
    parted = 0;
    for (int lane = 0; lane < kLanes; lane += kStep) {
        const M wanted = wanted_lanes(lanes, lane);
        alignas(32) std::int32_t a[kLanes];
        alignas(32) std::int32_t b[kLanes];
        load_wanted(item_a, wanted, lane, a);
        load_wanted(item_b, wanted, lane, b);
        const BoxColumns box_a = load_boxes(boxes, a);
        const BoxColumns box_b = load_boxes(boxes, b);
        M apart = hn::Not(do_overlap(box_a, box_b));
        if (ways != nullptr)
            apart = hn::Or(apart, keep_apart(box_a, load_vecs(ways, a), box_b, load_vecs(ways, b)));
        parted |= bits_of(apart) << lane;
    }
    parted &= lanes;
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(parted_lanes);

unsigned parted_lanes(std::span<const Aabb> boxes, std::span<const Vec2> ways,
                      const Lanes<std::int32_t>& item_a, const Lanes<std::int32_t>& item_b, unsigned lanes) {
    if (lanes == 0) return 0;
    unsigned parted = 0;
    HWY_DYNAMIC_DISPATCH(parted_lanes)
    (boxes.data(), ways.empty() ? nullptr : ways.data(), item_a, item_b, lanes, parted);
    return parted;
}

}  // namespace cairn::physics
#endif
