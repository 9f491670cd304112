// SIMD passes over blocks of wheel joints. Glossary: u axis of the suspension, n the axis turned left, t the
// spin of b relative to a; r arm from a centre of mass to an anchor, d offset of the anchors, K inverse
// effective mass, p impulse. The directions are those of wheel.cpp, and the laws those at the head of
// joint_solver.cpp, in the same order: spring, motor, limits, and n last.
//
// As in the scalar solver, laws work on the speeds along the three directions, and on the bodies at the end:
// K says what an impulse along one does along the others. Nothing is left out where a law has nothing to do,
// so lanes do not depend on those beside them.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "resolve/joints/wheel_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/simd_rows-inl.h"
#include "resolve/joints/joint_block-inl.h"
#include "resolve/joints/joint_kernels.h"
#include "resolve/joints/joint_laws-inl.h"
#include "resolve/joints/joint_place-inl.h"
#include "resolve/joints/torn_joints.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

// What an impulse along each direction does to the scaled spin of a body.
struct Levers {
    V n, u, t;
};

// The arm of a reaches to the anchor of b, since the axis turns with a.
HWY_INLINE void keep_directions(WheelBlock& block, int lane, V k_a, V k_b, Pair2 u, Pair2 r_a, Pair2 r_b,
                                V offset_x, V offset_y) {
    const Pair2 reach{hn::Add(offset_x, r_b.x), hn::Add(offset_y, r_b.y)};
    const Pair2 d{hn::Sub(reach.x, r_a.x), hn::Sub(reach.y, r_a.y)};
    const auto along = [&](Pair2 v) { return hn::Add(hn::Mul(u.x, v.x), hn::Mul(u.y, v.y)); };
    store(u.x, block.axis_x, lane);
    store(u.y, block.axis_y, lane);
    store(hn::Mul(k_a, along(reach)), block.lever_an, lane);
    store(hn::Mul(k_b, along(r_b)), block.lever_bn, lane);
    store(hn::Mul(k_a, cross(reach.x, reach.y, u.x, u.y)), block.lever_au, lane);
    store(hn::Mul(k_b, cross(r_b.x, r_b.y, u.x, u.y)), block.lever_bu, lane);
    store(k_a, block.k_a, lane);
    store(k_b, block.k_b, lane);
    store(cross(u.x, u.y, d.x, d.y), block.error, lane);
    store(along(d), block.way, lane);
}

struct PlaceWheel {
    template <JointBlockKind kKind>
    HWY_INLINE M operator()(const PlaceTask& task, AnchorBlock& anchor, WheelBlock& block,
                            const Stance& stance, int lane) const {
        const Pair2 u = stance.rotate_a(load(block.local_axis_x, lane), load(block.local_axis_y, lane));
        const Pair2 r_a = stance.rotate_a(load(anchor.local_ax, lane), load(anchor.local_ay, lane));
        const Pair2 r_b = stance.rotate_b(load(anchor.local_bx, lane), load(anchor.local_by, lane));
        store(u.x, block.start_axis_x, lane);
        store(u.y, block.start_axis_y, lane);
        store(r_a.x, block.arm_ax, lane);
        store(r_a.y, block.arm_ay, lane);
        store(r_b.x, block.arm_bx, lane);
        store(r_b.y, block.arm_by, lane);
        const ArmScales<kKind> k(block, lane, task.velocity, task.pose);
        keep_directions(block, lane, k.a, k.b, u, r_a, r_b, load(block.offset_x, lane),
                        load(block.offset_y, lane));
        for (Lanes<float>* impulse : {&block.impulse, &block.spring_impulse, &block.motor_impulse,
                                      &block.lower_impulse, &block.upper_impulse}) {
            scale_impulse(*impulse, lane, task.impulse_ratio);
        }
        count_turns(anchor, block, stance, lane);
        for (Lanes<float>* total : {&block.total_x, &block.total_y, &block.total_angular, &block.turned})
            store(hn::Zero(D()), *total, lane);
        return hn::Gt(hn::Abs(load(block.error, lane)), set(kTorn_m));
    }

