// Where revolute joints are at the start of a step. Glossary: r arm from a centre of mass to an anchor, in
// the axes of the world; c, s cosine and sine of how b stands to a.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "resolve/joints/joint_place_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/simd_rows-inl.h"
#include "resolve/joints/joint_block-inl.h"
#include "resolve/joints/joint_kernels.h"
#include "resolve/joints/joint_place-inl.h"
#include "resolve/joints/torn_joints.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

// How often the angle went round since the last step, in which it turned by less than half a turn: once when
// the short way from the old direction to the new one crosses the negative x axis.
HWY_INLINE V rounds(V old_cosine, V old_sine, V cosine, V sine) {
    const V zero = hn::Zero(D());
    const M was_below = hn::Lt(old_sine, zero);
    const M is_below = hn::Lt(sine, zero);
    const V crossing = hn::Add(hn::Mul(old_cosine, hn::Abs(sine)), hn::Mul(cosine, hn::Abs(old_sine)));
    const M goes_round = hn::Lt(crossing, zero);
    const V up = hn::IfThenElseZero(hn::And(goes_round, hn::AndNot(was_below, is_below)), set(1));
    const V down = hn::IfThenElseZero(hn::And(goes_round, hn::AndNot(is_below, was_below)), set(1));
    return hn::Sub(up, down);
}

// x less whole turns. The first part of a turn has few enough bits that the product with any number of turns
// up to 10,000 is exact, so nothing is lost where x is near.
HWY_INLINE V less_turns(V x, V turns) {
    constexpr float kMost_rad = 6.28125f;
    constexpr float kRest_rad = 0.00193530717958647692f;
    return hn::Sub(hn::Sub(x, hn::Mul(turns, set(kMost_rad))), hn::Mul(turns, set(kRest_rad)));
}

HWY_INLINE void place_drive(PinBlock&, int, V, V, V, V, V, float) {}

HWY_INLINE void place_drive(DriveBlock& block, int lane, V k_a, V k_b, V cosine, V sine, V turns,
                            float impulse_ratio) {
    const V angle = angle_of(cosine, sine);
    store(k_a, block.k_a, lane);
    store(k_b, block.k_b, lane);
    store(angle, block.start_angle, lane);
    store(angle, block.angle, lane);
    store(less_turns(load(block.own_target, lane), turns), block.spring_target, lane);
    store(less_turns(load(block.own_lower, lane), turns), block.lower, lane);
    store(less_turns(load(block.own_upper, lane), turns), block.upper, lane);
    store(hn::Zero(D()), block.total_angular, lane);
    for (Lanes<float>* impulse :
         {&block.spring_impulse, &block.motor_impulse, &block.lower_impulse, &block.upper_impulse}) {
        scale_impulse(*impulse, lane, impulse_ratio);
    }
}

struct PlacePoint {
    template <JointBlockKind kKind, class Block>
    HWY_INLINE M operator()(const PlaceTask& task, AnchorBlock& anchor, Block& joint, const Stance& stance,
                            int lane) const {
        PinBlock& block = place_of(joint);
        const Pair2 r_a = stance.rotate_a(load(anchor.local_ax, lane), load(anchor.local_ay, lane));
        const Pair2 r_b = stance.rotate_b(load(anchor.local_bx, lane), load(anchor.local_by, lane));
        store(r_a.x, block.arm_ax, lane);
        store(r_a.y, block.arm_ay, lane);
        store(r_b.x, block.arm_bx, lane);
        store(r_b.y, block.arm_by, lane);
        const ArmScales<kKind> k(block, lane, task.velocity, task.pose);
        keep_arms(block, lane, k.a, k.b, r_a, r_b, load(block.offset_x, lane), load(block.offset_y, lane));
        scale_impulse(block.impulse_x, lane, task.impulse_ratio);
        scale_impulse(block.impulse_y, lane, task.impulse_ratio);
        store(hn::Zero(D()), block.total_x, lane);
        store(hn::Zero(D()), block.total_y, lane);

        const Pair2 turn = stance.turn();
        const V turns = hn::Add(load(anchor.turns, lane),
                                rounds(load(anchor.cosine, lane), load(anchor.sine, lane), turn.x, turn.y));
        store(turn.x, anchor.cosine, lane);
        store(turn.y, anchor.sine, lane);
        store(turns, anchor.turns, lane);
        place_drive(joint, lane, k.a, k.b, turn.x, turn.y, turns, task.impulse_ratio);
        const V error_x = load(block.error_x, lane);
        const V error_y = load(block.error_y, lane);
        return hn::Gt(hn::Add(hn::Mul(error_x, error_x), hn::Mul(error_y, error_y)), set(kTorn_m * kTorn_m));
    }
};

bool place_pins(AnchorBlock* anchors, PinBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                const Place* all, const float* velocity, const float* pose, float impulse_ratio) {
    return place_kind({anchors, blocks, all, velocity, pose, impulse_ratio}, pool, kind, PlacePoint{});
}
bool place_drives(AnchorBlock* anchors, DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                  const Place* all, const float* velocity, const float* pose, float impulse_ratio) {
    return place_kind({anchors, blocks, all, velocity, pose, impulse_ratio}, pool, kind, PlacePoint{});
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(place_pins);
HWY_EXPORT(place_drives);

bool place_joints(AnchorBlock* anchors, PinBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                  const Place* places, const Motions& motions, float impulse_ratio) {
    return HWY_DYNAMIC_DISPATCH(place_pins)(anchors, pool, blocks, kind, places, &motions.velocity[0].v.x,
                                            &motions.pose[0].d.x, impulse_ratio);
}
bool place_joints(AnchorBlock* anchors, DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                  const Place* places, const Motions& motions, float impulse_ratio) {
    return HWY_DYNAMIC_DISPATCH(place_drives)(anchors, pool, blocks, kind, places, &motions.velocity[0].v.x,
                                              &motions.pose[0].d.x, impulse_ratio);
}

}  // namespace cairn::physics
#endif
