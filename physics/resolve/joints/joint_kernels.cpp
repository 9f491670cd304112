// SIMD passes over blocks of revolute joints. Glossary: v velocity, w scaled angular velocity, r scaled arm
// (base/motion.h), m = 1/mA + 1/mB, k = sqrt(1/I), C error, p impulse, q angle.
//
// The point. With J v = vB + wB x rB - vA - wA x rA, the inverse effective mass is
//     K = m 1 + sum over both bodies of (ry, -rx)(ry, -rx)^T,
// and from the determinant of a sum of a multiple of the identity and two dyads,
//     det K = m^2 + m (rA.rA + rB.rB) + (rA x rB)^2,
// in which nothing cancels. Biased: p += -K^-1 mass_scale (J v + bias_rate C) - impulse_scale p; relaxing:
// p += -K^-1 J v.
//
// The angle. J v = kB wB - kA wA, K = kA^2 + kB^2; its laws are those at the head of joint_solver.cpp, in the
// same order: spring, motor, limits, and the point last. Of a body that nothing can push the terms in K and
// the changes of velocity are left out.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "resolve/joints/joint_kernels.cpp"
#include "resolve/joints/joint_kernels.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/simd_rows-inl.h"
#include "resolve/joints/joint_block-inl.h"
#include "resolve/joints/joint_laws-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

HWY_INLINE Arms arms_now(const PinBlock& block, int lane) {
    return {load(block.arm_ax_now, lane), load(block.arm_ay_now, lane), load(block.arm_bx_now, lane),
            load(block.arm_by_now, lane)};
}

template <JointBlockKind kKind>
HWY_INLINE void solve_point(PinBlock& block, int lane, Pair<kKind>& pair, const SoftLanes& soft) {
    const Arms r = arms_now(block, lane);
    const Pair2 speed = pair.point_speed(r);
    const V rhs_x = hn::Add(speed.x, hn::Mul(soft.bias_rate, load(block.error_x, lane)));
    const V rhs_y = hn::Add(speed.y, hn::Mul(soft.bias_rate, load(block.error_y, lane)));
    const Pair2 rigid = pair.respond(r, rhs_x, rhs_y);
    const V old_x = load(block.impulse_x, lane);
    const V old_y = load(block.impulse_y, lane);
    const V change_x =
        hn::Neg(hn::Add(hn::Mul(soft.mass_scale, rigid.x), hn::Mul(soft.impulse_scale, old_x)));
    const V change_y =
        hn::Neg(hn::Add(hn::Mul(soft.mass_scale, rigid.y), hn::Mul(soft.impulse_scale, old_y)));
    store(hn::Add(old_x, change_x), block.impulse_x, lane);
    store(hn::Add(old_y, change_y), block.impulse_y, lane);
    pair.push(r, change_x, change_y);
}

template <JointBlockKind kKind>
HWY_INLINE void relax_point(PinBlock& block, int lane, Pair<kKind>& pair, const Arms& r) {
    const Pair2 speed = pair.point_speed(r);
    const Pair2 change = pair.respond(r, hn::Neg(speed.x), hn::Neg(speed.y));
    const V x = hn::Add(load(block.impulse_x, lane), change.x);
    const V y = hn::Add(load(block.impulse_y, lane), change.y);
    store(x, block.impulse_x, lane);
    store(y, block.impulse_y, lane);
    store(hn::Add(load(block.total_x, lane), x), block.total_x, lane);
    store(hn::Add(load(block.total_y, lane), y), block.total_y, lane);
    pair.push(r, change.x, change.y);
}

struct Turned {
    Arms arms;
    V angle;  // of b relative to a, since the start of the step
};

