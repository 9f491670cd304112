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

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

// What cannot be moved gets 0.
HWY_INLINE V inverse_or_zero(V k) {
    return hn::IfThenElseZero(hn::Gt(k, hn::Zero(D())), hn::Div(set(1), k));
}

// As Rotation::from_small_angle, to the bit.
HWY_INLINE Pair2 cosine_and_sine(V angle) {
    const V z = hn::Mul(angle, angle);
    const V s3 = hn::Sub(set(1.0f / 120), hn::Mul(z, set(1.0f / 5040)));
    const V s2 = hn::Add(set(-1.0f / 6), hn::Mul(z, s3));
    V sine = hn::Mul(angle, hn::Add(set(1), hn::Mul(z, s2)));
    const V c4 = hn::Add(set(-1.0f / 720), hn::Mul(z, set(1.0f / 40320)));
    const V c3 = hn::Add(set(1.0f / 24), hn::Mul(z, c4));
    const V c2 = hn::Add(set(-0.5f), hn::Mul(z, c3));
    V cosine = hn::Add(set(1), hn::Mul(z, c2));
    const M small = hn::Le(hn::Abs(angle), set(0.5f));
    if (HWY_UNLIKELY(!hn::AllTrue(D(), small))) {
        alignas(32) Lanes<float> angles;
        alignas(32) Lanes<float> cosines;
        alignas(32) Lanes<float> sines;
        store(angle, angles, 0);
        for (int i = 0; i < kStep; ++i) {
            const Rotation turn = Rotation::from_small_angle(angles[static_cast<std::size_t>(i)]);
            cosines[static_cast<std::size_t>(i)] = turn.c;
            sines[static_cast<std::size_t>(i)] = turn.s;
        }
        cosine = hn::IfThenElse(small, cosine, load(cosines, 0));
        sine = hn::IfThenElse(small, sine, load(sines, 0));
    }
    return {cosine, sine};
}

// The bodies of some lanes.
template <JointBlockKind kKind>
struct Pair {
    Columns a;
    Columns b;

    static constexpr bool kMovesA = kKind == JointBlockKind::TwoBodies;

    HWY_INLINE Pair(const PinBlock& block, int lane, const float* velocity)
        : a(load_rows(velocity, block.a.data() + lane)), b(load_rows(velocity, block.b.data() + lane)) {}

    HWY_INLINE void write(const PinBlock& block, int lane, float* velocity) const {
        store_rows(velocity, block.b.data() + lane, b);
        if constexpr (kMovesA) store_rows(velocity, block.a.data() + lane, a);
    }

    [[nodiscard]] HWY_INLINE Pair2 point_speed(const Arms& r) const {
        const V x = hn::Sub(hn::Sub(b.x, hn::Mul(b.z, r.by)), hn::Sub(a.x, hn::Mul(a.z, r.ay)));
        const V y = hn::Sub(hn::Add(b.y, hn::Mul(b.z, r.bx)), hn::Add(a.y, hn::Mul(a.z, r.ax)));
        return {x, y};
    }

    HWY_INLINE void push(const Arms& r, V x, V y) {
        b.x = hn::Add(b.x, hn::Mul(b.u, x));
        b.y = hn::Add(b.y, hn::Mul(b.u, y));
        b.z = hn::Add(b.z, cross(r.bx, r.by, x, y));
        if constexpr (kMovesA) {
            a.x = hn::Sub(a.x, hn::Mul(a.u, x));
            a.y = hn::Sub(a.y, hn::Mul(a.u, y));
            a.z = hn::Sub(a.z, cross(r.ax, r.ay, x, y));
        }
    }

    [[nodiscard]] HWY_INLINE V turn_speed(V k_a, V k_b) const {
        return hn::Sub(hn::Mul(k_b, b.z), hn::Mul(k_a, a.z));
    }

    HWY_INLINE void turn(V k_a, V k_b, V impulse) {
        b.z = hn::Add(b.z, hn::Mul(k_b, impulse));
        if constexpr (kMovesA) a.z = hn::Sub(a.z, hn::Mul(k_a, impulse));
    }