  private:
    // The angle is where it was and by how much it turned, but for rounding and whole turns.
    HWY_INLINE static void count_turns(AnchorBlock& anchor, const WheelBlock& block, const Stance& stance,
                                       int lane) {
        const Pair2 turn = stance.turn();
        const V before = angle_of(load(anchor.cosine, lane), load(anchor.sine, lane));
        const V beyond = hn::Sub(hn::Add(before, load(block.turned, lane)), angle_of(turn.x, turn.y));
        const V rounds = hn::Round(hn::Mul(beyond, set(1 / (2 * kPi))));
        store(turn.x, anchor.cosine, lane);
        store(turn.y, anchor.sine, lane);
        store(hn::Add(load(anchor.turns, lane), rounds), anchor.turns, lane);
    }
};

// The bodies of some lanes as they move along the directions, and what they were pushed.
template <JointBlockKind kKind>
class Along {
  public:
    HWY_INLINE Along(const WheelBlock& block, int lane, Pair<kKind>& pair)
        : pair_(pair),
          axis_{load(block.axis_x, lane), load(block.axis_y, lane)},
          a_{load(block.lever_an, lane), load(block.lever_au, lane), load(block.k_a, lane)},
          b_{load(block.lever_bn, lane), load(block.lever_bu, lane), load(block.k_b, lane)} {
        const V x = hn::Sub(pair.b.x, pair.a.x);
        const V y = hn::Sub(pair.b.y, pair.a.y);
        speed_n_ = hn::Add(cross(axis_.x, axis_.y, x, y), spin(b_.n, a_.n));
        speed_u_ = hn::Add(hn::Add(hn::Mul(axis_.x, x), hn::Mul(axis_.y, y)), spin(b_.u, a_.u));
        speed_t_ = spin(b_.t, a_.t);
        V m = pair.b.u;
        if constexpr (kMovesA) m = hn::Add(m, pair.a.u);
        nu_ = share(b_.n, b_.u, a_.n, a_.u);
        nt_ = share(b_.n, b_.t, a_.n, a_.t);
        ut_ = share(b_.u, b_.t, a_.u, a_.t);
        nn_ = hn::Add(m, share(b_.n, b_.n, a_.n, a_.n));
        uu_ = hn::Add(m, share(b_.u, b_.u, a_.u, a_.u));
        tt_ = share(b_.t, b_.t, a_.t, a_.t);
    }

    [[nodiscard]] HWY_INLINE V speed_n() const { return speed_n_; }
    [[nodiscard]] HWY_INLINE V speed_u() const { return speed_u_; }
    [[nodiscard]] HWY_INLINE V speed_t() const { return speed_t_; }
    [[nodiscard]] HWY_INLINE V mass_n() const { return inverse_or_zero(nn_); }
    [[nodiscard]] HWY_INLINE V mass_u() const { return inverse_or_zero(uu_); }
    [[nodiscard]] HWY_INLINE V mass_t() const { return inverse_or_zero(tt_); }
    // What an impulse of 1 along u takes along n, so that the speed along n stays.
    [[nodiscard]] HWY_INLINE V answer_n() const { return hn::Mul(nu_, mass_n()); }
    // Of K along u, what is left then.
    [[nodiscard]] HWY_INLINE V share_u() const {
        return hn::Max(hn::Sub(set(1), hn::Mul(hn::Mul(nu_, answer_n()), mass_u())), hn::Zero(D()));
    }

    HWY_INLINE void push_n(V p) {
        pushed_n_ = hn::Add(pushed_n_, p);
        speed_n_ = hn::Add(speed_n_, hn::Mul(nn_, p));
        speed_u_ = hn::Add(speed_u_, hn::Mul(nu_, p));
        speed_t_ = hn::Add(speed_t_, hn::Mul(nt_, p));
    }
    HWY_INLINE void push_u(V p) {
        pushed_u_ = hn::Add(pushed_u_, p);
        speed_n_ = hn::Add(speed_n_, hn::Mul(nu_, p));
        speed_u_ = hn::Add(speed_u_, hn::Mul(uu_, p));
        speed_t_ = hn::Add(speed_t_, hn::Mul(ut_, p));
    }
    HWY_INLINE void push_t(V p) {
        pushed_t_ = hn::Add(pushed_t_, p);
        speed_n_ = hn::Add(speed_n_, hn::Mul(nt_, p));
        speed_u_ = hn::Add(speed_u_, hn::Mul(ut_, p));
        speed_t_ = hn::Add(speed_t_, hn::Mul(tt_, p));
    }

    // On b, in the axes of the world.
    [[nodiscard]] HWY_INLINE Pair2 impulse(V p_n, V p_u) const {
        return {hn::Sub(hn::Mul(axis_.x, p_u), hn::Mul(axis_.y, p_n)),
                hn::Add(hn::Mul(axis_.y, p_u), hn::Mul(axis_.x, p_n))};
    }

