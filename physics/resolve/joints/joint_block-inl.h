// What the kernels of joints share. To be included between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE
// users, once per target. Glossary: v velocity, w scaled angular velocity, r scaled arm (base/motion.h), K
// inverse effective mass, m = 1/mA + 1/mB.
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

// The bodies of some lanes.
template <JointBlockKind kKind>
struct Pair {
    Columns a;
    Columns b;

    static constexpr bool kMovesA = kKind == JointBlockKind::TwoBodies;

    HWY_INLINE Pair(const JointRows& rows, int lane, const float* velocity)
        : a(load_rows(velocity, rows.a.data() + lane)), b(load_rows(velocity, rows.b.data() + lane)) {}

    HWY_INLINE void write(const JointRows& rows, int lane, float* velocity) const {
        store_rows(velocity, rows.b.data() + lane, b);
        if constexpr (kMovesA) store_rows(velocity, rows.a.data() + lane, a);
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

// The bodies of some lanes since the start of the step.
template <JointBlockKind kKind>
struct Moved {
    Columns a;  // poses
    Columns b;
    V angle_a;
    V angle_b;

    HWY_INLINE Moved(const JointRows& rows, int lane, const float* pose)
        : a(load_rows(pose, rows.a.data() + lane)),
          b(load_rows(pose, rows.b.data() + lane)),
          angle_a(hn::Mul(a.z, a.u)),
          angle_b(hn::Mul(b.z, b.u)) {}

    [[nodiscard]] HWY_INLINE V k_a(const Pair<kKind>& pair) const {
        return Pair<kKind>::kMovesA ? pushed(pair.a.u, a.u) : a.u;
    }
    [[nodiscard]] HWY_INLINE V k_b(const Pair<kKind>& pair) const { return pushed(pair.b.u, b.u); }
};

// Calls work(block, lane, pair) for all lanes, and writes what becomes of the pair.
template <JointBlockKind kKind, class Block, class Work>
void for_all_lanes(Block* pool, std::span<const int> blocks, float* velocity, const Work& work) {
    for (const int i : blocks) {
        const JointRows& rows = rows_of(pool[i]);
        for (int lane = 0; lane < kLanes; lane += kStep) {
            Pair<kKind> pair(rows, lane, velocity);
            work(pool[i], lane, pair);
            pair.write(rows, lane, velocity);
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

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#endif