template <JointBlockKind kKind>
HWY_INLINE Turned turn_arms(PinBlock& block, int lane, const Pair<kKind>& pair, const float* pose) {
    const Moved<kKind> moved(block, lane, pose);
    const Pair2 turn_a = cosine_and_sine(moved.angle_a);
    const Pair2 turn_b = cosine_and_sine(moved.angle_b);
    const Pair2 r_a = rotate(turn_a.x, turn_a.y, load(block.arm_ax, lane), load(block.arm_ay, lane));
    const Pair2 r_b = rotate(turn_b.x, turn_b.y, load(block.arm_bx, lane), load(block.arm_by, lane));
    const V offset_x = hn::Add(hn::Sub(moved.b.x, moved.a.x), load(block.offset_x, lane));
    const V offset_y = hn::Add(hn::Sub(moved.b.y, moved.a.y), load(block.offset_y, lane));
    return {keep_arms(block, lane, moved.k_a(pair), moved.k_b(pair), r_a, r_b, offset_x, offset_y),
            hn::Sub(moved.angle_b, moved.angle_a)};
}

// The angle of a joint with its laws.
template <JointBlockKind kKind>
class Drive {
  public:
    HWY_INLINE Drive(DriveBlock& block, int lane, Pair<kKind>& pair)
        : block_(block), lane_(lane), pair_(pair), k_a_(load(block.k_a, lane)), k_b_(load(block.k_b, lane)) {
        V k = hn::Mul(k_b_, k_b_);
        if constexpr (Pair<kKind>::kMovesA) k = hn::Add(k, hn::Mul(k_a_, k_a_));
        mass_ = inverse_or_zero(k);
    }

    HWY_INLINE void spring(M wanted_lanes) {
        push_where_it_acts(
            solve_spring(block_, lane_, wanted_lanes, mass_, speed(), load(block_.angle, lane_), set(1)));
    }

    // It stops at limits: one that pushed on would hold them open, by as much as they are soft.
    HWY_INLINE void motor(const SoftLanes& soft, V inverse_h) {
        const V limit = load(block_.motor_limit, lane_);
        const V old = load(block_.motor_impulse, lane_);
        const V angle = load(block_.angle, lane_);
        const V most = closing_speed(soft, inverse_h, hn::Sub(load(block_.upper, lane_), angle));
        const V least = hn::Neg(closing_speed(soft, inverse_h, hn::Sub(angle, load(block_.lower, lane_))));
        const V target = hn::Max(least, hn::Min(load(block_.motor_speed, lane_), most));
        const V wanted = hn::Add(old, hn::Mul(mass_, hn::Sub(target, speed())));
        const V impulse = hn::Max(hn::Neg(limit), hn::Min(wanted, limit));
        store(impulse, block_.motor_impulse, lane_);
        push(hn::Sub(impulse, old));
    }

    HWY_INLINE void lower_limit(const SoftLanes& soft, V inverse_h) {
        const V gap = hn::Sub(load(block_.angle, lane_), load(block_.lower, lane_));
        push_where_it_acts(solve_limit(soft, inverse_h, mass_, gap, speed(), block_.lower_impulse, lane_));
    }
    HWY_INLINE void upper_limit(const SoftLanes& soft, V inverse_h) {
        const V gap = hn::Sub(load(block_.upper, lane_), load(block_.angle, lane_));
        push_where_it_acts(
            hn::Neg(solve_limit(soft, inverse_h, mass_, gap, hn::Neg(speed()), block_.upper_impulse, lane_)));
    }

    [[nodiscard]] HWY_INLINE V impulse() const {
        return hn::Sub(hn::Add(hn::Add(load(block_.spring_impulse, lane_), load(block_.motor_impulse, lane_)),
                               load(block_.lower_impulse, lane_)),
                       load(block_.upper_impulse, lane_));
    }
    [[nodiscard]] HWY_INLINE V speed() const { return pair_.turn_speed(k_a_, k_b_); }
    HWY_INLINE void push(V change) { pair_.turn(k_a_, k_b_, change); }

  private:
    HWY_INLINE static V closing_speed(const SoftLanes& soft, V inverse_h, V gap) {
        return hn::Mul(gap, hn::IfThenElse(hn::Gt(gap, hn::Zero(D())), inverse_h, soft.bias_rate));
    }