    HWY_INLINE void write() const {
        const Pair2 p = impulse(pushed_n_, pushed_u_);
        pair_.b.x = hn::Add(pair_.b.x, hn::Mul(pair_.b.u, p.x));
        pair_.b.y = hn::Add(pair_.b.y, hn::Mul(pair_.b.u, p.y));
        pair_.b.z = hn::Add(pair_.b.z, turned(b_));
        if constexpr (kMovesA) {
            pair_.a.x = hn::Sub(pair_.a.x, hn::Mul(pair_.a.u, p.x));
            pair_.a.y = hn::Sub(pair_.a.y, hn::Mul(pair_.a.u, p.y));
            pair_.a.z = hn::Sub(pair_.a.z, turned(a_));
        }
    }

  private:
    static constexpr bool kMovesA = Pair<kKind>::kMovesA;

    [[nodiscard]] HWY_INLINE V spin(V of_b, V of_a) const {
        return hn::Sub(hn::Mul(pair_.b.z, of_b), hn::Mul(pair_.a.z, of_a));
    }
    HWY_INLINE static V share(V b_1, V b_2, V a_1, V a_2) {
        const V of_b = hn::Mul(b_1, b_2);
        if constexpr (kMovesA) return hn::Add(hn::Mul(a_1, a_2), of_b);
        return of_b;
    }
    [[nodiscard]] HWY_INLINE V turned(const Levers& levers) const {
        return hn::Add(hn::Add(hn::Mul(levers.n, pushed_n_), hn::Mul(levers.u, pushed_u_)),
                       hn::Mul(levers.t, pushed_t_));
    }

    Pair<kKind>& pair_;
    Pair2 axis_;
    Levers a_;
    Levers b_;
    V nn_, uu_, tt_, nu_, nt_, ut_;
    V speed_n_, speed_u_, speed_t_;
    V pushed_n_ = hn::Zero(D());
    V pushed_u_ = hn::Zero(D());
    V pushed_t_ = hn::Zero(D());
};

// With what is held along n as joint_solver.cpp has it for rails; springs in lanes are damped.
template <JointBlockKind kKind>
HWY_INLINE void solve_on_rail(WheelBlock& block, int lane, M wanted, Along<kKind>& along) {
    const V answer = along.answer_n();
    const V speed = hn::Sub(along.speed_u(), hn::Mul(answer, along.speed_n()));
    const V way = hn::Sub(load(block.way, lane), hn::Mul(answer, load(block.error, lane)));
    const V change = solve_spring(block, lane, wanted, along.mass_u(), speed, way, along.share_u());
    const V held = hn::Neg(hn::Mul(answer, change));
    along.push_u(change);
    along.push_n(held);
    store(hn::Add(load(block.impulse, lane), held), block.impulse, lane);
}

// Crowded springs start from nothing: what they took of what is held goes as well.
template <JointBlockKind kKind>
HWY_INLINE void forget_crowded_on_rail(WheelBlock& block, int lane, const Along<kKind>& along) {
    const V gone = hn::IfThenElseZero(crowded_lanes(block, lane), load(block.spring_impulse, lane));
    store(hn::Add(load(block.impulse, lane), hn::Mul(along.answer_n(), gone)), block.impulse, lane);
    forget_crowded_spring(block, lane);
}

template <JointBlockKind kKind>
HWY_INLINE void solve_motor(WheelBlock& block, int lane, Along<kKind>& along) {
    const V limit = load(block.motor_limit, lane);
    const V old = load(block.motor_impulse, lane);
    const V missing = hn::Sub(load(block.motor_speed, lane), along.speed_t());
    const V wanted = hn::Add(old, hn::Mul(along.mass_t(), missing));
    const V within = hn::Max(hn::Neg(limit), hn::Min(wanted, limit));
    const V impulse = hn::IfThenElse(hn::Gt(limit, hn::Zero(D())), within, old);
    store(impulse, block.motor_impulse, lane);
    along.push_t(hn::Sub(impulse, old));
}

