// feature_id of collide/manifold.h, a pair per SIMD lane. To be included as base/simd_rows-inl.h is, after
// it.
#if defined(CAIRN_PHYSICS_COLLIDE_FEATURE_ID_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CAIRN_PHYSICS_COLLIDE_FEATURE_ID_INL_H_
#undef CAIRN_PHYSICS_COLLIDE_FEATURE_ID_INL_H_
#else
#define CAIRN_PHYSICS_COLLIDE_FEATURE_ID_INL_H_
#endif

#include <hwy/highway.h>

#include "base/simd_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

// Of the first end; that of the last one differs in the lowest bit.
HWY_INLINE VI feature_id(M flipped, VI reference_edge, VI facing_edge) {
    const auto is_flipped = hn::RebindMask(DI(), flipped);
    const VI edge_a = hn::IfThenElse(is_flipped, facing_edge, reference_edge);
    const VI edge_b = hn::IfThenElse(is_flipped, reference_edge, facing_edge);
    const VI end = hn::IfThenElseZero(is_flipped, set_int(1));
    return hn::Or(hn::Or(hn::ShiftLeft<8>(edge_a), hn::ShiftLeft<4>(edge_b)), end);
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#endif