    // Most limits are not met. What comes next need not wait then until that has been found out. Lanes that
    // do not act stay as they are to the bit, -0 included, whatever lanes beside them do: how many those are
    // depends on the width of vectors.
    HWY_INLINE void push_where_it_acts(V change) {
        const M idle = hn::Eq(change, hn::Zero(D()));
        if (hn::AllTrue(D(), idle)) return;
        const V spin_a = pair_.a.z;
        const V spin_b = pair_.b.z;
        push(change);
        pair_.b.z = hn::IfThenElse(idle, spin_b, pair_.b.z);
        if constexpr (Pair<kKind>::kMovesA) pair_.a.z = hn::IfThenElse(idle, spin_a, pair_.a.z);
    }

    DriveBlock& block_;
    int lane_;
    Pair<kKind>& pair_;
    V k_a_;
    V k_b_;
    V mass_;
};

// What each pass does to some lanes of a block, for pins and for drives.
struct WarmStart {
    template <JointBlockKind kKind>
    HWY_INLINE void point(PinBlock& block, int lane, Pair<kKind>& pair) const {
        pair.push(arms_now(block, lane), load(block.impulse_x, lane), load(block.impulse_y, lane));
    }
    template <JointBlockKind kKind>
    HWY_INLINE void operator()(PinBlock& block, int lane, Pair<kKind>& pair) const {
        point(block, lane, pair);
    }
    template <JointBlockKind kKind>
    HWY_INLINE void operator()(DriveBlock& block, int lane, Pair<kKind>& pair) const {
        Drive<kKind> drive(block, lane, pair);
        forget_crowded_spring(block, lane);
        drive.push(drive.impulse());
        point(block.pin, lane, pair);
    }
};

struct SweepCrowdedSprings {
    template <JointBlockKind kKind>
    HWY_INLINE void operator()(DriveBlock& block, int lane, Pair<kKind>& pair) const {
        const M crowded = crowded_lanes(block, lane);
        if (hn::AllFalse(D(), crowded)) return;
        Drive<kKind> drive(block, lane, pair);
        drive.spring(crowded);
    }
};

struct Solve {
    JointPassTime time;

    template <JointBlockKind kKind>
    HWY_INLINE void operator()(PinBlock& block, int lane, Pair<kKind>& pair) const {
        const SoftLanes soft{set(time.softness.bias_rate), set(time.softness.mass_scale),
                             set(time.softness.impulse_scale)};
        solve_point(block, lane, pair, soft);
    }
    template <JointBlockKind kKind>
    HWY_INLINE void operator()(DriveBlock& block, int lane, Pair<kKind>& pair) const {
        const SoftLanes soft = softness_of(block, lane);
        Drive<kKind> drive(block, lane, pair);
        drive.spring(hn::Not(crowded_lanes(block, lane)));
        drive.motor(soft, set(time.inverse_h_1_s));
        drive.lower_limit(soft, set(time.inverse_h_1_s));
        drive.upper_limit(soft, set(time.inverse_h_1_s));
        solve_point(block.pin, lane, pair, soft);
    }
};

struct Relax {
    const float* pose;
    JointPassTime time;

    template <JointBlockKind kKind>
    HWY_INLINE void operator()(PinBlock& block, int lane, Pair<kKind>& pair) const {
        const Turned turned = turn_arms(block, lane, pair, pose);
        relax_point(block, lane, pair, turned.arms);
    }
    template <JointBlockKind kKind>
    HWY_INLINE void operator()(DriveBlock& block, int lane, Pair<kKind>& pair) const {
        const Turned turned = turn_arms(block.pin, lane, pair, pose);
        store(hn::Add(load(block.start_angle, lane), turned.angle), block.angle, lane);
        Drive<kKind> drive(block, lane, pair);
        drive.motor(rigid_lanes(), set(time.inverse_h_1_s));
        drive.lower_limit(rigid_lanes(), set(time.inverse_h_1_s));
        drive.upper_limit(rigid_lanes(), set(time.inverse_h_1_s));
        store(hn::Add(load(block.total_angular, lane), drive.impulse()), block.total_angular, lane);
        relax_point(block.pin, lane, pair, turned.arms);
    }
};