template <JointBlockKind kKind>
HWY_INLINE void solve_limits(WheelBlock& block, int lane, const SoftLanes& soft, V inverse_h,
                             Along<kKind>& along) {
    const V mass = along.mass_u();
    const V way = load(block.way, lane);
    const V above = hn::Sub(way, load(block.lower, lane));
    along.push_u(solve_limit(soft, inverse_h, mass, above, along.speed_u(), block.lower_impulse, lane));
    const V below = hn::Sub(load(block.upper, lane), way);
    along.push_u(hn::Neg(
        solve_limit(soft, inverse_h, mass, below, hn::Neg(along.speed_u()), block.upper_impulse, lane)));
}

// The result is the impulse.
template <JointBlockKind kKind>
HWY_INLINE V solve_hold(WheelBlock& block, int lane, const SoftLanes& soft, Along<kKind>& along) {
    const V old = load(block.impulse, lane);
    const V rhs = hn::Add(along.speed_n(), hn::Mul(soft.bias_rate, load(block.error, lane)));
    const V rigid = hn::Mul(along.mass_n(), rhs);
    const V change = hn::Neg(hn::Add(hn::Mul(soft.mass_scale, rigid), hn::Mul(soft.impulse_scale, old)));
    const V impulse = hn::Add(old, change);
    store(impulse, block.impulse, lane);
    along.push_n(change);
    return impulse;
}

// Of all laws along u.
HWY_INLINE V impulse_u(const WheelBlock& block, int lane) {
    return hn::Sub(hn::Add(load(block.spring_impulse, lane), load(block.lower_impulse, lane)),
                   load(block.upper_impulse, lane));
}

struct WarmStartWheels {
    template <JointBlockKind kKind>
    HWY_INLINE void operator()(WheelBlock& block, int lane, Pair<kKind>& pair) const {
        Along<kKind> along(block, lane, pair);
        forget_crowded_on_rail(block, lane, along);
        along.push_n(load(block.impulse, lane));
        along.push_u(impulse_u(block, lane));
        along.push_t(load(block.motor_impulse, lane));
        along.write();
    }
};

struct SweepCrowdedWheels {
    template <JointBlockKind kKind>
    HWY_INLINE void operator()(WheelBlock& block, int lane, Pair<kKind>& pair) const {
        const M crowded = crowded_lanes(block, lane);
        if (hn::AllFalse(D(), crowded)) return;
        const Pair<kKind> before = pair;
        Along<kKind> along(block, lane, pair);
        solve_on_rail(block, lane, crowded, along);
        along.write();
        const auto keep = [&](Columns& now, const Columns& old) {
            now.x = hn::IfThenElse(crowded, now.x, old.x);
            now.y = hn::IfThenElse(crowded, now.y, old.y);
            now.z = hn::IfThenElse(crowded, now.z, old.z);
        };
        keep(pair.a, before.a);
        keep(pair.b, before.b);
    }
};

struct SolveWheels {
    V inverse_h;

    template <JointBlockKind kKind>
    HWY_INLINE void operator()(WheelBlock& block, int lane, Pair<kKind>& pair) const {
        const SoftLanes soft = softness_of(block, lane);
        Along<kKind> along(block, lane, pair);
        solve_on_rail(block, lane, hn::Not(crowded_lanes(block, lane)), along);
        solve_motor(block, lane, along);
        solve_limits(block, lane, soft, inverse_h, along);
        solve_hold(block, lane, soft, along);
        along.write();
    }
};

struct RelaxWheels {
    const float* pose;
    V inverse_h;

    template <JointBlockKind kKind>
    HWY_INLINE void operator()(WheelBlock& block, int lane, Pair<kKind>& pair) const {
        turn(block, lane, pair);
        Along<kKind> along(block, lane, pair);
        solve_motor(block, lane, along);
        solve_limits(block, lane, rigid_lanes(), inverse_h, along);
        const V impulse_n = solve_hold(block, lane, rigid_lanes(), along);
        const Pair2 p = along.impulse(impulse_n, impulse_u(block, lane));
        const auto add = [&](V impulse, Lanes<float>& total) {
            store(hn::Add(load(total, lane), impulse), total, lane);
        };
        add(p.x, block.total_x);
        add(p.y, block.total_y);
        add(load(block.motor_impulse, lane), block.total_angular);
        along.write();
    }