    // K^-1 (x, y).
    [[nodiscard]] HWY_INLINE Pair2 respond(const Arms& r, V x, V y) const {
        V m = b.u;
        V k00 = hn::Mul(r.by, r.by);
        V k11 = hn::Mul(r.bx, r.bx);
        V k01 = hn::Mul(r.bx, r.by);
        V determinant;
        if constexpr (kMovesA) {
            m = hn::Add(m, a.u);
            k00 = hn::Add(k00, hn::Mul(r.ay, r.ay));
            k11 = hn::Add(k11, hn::Mul(r.ax, r.ax));
            k01 = hn::Add(k01, hn::Mul(r.ax, r.ay));
            const V area = cross(r.ax, r.ay, r.bx, r.by);
            determinant = hn::Add(hn::Mul(m, hn::Add(m, hn::Add(k00, k11))), hn::Mul(area, area));
        } else {
            determinant = hn::Mul(m, hn::Add(m, hn::Add(k00, k11)));
        }
        k00 = hn::Add(k00, m);
        k11 = hn::Add(k11, m);
        const V inverse = inverse_or_zero(determinant);
        return {hn::Mul(inverse, hn::Add(hn::Mul(k11, x), hn::Mul(k01, y))),
                hn::Mul(inverse, hn::Add(hn::Mul(k00, y), hn::Mul(k01, x)))};
    }
};

HWY_INLINE Arms arms_now(const PinBlock& block, int lane) {
    return {load(block.arm_ax_now, lane), load(block.arm_ay_now, lane), load(block.arm_bx_now, lane),
            load(block.arm_by_now, lane)};
}

struct SoftLanes {
    V bias_rate, mass_scale, impulse_scale;
};

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
    const Columns pose_a = load_rows(pose, block.a.data() + lane);
    const Columns pose_b = load_rows(pose, block.b.data() + lane);
    const V angle_a = hn::Mul(pose_a.z, pose_a.u);
    const V angle_b = hn::Mul(pose_b.z, pose_b.u);
    const Pair2 turn_a = cosine_and_sine(angle_a);
    const Pair2 turn_b = cosine_and_sine(angle_b);
    const Pair2 r_a = rotate(turn_a.x, turn_a.y, load(block.arm_ax, lane), load(block.arm_ay, lane));
    const Pair2 r_b = rotate(turn_b.x, turn_b.y, load(block.arm_bx, lane), load(block.arm_by, lane));
    const V offset_x = hn::Add(hn::Sub(pose_b.x, pose_a.x), load(block.offset_x, lane));
    const V offset_y = hn::Add(hn::Sub(pose_b.y, pose_a.y), load(block.offset_y, lane));
    const V k_a = Pair<kKind>::kMovesA ? pushed(pair.a.u, pose_a.u) : pose_a.u;
    const V k_b = pushed(pair.b.u, pose_b.u);
    return {keep_arms(block, lane, k_a, k_b, r_a, r_b, offset_x, offset_y), hn::Sub(angle_b, angle_a)};
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

    // Those that are not crowded.
    HWY_INLINE void spring() { spring(hn::Not(crowded())); }
    HWY_INLINE void crowded_spring() { spring(crowded()); }
    HWY_INLINE void forget_crowded_spring() {
        const V impulse = load(block_.spring_impulse, lane_);
        store(hn::IfThenZeroElse(crowded(), impulse), block_.spring_impulse, lane_);
    }
    [[nodiscard]] HWY_INLINE M crowded() const { return hn::Gt(load(block_.crowded, lane_), hn::Zero(D())); }

    HWY_INLINE void spring(M wanted_lanes) {
        const V d1 = load(block_.spring_d1, lane_);
        const V old = load(block_.spring_impulse, lane_);
        const V error = hn::Sub(load(block_.angle, lane_), load(block_.spring_target, lane_));
        const V force = hn::Add(hn::Add(hn::Mul(d1, speed()), hn::Mul(load(block_.spring_d0, lane_),
                                                                      load(block_.speed_before, lane_))),
                                hn::Mul(load(block_.spring_stiffness, lane_), error));
        const V solved = hn::Div(hn::Sub(hn::Mul(d1, old), hn::Mul(mass_, force)), hn::Add(set(1), d1));
        const V wanted = hn::IfThenElse(wanted_lanes, solved, old);
        store(wanted, block_.spring_impulse, lane_);
        push_where_it_acts(hn::Sub(wanted, old));
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
        push_where_it_acts(limit(soft, inverse_h, gap, speed(), block_.lower_impulse));
    }
    HWY_INLINE void upper_limit(const SoftLanes& soft, V inverse_h) {
        const V gap = hn::Sub(load(block_.upper, lane_), load(block_.angle, lane_));
        push_where_it_acts(hn::Neg(limit(soft, inverse_h, gap, hn::Neg(speed()), block_.upper_impulse)));
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

    // A gap may close, but no further. The result is by how much the impulse changed.
    HWY_INLINE V limit(const SoftLanes& soft, V inverse_h, V gap, V closing, Lanes<float>& impulse) {
        const V zero = hn::Zero(D());
        const M apart = hn::Gt(gap, zero);
        const V old = load(impulse, lane_);
        const V rate = hn::IfThenElse(apart, inverse_h, soft.bias_rate);
        const V mass = hn::Mul(mass_, hn::IfThenElse(apart, set(1), soft.mass_scale));
        const V kept = hn::Mul(hn::IfThenElse(apart, zero, soft.impulse_scale), old);
        const V push = hn::Mul(mass, hn::Add(closing, hn::Mul(rate, gap)));
        const V wanted = hn::Max(hn::Sub(hn::Sub(old, push), kept), zero);
        store(wanted, impulse, lane_);
        return hn::Sub(wanted, old);
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
        drive.forget_crowded_spring();
        drive.push(drive.impulse());
        point(block.pin, lane, pair);
    }
};