void note_speeds(DriveBlock* pool, std::span<const int> blocks, const float* velocity) {
    for (const int i : blocks) {
        DriveBlock& block = pool[i];
        for (int lane = 0; lane < kLanes; lane += kStep) {
            const Pair<JointBlockKind::TwoBodies> pair(block.pin, lane, velocity);
            store(pair.turn_speed(load(block.k_a, lane), load(block.k_b, lane)), block.speed_before, lane);
        }
    }
}

void warm_start_pins(PinBlock* pool, std::span<const int> blocks, JointBlockKind kind, float* velocity) {
    for_all(pool, blocks, kind, velocity, WarmStart{});
}
void warm_start_drives(DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind, float* velocity) {
    for_all(pool, blocks, kind, velocity, WarmStart{});
}
void sweep_crowded(DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind, float* velocity) {
    for_all(pool, blocks, kind, velocity, SweepCrowdedSprings{});
}
void solve_pins(PinBlock* pool, std::span<const int> blocks, JointBlockKind kind, float* velocity,
                const JointPassTime& time) {
    for_all(pool, blocks, kind, velocity, Solve{time});
}
void solve_drives(DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind, float* velocity,
                  const JointPassTime& time) {
    for_all(pool, blocks, kind, velocity, Solve{time});
}
void relax_pins(PinBlock* pool, std::span<const int> blocks, JointBlockKind kind, float* velocity,
                const float* pose, const JointPassTime& time) {
    for_all(pool, blocks, kind, velocity, Relax{pose, time});
}
void relax_drives(DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind, float* velocity,
                  const float* pose, const JointPassTime& time) {
    for_all(pool, blocks, kind, velocity, Relax{pose, time});
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(note_speeds);
HWY_EXPORT(warm_start_pins);
HWY_EXPORT(warm_start_drives);
HWY_EXPORT(sweep_crowded);
HWY_EXPORT(solve_pins);
HWY_EXPORT(solve_drives);
HWY_EXPORT(relax_pins);
HWY_EXPORT(relax_drives);

void note_joint_speeds(DriveBlock* pool, std::span<const int> blocks, const VelocityRow* velocity) {
    HWY_DYNAMIC_DISPATCH(note_speeds)(pool, blocks, &velocity->v.x);
}
void warm_start_joints(PinBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                       VelocityRow* velocity) {
    HWY_DYNAMIC_DISPATCH(warm_start_pins)(pool, blocks, kind, &velocity->v.x);
}
void warm_start_joints(DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                       VelocityRow* velocity) {
    HWY_DYNAMIC_DISPATCH(warm_start_drives)(pool, blocks, kind, &velocity->v.x);
}
void sweep_crowded_springs(DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                           VelocityRow* velocity) {
    HWY_DYNAMIC_DISPATCH(sweep_crowded)(pool, blocks, kind, &velocity->v.x);
}
void solve_joints(PinBlock* pool, std::span<const int> blocks, JointBlockKind kind, VelocityRow* velocity,
                  const JointPassTime& time) {
    HWY_DYNAMIC_DISPATCH(solve_pins)(pool, blocks, kind, &velocity->v.x, time);
}
void solve_joints(DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind, VelocityRow* velocity,
                  const JointPassTime& time) {
    HWY_DYNAMIC_DISPATCH(solve_drives)(pool, blocks, kind, &velocity->v.x, time);
}
void relax_joints(PinBlock* pool, std::span<const int> blocks, JointBlockKind kind, VelocityRow* velocity,
                  const PoseRow* pose, const JointPassTime& time) {
    HWY_DYNAMIC_DISPATCH(relax_pins)(pool, blocks, kind, &velocity->v.x, &pose->d.x, time);
}
void relax_joints(DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind, VelocityRow* velocity,
                  const PoseRow* pose, const JointPassTime& time) {
    HWY_DYNAMIC_DISPATCH(relax_drives)(pool, blocks, kind, &velocity->v.x, &pose->d.x, time);
}

}  // namespace cairn::physics
#endif
