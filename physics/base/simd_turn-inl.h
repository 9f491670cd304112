// Rotation::from_small_angle, one angle per SIMD lane and to the last bit. To be included as simd_rows-inl.h
// is, after simd_vec-inl.h.
#if defined(CAIRN_PHYSICS_BASE_SIMD_TURN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CAIRN_PHYSICS_BASE_SIMD_TURN_INL_H_
#undef CAIRN_PHYSICS_BASE_SIMD_TURN_INL_H_
#else
#define CAIRN_PHYSICS_BASE_SIMD_TURN_INL_H_
#endif

#include <bit>
#include <hwy/highway.h>

#include "base/simd_rows-inl.h"
#include "base/simd_vec-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

// Cosine and sine.
HWY_INLINE Vec small_turn(V angle) {
    const V one = set(1);
    const V z = hn::Mul(angle, angle);
    V sine = hn::Sub(set(1.0f / 120), hn::Mul(z, set(1.0f / 5040)));
    sine = hn::Add(set(-1.0f / 6), hn::Mul(z, sine));
    sine = hn::Mul(angle, hn::Add(one, hn::Mul(z, sine)));
    V cosine = hn::Add(set(-1.0f / 720), hn::Mul(z, set(1.0f / 40320)));
    cosine = hn::Add(set(1.0f / 24), hn::Mul(z, cosine));
    cosine = hn::Add(set(-0.5f), hn::Mul(z, cosine));
    cosine = hn::Add(one, hn::Mul(z, cosine));
    const unsigned exact = bits_of(hn::Not(hn::Le(hn::Abs(angle), set(0.5f))));
    if (HWY_LIKELY(exact == 0)) return {cosine, sine};
    alignas(32) std::array<float, kLanes> angles, cosines, sines;
    hn::Store(angle, D(), angles.data());
    hn::Store(cosine, D(), cosines.data());
    hn::Store(sine, D(), sines.data());
    for (unsigned lanes = exact; lanes != 0; lanes &= lanes - 1) {
        const int lane = std::countr_zero(lanes);
        const Rotation turn = Rotation::from_small_angle(angles[lane]);
        cosines[lane] = turn.c;
        sines[lane] = turn.s;
    }
    return {hn::Load(D(), cosines.data()), hn::Load(D(), sines.data())};
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#endif
