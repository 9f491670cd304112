// What the kernels of joints share. To be included between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE
// users, once per target.
#if defined(CAIRN_PHYSICS_RESOLVE_JOINTS_JOINT_BLOCK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CAIRN_PHYSICS_RESOLVE_JOINTS_JOINT_BLOCK_INL_H_
#undef CAIRN_PHYSICS_RESOLVE_JOINTS_JOINT_BLOCK_INL_H_
#else
#define CAIRN_PHYSICS_RESOLVE_JOINTS_JOINT_BLOCK_INL_H_
#endif

#include "base/simd_rows-inl.h"
#include "resolve/joints/joint_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

HWY_INLINE V cross(V ax, V ay, V bx, V by) {
    return hn::Sub(hn::Mul(ax, by), hn::Mul(ay, bx));
}

struct Pair2 {
    V x, y;
};

HWY_INLINE Pair2 rotate(V c, V s, V x, V y) {
    return {hn::Sub(hn::Mul(c, x), hn::Mul(s, y)), hn::Add(hn::Mul(s, x), hn::Mul(c, y))};
}

struct Arms {
    V ax, ay, bx, by;
};

// The scale of the arms of bodies that are pushed. Unused lanes, and bodies asleep, have no mass and are
// turned by nothing.
HWY_INLINE V pushed(V inverse_mass, V k) {
    return hn::IfThenElseZero(hn::Gt(inverse_mass, hn::Zero(D())), k);
}

// Scales the arms and keeps them, with the error, for the passes to come.
HWY_INLINE Arms keep_arms(PinBlock& block, int lane, V k_a, V k_b, Pair2 r_a, Pair2 r_b, V offset_x,
                          V offset_y) {
    const Arms r{hn::Mul(k_a, r_a.x), hn::Mul(k_a, r_a.y), hn::Mul(k_b, r_b.x), hn::Mul(k_b, r_b.y)};
    store(r.ax, block.arm_ax_now, lane);
    store(r.ay, block.arm_ay_now, lane);
    store(r.bx, block.arm_bx_now, lane);
    store(r.by, block.arm_by_now, lane);
    store(hn::Add(offset_x, hn::Sub(r_b.x, r_a.x)), block.error_x, lane);
    store(hn::Add(offset_y, hn::Sub(r_b.y, r_a.y)), block.error_y, lane);
    return r;
}

HWY_INLINE PinBlock& pin_of(PinBlock& block) {
    return block;
}
HWY_INLINE PinBlock& pin_of(DriveBlock& block) {
    return block.pin;
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#endif
