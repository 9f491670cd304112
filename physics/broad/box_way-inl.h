// keep_apart of broad/box_way.h, one pair per SIMD lane and to the last bit. To be included as
// base/simd_rows-inl.h is, after it.
#if defined(CAIRN_PHYSICS_BROAD_BOX_WAY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CAIRN_PHYSICS_BROAD_BOX_WAY_INL_H_
#undef CAIRN_PHYSICS_BROAD_BOX_WAY_INL_H_
#else
#define CAIRN_PHYSICS_BROAD_BOX_WAY_INL_H_
#endif

#include <hwy/highway.h>

#include "base/simd_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

HWY_INLINE V least_overlap(V way_a, V way_b) {
    const V zero = hn::Zero(D());
    return hn::Sub(hn::Sub(hn::Min(way_a, zero), hn::Max(way_b, zero)), hn::Min(hn::Sub(way_a, way_b), zero));
}

/// Along one axis.
HWY_INLINE M keep_apart_along(V lower_a, V upper_a, V way_a, V lower_b, V upper_b, V way_b) {
    return hn::Or(hn::Gt(hn::Sub(lower_a, upper_b), least_overlap(way_a, way_b)),
                  hn::Gt(hn::Sub(lower_b, upper_a), least_overlap(way_b, way_a)));
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#endif
