// Laws along one direction of blocks that have them: those at the head of joint_solver.cpp. Glossary: J v
// speed, mass 1/K. To be included as joint_block-inl.h.
#if defined(CAIRN_PHYSICS_RESOLVE_JOINTS_JOINT_LAWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CAIRN_PHYSICS_RESOLVE_JOINTS_JOINT_LAWS_INL_H_
#undef CAIRN_PHYSICS_RESOLVE_JOINTS_JOINT_LAWS_INL_H_
#else
#define CAIRN_PHYSICS_RESOLVE_JOINTS_JOINT_LAWS_INL_H_
#endif

#include "base/simd_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

struct SoftLanes {
    V bias_rate, mass_scale, impulse_scale;
};

template <class Block>
HWY_INLINE SoftLanes softness_of(const Block& block, int lane) {
    return {load(block.bias_rate, lane), load(block.mass_scale, lane), load(block.impulse_scale, lane)};
}

HWY_INLINE SoftLanes rigid_lanes() {
    return {hn::Zero(D()), set(1), hn::Zero(D())};
}

template <class Block>
HWY_INLINE M crowded_lanes(const Block& block, int lane) {
    return hn::Gt(load(block.crowded, lane), hn::Zero(D()));
}

// Crowded springs start from nothing.
template <class Block>
HWY_INLINE void forget_crowded_spring(Block& block, int lane) {
    const V impulse = load(block.spring_impulse, lane);
    store(hn::IfThenZeroElse(crowded_lanes(block, lane), impulse), block.spring_impulse, lane);
}

// Of the springs in the wanted lanes; `share` is that of K which answers. The result is by how much their
// impulses changed.
template <class Block>
HWY_INLINE V solve_spring(Block& block, int lane, M wanted_lanes, V mass, V speed, V q, V share) {
    const V d1 = load(block.spring_d1, lane);
    const V answering = hn::Mul(share, d1);
    const V old = load(block.spring_impulse, lane);
    const V error = hn::Sub(q, load(block.spring_target, lane));
    const V force = hn::Add(
        hn::Add(hn::Mul(d1, speed), hn::Mul(load(block.spring_d0, lane), load(block.speed_before, lane))),
        hn::Mul(load(block.spring_stiffness, lane), error));
    const V solved =
        hn::Div(hn::Sub(hn::Mul(answering, old), hn::Mul(mass, force)), hn::Add(set(1), answering));
    const V wanted = hn::IfThenElse(wanted_lanes, solved, old);
    store(wanted, block.spring_impulse, lane);
    return hn::Sub(wanted, old);
}

// A gap may close, but no further. The result is by how much the impulse changed.
HWY_INLINE V solve_limit(const SoftLanes& soft, V inverse_h, V mass, V gap, V closing, Lanes<float>& impulse,
                         int lane) {
    const V zero = hn::Zero(D());
    const M apart = hn::Gt(gap, zero);
    const V old = load(impulse, lane);
    const V rate = hn::IfThenElse(apart, inverse_h, soft.bias_rate);
    const V soft_mass = hn::Mul(mass, hn::IfThenElse(apart, set(1), soft.mass_scale));
    const V kept = hn::Mul(hn::IfThenElse(apart, zero, soft.impulse_scale), old);
    const V push = hn::Mul(soft_mass, hn::Add(closing, hn::Mul(rate, gap)));
    const V wanted = hn::Max(hn::Sub(hn::Sub(old, push), kept), zero);
    store(wanted, impulse, lane);
    return hn::Sub(wanted, old);
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#endif
