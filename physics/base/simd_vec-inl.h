// Vectors of the plane, one per SIMD lane. To be included as simd_rows-inl.h is, after it.
#if defined(CAIRN_PHYSICS_BASE_SIMD_VEC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CAIRN_PHYSICS_BASE_SIMD_VEC_INL_H_
#undef CAIRN_PHYSICS_BASE_SIMD_VEC_INL_H_
#else
#define CAIRN_PHYSICS_BASE_SIMD_VEC_INL_H_
#endif

#include <hwy/highway.h>

#include <cairn/physics/math.h>

#include "base/simd_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

struct Vec {
    V x, y;
};

#if HWY_TARGET == HWY_SCALAR

// Vectors that stand anywhere, by number.
HWY_INLINE Vec load_vecs(const Vec2* vectors, const std::int32_t* index) {
    return {set(vectors[index[0]].x), set(vectors[index[0]].y)};
}

#else

// Of x and y side by side: pair(i) is that of lane i.
template <class PairOf>
HWY_INLINE Vec from_pairs(const PairOf& pair) {
    const hn::FixedTag<float, 4> quad;
    const auto both = [&](int i) HWY_ATTR {  // x y of lanes i and i + 1
        const auto low = hn::Combine(quad, pair(i + 1), pair(i));
#if HWY_MAX_BYTES >= 32
        return hn::Combine(D(), hn::Combine(quad, pair(i + 5), pair(i + 4)), low);
#else
        return low;
#endif
    };
    const V first = both(0);
    const V second = both(2);
    const V even = hn::InterleaveLower(D(), first, second);  // x0 x2 y0 y2
    const V odd = hn::InterleaveUpper(D(), first, second);   // x1 x3 y1 y3
    return {hn::InterleaveLower(D(), even, odd), hn::InterleaveUpper(D(), even, odd)};
}

// Vectors that stand anywhere, by number.
HWY_INLINE Vec load_vecs(const Vec2* vectors, const std::int32_t* index) {
    const hn::FixedTag<float, 2> two;
    return from_pairs([&](int i) HWY_ATTR { return hn::LoadU(two, &vectors[index[i]].x); });
}

#endif

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

// As std::min and std::max, of zeros too.
HWY_INLINE V least(V a, V b) {
    return hn::IfThenElse(hn::Lt(b, a), b, a);
}
HWY_INLINE V greatest(V a, V b) {
    return hn::IfThenElse(hn::Lt(a, b), b, a);
}
HWY_INLINE Vec least(Vec a, Vec b) {
    return {least(a.x, b.x), least(a.y, b.y)};
}
HWY_INLINE Vec greatest(Vec a, Vec b) {
    return {greatest(a.x, b.x), greatest(a.y, b.y)};
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
