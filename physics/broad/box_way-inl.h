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

/// Of start_of, along one axis.
HWY_INLINE V start_lower(V lower, V way) {
    return hn::Sub(lower, hn::Min(way, hn::Zero(D())));
}
HWY_INLINE V start_upper(V upper, V way) {
    return hn::Sub(upper, hn::Max(way, hn::Zero(D())));
}

/// Along one axis, by where both set out.
HWY_INLINE M keep_apart_along(V lower_a, V upper_a, V way_a, V lower_b, V upper_b, V way_b) {
    const V zero = hn::Zero(D());
    const V opening = hn::Sub(way_a, way_b);
    return hn::Or(hn::Gt(hn::Add(hn::Sub(lower_a, upper_b), hn::Min(opening, zero)), zero),
                  hn::Gt(hn::Sub(hn::Sub(lower_b, upper_a), hn::Max(opening, zero)), zero));
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#endif
