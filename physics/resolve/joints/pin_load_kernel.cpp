// take_off_load (pin_loads.h) for pins in lanes: the same in another order of sums.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "resolve/joints/pin_load_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/simd_rows-inl.h"
#include "resolve/joints/joint_block-inl.h"
#include "resolve/joints/joint_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

template <JointBlockKind kKind>
HWY_INLINE void take_off(PinBlock& block, int lane, const float* velocity, const PinLoads& loads) {
    const V load_x = hn::Mul(set(loads.h_s), load(block.load_x, lane));
    const V load_y = hn::Mul(set(loads.h_s), load(block.load_y, lane));
    const V square = hn::Add(hn::Mul(load_x, load_x), hn::Mul(load_y, load_y));
    const V along =
        hn::Add(hn::Mul(load_x, load(block.impulse_x, lane)), hn::Mul(load_y, load(block.impulse_y, lane)));
    const M is_loaded = hn::And(hn::Gt(square, hn::Zero(D())), hn::Gt(along, hn::Zero(D())));
    const V share =
        hn::IfThenElseZero(is_loaded, hn::Min(hn::Div(hn::Mul(set(kMostOfLastLoad), along), square), set(1)));
    const V scale = hn::Mul(set(loads.give), share);

    const V r_bx = load(block.arm_bx_now, lane);
    const V r_by = load(block.arm_by_now, lane);
    V m = load_rows(velocity, block.b.data() + lane).u;
    V k00 = hn::Mul(r_by, r_by);
    V k11 = hn::Mul(r_bx, r_bx);
    V k01 = hn::Mul(r_bx, r_by);
    if constexpr (kKind == JointBlockKind::TwoBodies) {
        const V r_ax = load(block.arm_ax_now, lane);
        const V r_ay = load(block.arm_ay_now, lane);
        m = hn::Add(m, load_rows(velocity, block.a.data() + lane).u);
        k00 = hn::Add(k00, hn::Mul(r_ay, r_ay));
        k11 = hn::Add(k11, hn::Mul(r_ax, r_ax));
        k01 = hn::Add(k01, hn::Mul(r_ax, r_ay));
    }
    const V x = hn::Mul(scale, hn::Sub(hn::Mul(hn::Add(m, k00), load_x), hn::Mul(k01, load_y)));
    const V y = hn::Mul(scale, hn::Sub(hn::Mul(hn::Add(m, k11), load_y), hn::Mul(k01, load_x)));
    store(hn::Sub(load(block.offset_x, lane), x), block.offset_x, lane);
    store(hn::Sub(load(block.offset_y, lane), y), block.offset_y, lane);
    store(hn::Sub(load(block.error_x, lane), x), block.error_x, lane);
    store(hn::Sub(load(block.error_y, lane), y), block.error_y, lane);
}

template <JointBlockKind kKind>
void take_off_all(PinBlock* pool, std::span<const int> blocks, const float* velocity, const PinLoads& loads) {
    for (const int i : blocks) {
        for (int lane = 0; lane < kLanes; lane += kStep) take_off<kKind>(pool[i], lane, velocity, loads);
    }
}

void take_off_loads(PinBlock* pool, std::span<const int> blocks, JointBlockKind kind, const float* velocity,
                    const PinLoads& loads) {
    switch (kind) {
        case JointBlockKind::TwoBodies:
            return take_off_all<JointBlockKind::TwoBodies>(pool, blocks, velocity, loads);
        case JointBlockKind::Anchored:
            return take_off_all<JointBlockKind::Anchored>(pool, blocks, velocity, loads);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(take_off_loads);

void take_off_loads(PinBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                    const VelocityRow* velocity, const PinLoads& loads) {
    HWY_DYNAMIC_DISPATCH(take_off_loads)(pool, blocks, kind, &velocity->v.x, loads);
}

}  // namespace cairn::physics
#endif
