// Vectors of the plane, one per SIMD lane. To be included as simd_rows-inl.h is, after it.
#if defined(CAIRN_PHYSICS_BASE_SIMD_VEC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CAIRN_PHYSICS_BASE_SIMD_VEC_INL_H_
#undef CAIRN_PHYSICS_BASE_SIMD_VEC_INL_H_
#else
#define CAIRN_PHYSICS_BASE_SIMD_VEC_INL_H_
#endif

#include <hwy/highway.h>

#include "base/simd_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

struct Vec {
    V x, y;
};

HWY_INLINE V dot(Vec a, Vec b) {
    return hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y));
}
HWY_INLINE Vec add(Vec a, Vec b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y)};
}
HWY_INLINE Vec sub(Vec a, Vec b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y)};
}
HWY_INLINE Vec scale(V s, Vec a) {
    return {hn::Mul(s, a.x), hn::Mul(s, a.y)};
}
HWY_INLINE Vec negate(Vec a) {
    return {hn::Neg(a.x), hn::Neg(a.y)};
}
HWY_INLINE Vec left(Vec a) {
    return {hn::Neg(a.y), a.x};
}
HWY_INLINE Vec select(M m, Vec yes, Vec no) {
    return {hn::IfThenElse(m, yes.x, no.x), hn::IfThenElse(m, yes.y, no.y)};
}
HWY_INLINE Vec rotate(Vec q, Vec a) {
    return {hn::Sub(hn::Mul(q.x, a.x), hn::Mul(q.y, a.y)), hn::Add(hn::Mul(q.y, a.x), hn::Mul(q.x, a.y))};
}
HWY_INLINE Vec inverse_rotate(Vec q, Vec a) {
    return {hn::Add(hn::Mul(q.x, a.x), hn::Mul(q.y, a.y)), hn::Sub(hn::Mul(q.x, a.y), hn::Mul(q.y, a.x))};
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#endif