  private:
    template <JointBlockKind kKind>
    HWY_INLINE void turn(WheelBlock& block, int lane, const Pair<kKind>& pair) const {
        const Moved<kKind> moved(block, lane, pose);
        const Pair2 turn_a = cosine_and_sine(moved.angle_a);
        const Pair2 turn_b = cosine_and_sine(moved.angle_b);
        const auto turned = [&](Pair2 turn, const Lanes<float>& x, const Lanes<float>& y) {
            return rotate(turn.x, turn.y, load(x, lane), load(y, lane));
        };
        const V offset_x = hn::Add(hn::Sub(moved.b.x, moved.a.x), load(block.offset_x, lane));
        const V offset_y = hn::Add(hn::Sub(moved.b.y, moved.a.y), load(block.offset_y, lane));
        keep_directions(block, lane, moved.k_a(pair), moved.k_b(pair),
                        turned(turn_a, block.start_axis_x, block.start_axis_y),
                        turned(turn_a, block.arm_ax, block.arm_ay),
                        turned(turn_b, block.arm_bx, block.arm_by), offset_x, offset_y);
        store(hn::Sub(moved.angle_b, moved.angle_a), block.turned, lane);
    }
};

bool place_wheels(AnchorBlock* anchors, WheelBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                  const Place* all, const float* velocity, const float* pose, float impulse_ratio) {
    return place_kind({anchors, blocks, all, velocity, pose, impulse_ratio}, pool, kind, PlaceWheel{});
}
void note_wheel_speeds(WheelBlock* pool, std::span<const int> blocks, const float* velocity) {
    for (const int i : blocks) {
        WheelBlock& block = pool[i];
        for (int lane = 0; lane < kLanes; lane += kStep) {
            Pair<JointBlockKind::TwoBodies> pair(block, lane, velocity);
            store(Along(block, lane, pair).speed_u(), block.speed_before, lane);
        }
    }
}
void warm_start_wheels(WheelBlock* pool, std::span<const int> blocks, JointBlockKind kind, float* velocity) {
    for_all(pool, blocks, kind, velocity, WarmStartWheels{});
}
void sweep_crowded_wheels(WheelBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                          float* velocity) {
    for_all(pool, blocks, kind, velocity, SweepCrowdedWheels{});
}
void solve_wheels(WheelBlock* pool, std::span<const int> blocks, JointBlockKind kind, float* velocity,
                  const JointPassTime& time) {
    for_all(pool, blocks, kind, velocity, SolveWheels{set(time.inverse_h_1_s)});
}
void relax_wheels(WheelBlock* pool, std::span<const int> blocks, JointBlockKind kind, float* velocity,
                  const float* pose, const JointPassTime& time) {
    for_all(pool, blocks, kind, velocity, RelaxWheels{pose, set(time.inverse_h_1_s)});
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(place_wheels);
HWY_EXPORT(note_wheel_speeds);
HWY_EXPORT(warm_start_wheels);
HWY_EXPORT(sweep_crowded_wheels);
HWY_EXPORT(solve_wheels);
HWY_EXPORT(relax_wheels);

bool place_joints(AnchorBlock* anchors, WheelBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                  const Place* places, const Motions& motions, float impulse_ratio) {
    return HWY_DYNAMIC_DISPATCH(place_wheels)(anchors, pool, blocks, kind, places, &motions.velocity[0].v.x,
                                              &motions.pose[0].d.x, impulse_ratio);
}
void note_joint_speeds(WheelBlock* pool, std::span<const int> blocks, const VelocityRow* velocity) {
    HWY_DYNAMIC_DISPATCH(note_wheel_speeds)(pool, blocks, &velocity->v.x);
}
void warm_start_joints(WheelBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                       VelocityRow* velocity) {
    HWY_DYNAMIC_DISPATCH(warm_start_wheels)(pool, blocks, kind, &velocity->v.x);
}
void sweep_crowded_springs(WheelBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                           VelocityRow* velocity) {
    HWY_DYNAMIC_DISPATCH(sweep_crowded_wheels)(pool, blocks, kind, &velocity->v.x);
}
void solve_joints(WheelBlock* pool, std::span<const int> blocks, JointBlockKind kind, VelocityRow* velocity,
                  const JointPassTime& time) {
    HWY_DYNAMIC_DISPATCH(solve_wheels)(pool, blocks, kind, &velocity->v.x, time);
}
void relax_joints(WheelBlock* pool, std::span<const int> blocks, JointBlockKind kind, VelocityRow* velocity,
                  const PoseRow* pose, const JointPassTime& time) {
    HWY_DYNAMIC_DISPATCH(relax_wheels)(pool, blocks, kind, &velocity->v.x, &pose->d.x, time);
}

}  // namespace cairn::physics
#endif
