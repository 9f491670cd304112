// Where joints in lanes are at the start of a step. Glossary: r arm from a centre of mass to an anchor, in
// the axes of the world; c, s cosine and sine of how b stands to a.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "resolve/joints/joint_place_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/simd_rows-inl.h"
#include "resolve/joints/joint_block-inl.h"
#include "resolve/joints/joint_kernels.h"
#include "resolve/joints/torn_joints.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

// In [-pi, pi], of a vector of length 1; to 4e-8 besides rounding. The polynomial is the Chebyshev
// interpolation of atan(x)/x in x^2 over [0, 1].
HWY_INLINE V angle_of(V cosine, V sine) {
    const V c = hn::Abs(cosine);
    const V s = hn::Abs(sine);
    const V x = hn::Div(hn::Min(c, s), hn::Max(c, s));
    const V z = hn::Mul(x, x);
    V sum = set(0.0028340641874819994f);
    for (const float coefficient :
         {-0.016005029901862144f, 0.042587608098983765f, -0.07495445758104324f, 0.10636754333972931f,
          -0.14202570915222168f, 0.19992484152317047f, -0.3333306610584259f, 1.0f}) {
        sum = hn::Add(set(coefficient), hn::Mul(z, sum));
    }
    V angle = hn::Mul(x, sum);
    angle = hn::IfThenElse(hn::Gt(s, c), hn::Sub(set(kPi / 2), angle), angle);
    angle = hn::IfThenElse(hn::Lt(cosine, hn::Zero(D())), hn::Sub(set(kPi), angle), angle);
    return hn::IfThenElse(hn::Lt(sine, hn::Zero(D())), hn::Neg(angle), angle);
}

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
        store(hn::Mul(set(impulse_ratio), load(*impulse, lane)), *impulse, lane);
    }
}

struct PlaceLanes {
    alignas(32) Lanes<float> cos_a;
    Lanes<float> sin_a;
    Lanes<float> cos_b;
    Lanes<float> sin_b;
};

template <JointBlockKind kKind, class Block>
HWY_INLINE M place_lanes(AnchorBlock& anchor, Block& joint, const PlaceLanes& places, int lane,
                         const float* velocity, const float* pose, float impulse_ratio) {
    PinBlock& block = pin_of(joint);
    const V cos_a = load(places.cos_a, lane);
    const V sin_a = load(places.sin_a, lane);
    const V cos_b = load(places.cos_b, lane);
    const V sin_b = load(places.sin_b, lane);
    const Pair2 r_a = rotate(cos_a, sin_a, load(anchor.local_ax, lane), load(anchor.local_ay, lane));
    const Pair2 r_b = rotate(cos_b, sin_b, load(anchor.local_bx, lane), load(anchor.local_by, lane));
    store(r_a.x, block.arm_ax, lane);
    store(r_a.y, block.arm_ay, lane);
    store(r_b.x, block.arm_bx, lane);
    store(r_b.y, block.arm_by, lane);
    V k_a = load_rows(pose, block.a.data() + lane).u;
    if constexpr (kKind == JointBlockKind::TwoBodies)
        k_a = pushed(load_rows(velocity, block.a.data() + lane).u, k_a);
    const V k_b =
        pushed(load_rows(velocity, block.b.data() + lane).u, load_rows(pose, block.b.data() + lane).u);
    keep_arms(block, lane, k_a, k_b, r_a, r_b, load(block.offset_x, lane), load(block.offset_y, lane));
    store(hn::Mul(set(impulse_ratio), load(block.impulse_x, lane)), block.impulse_x, lane);
    store(hn::Mul(set(impulse_ratio), load(block.impulse_y, lane)), block.impulse_y, lane);
    store(hn::Zero(D()), block.total_x, lane);
    store(hn::Zero(D()), block.total_y, lane);

    const V cosine = hn::Add(hn::Mul(cos_a, cos_b), hn::Mul(sin_a, sin_b));
    const V sine = hn::Sub(hn::Mul(cos_a, sin_b), hn::Mul(sin_a, cos_b));
    const V turns = hn::Add(load(anchor.turns, lane),
                            rounds(load(anchor.cosine, lane), load(anchor.sine, lane), cosine, sine));
    store(cosine, anchor.cosine, lane);
    store(sine, anchor.sine, lane);
    store(turns, anchor.turns, lane);
    place_drive(joint, lane, k_a, k_b, cosine, sine, turns, impulse_ratio);
    const V error_x = load(block.error_x, lane);
    const V error_y = load(block.error_y, lane);
    return hn::Gt(hn::Add(hn::Mul(error_x, error_x), hn::Mul(error_y, error_y)), set(kTorn_m * kTorn_m));
}

template <JointBlockKind kKind, class Block>
bool place_all(AnchorBlock* anchors, Block* pool, std::span<const int> blocks, const Place* all,
               const float* velocity, const float* pose, float impulse_ratio) {
    M torn = hn::FirstN(D(), 0);
    for (const int i : blocks) {
        AnchorBlock& anchor = anchors[i];
        PinBlock& block = pin_of(pool[i]);
        PlaceLanes places{};
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            if (anchor.joint[lane] < 0) {
                places.cos_a[lane] = places.cos_b[lane] = 1;
                continue;
            }
            const Place& a = all[anchor.body_a[lane]];
            const Place& b = all[anchor.body_b[lane]];
            places.cos_a[lane] = a.rotation.c;
            places.sin_a[lane] = a.rotation.s;
            places.cos_b[lane] = b.rotation.c;
            places.sin_b[lane] = b.rotation.s;
            const Vec2 offset = b.center - a.center;
            block.offset_x[lane] = offset.x;
            block.offset_y[lane] = offset.y;
            block.a[lane] = a.row;
            block.b[lane] = b.row;
        }
        for (int lane = 0; lane < kLanes; lane += kStep)
            torn = hn::Or(torn,
                          place_lanes<kKind>(anchor, pool[i], places, lane, velocity, pose, impulse_ratio));
    }
    return !hn::AllFalse(D(), torn);
}

template <class Block>
bool place_kind(AnchorBlock* anchors, Block* pool, std::span<const int> blocks, JointBlockKind kind,
                const Place* all, const float* velocity, const float* pose, float impulse_ratio) {
    switch (kind) {
        case JointBlockKind::TwoBodies:
            return place_all<JointBlockKind::TwoBodies>(anchors, pool, blocks, all, velocity, pose,
                                                        impulse_ratio);
        case JointBlockKind::Anchored:
            return place_all<JointBlockKind::Anchored>(anchors, pool, blocks, all, velocity, pose,
                                                       impulse_ratio);
    }
    return false;
}

bool place_pins(AnchorBlock* anchors, PinBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                const Place* all, const float* velocity, const float* pose, float impulse_ratio) {
    return place_kind(anchors, pool, blocks, kind, all, velocity, pose, impulse_ratio);
}
bool place_drives(AnchorBlock* anchors, DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                  const Place* all, const float* velocity, const float* pose, float impulse_ratio) {
    return place_kind(anchors, pool, blocks, kind, all, velocity, pose, impulse_ratio);
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