struct SweepCrowdedSprings {
    template <JointBlockKind kKind>
    HWY_INLINE void operator()(DriveBlock& block, int lane, Pair<kKind>& pair) const {
        Drive<kKind> drive(block, lane, pair);
        if (!hn::AllFalse(D(), drive.crowded())) drive.crowded_spring();
    }
};

HWY_INLINE SoftLanes softness_of(const DriveBlock& block, int lane) {
    return {load(block.bias_rate, lane), load(block.mass_scale, lane), load(block.impulse_scale, lane)};
}

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
        drive.spring();
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
        const SoftLanes rigid{hn::Zero(D()), set(1), hn::Zero(D())};
        Drive<kKind> drive(block, lane, pair);
        drive.motor(rigid, set(time.inverse_h_1_s));
        drive.lower_limit(rigid, set(time.inverse_h_1_s));
        drive.upper_limit(rigid, set(time.inverse_h_1_s));
        store(hn::Add(load(block.total_angular, lane), drive.impulse()), block.total_angular, lane);
        relax_point(block.pin, lane, pair, turned.arms);
    }
};

template <JointBlockKind kKind, class Block, class Work>
void for_all_lanes(Block* pool, std::span<const int> blocks, float* velocity, const Work& work) {
    for (const int i : blocks) {
        PinBlock& pin = pin_of(pool[i]);
        for (int lane = 0; lane < kLanes; lane += kStep) {
            Pair<kKind> pair(pin, lane, velocity);
            work(pool[i], lane, pair);
            pair.write(pin, lane, velocity);
        }
    }
}

template <class Block, class Work>
void for_all(Block* pool, std::span<const int> blocks, JointBlockKind kind, float* velocity,
             const Work& work) {
    switch (kind) {
        case JointBlockKind::TwoBodies:
            return for_all_lanes<JointBlockKind::TwoBodies>(pool, blocks, velocity, work);
        case JointBlockKind::Anchored:
            return for_all_lanes<JointBlockKind::Anchored>(pool, blocks, velocity, work);
    }
}

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
