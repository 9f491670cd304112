// Eight contacts of a block as the SIMD passes work on them: velocities of the bodies in the block's own
// coordinates, and the normal rows of a manifold brought to their targets together. To be included as
// base/simd_rows-inl.h is, after it. Glossary: resolve/contact_kernels.cpp.
#if defined(CAIRN_PHYSICS_RESOLVE_CONTACT_PAIR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CAIRN_PHYSICS_RESOLVE_CONTACT_PAIR_INL_H_
#undef CAIRN_PHYSICS_RESOLVE_CONTACT_PAIR_INL_H_
#else
#define CAIRN_PHYSICS_RESOLVE_CONTACT_PAIR_INL_H_
#endif

#include <array>
#include <hwy/highway.h>

#include "base/simd_rows-inl.h"
#include "resolve/contact_block.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

// Whether the velocity of a is read, and whether it is changed.
constexpr bool reads_a(BlockKind kind) {
    return kind != BlockKind::OneBody;
}
constexpr bool moves_a(BlockKind kind) {
    return kind == BlockKind::TwoBodies;
}

// Lanes that take part in a pass; the others are to be left as they are, to the bit.
template <bool kWatched>
struct Taking {
    M lanes{};

    HWY_INLINE V operator()(V now, V before) const {
        if constexpr (kWatched) return hn::IfThenElse(lanes, now, before);
        return now;
    }
};

// The velocities of some lanes of a block, in the block's own coordinates.
template <BlockKind kKind>
struct Pair {
    Columns a;  // unused when only b moves
    Columns b;
    V normal_velocity;   // n . (vB - vA)
    V tangent_velocity;  // t . (vB - vA)
    V inverse_mass;      // 1/mA + 1/mB

    HWY_INLINE Pair(const ContactBlock& block, int lane, const float* velocity, V nx, V ny) {
        b = load_rows(velocity, block.b.data() + lane);
        V vx = b.x;
        V vy = b.y;
        inverse_mass = b.u;
        if constexpr (reads_a(kKind)) {
            a = load_rows(velocity, block.a.data() + lane);
            vx = hn::Sub(vx, a.x);
            vy = hn::Sub(vy, a.y);
        }
        if constexpr (moves_a(kKind)) inverse_mass = hn::Add(inverse_mass, a.u);
        normal_velocity = hn::Add(hn::Mul(nx, vx), hn::Mul(ny, vy));
        tangent_velocity = hn::Sub(hn::Mul(ny, vx), hn::Mul(nx, vy));
    }

    [[nodiscard]] HWY_INLINE V jv(V along, V arm_a, V arm_b) const {
        V result = hn::Add(along, hn::Mul(arm_b, b.z));
        if constexpr (reads_a(kKind)) result = hn::Sub(result, hn::Mul(arm_a, a.z));
        return result;
    }

    HWY_INLINE void turn(V impulse, V arm_a, V arm_b) {
        b.z = hn::Add(b.z, hn::Mul(arm_b, impulse));
        if constexpr (moves_a(kKind)) a.z = hn::Sub(a.z, hn::Mul(arm_a, impulse));
    }

    template <bool kWatched = false>
    HWY_INLINE void finish(const ContactBlock& block, int lane, float* velocity, V nx, V ny, V normal_impulse,
                           V tangent_impulse, const Taking<kWatched>& taking = {}) {
        const V px = hn::Add(hn::Mul(normal_impulse, nx), hn::Mul(tangent_impulse, ny));
        const V py = hn::Sub(hn::Mul(normal_impulse, ny), hn::Mul(tangent_impulse, nx));
        b.x = hn::Add(b.x, hn::Mul(b.u, px));
        b.y = hn::Add(b.y, hn::Mul(b.u, py));
        put_back(velocity, block.b.data() + lane, b, taking);
        if constexpr (moves_a(kKind)) {
            a.x = hn::Sub(a.x, hn::Mul(a.u, px));
            a.y = hn::Sub(a.y, hn::Mul(a.u, py));
            put_back(velocity, block.a.data() + lane, a, taking);
        }
    }

  private:
    template <bool kWatched>
    static HWY_INLINE void put_back(float* velocity, const std::int32_t* rows, Columns now,
                                    const Taking<kWatched>& taking) {
        if constexpr (kWatched) {
            const Columns before = load_rows(velocity, rows);
            now = {taking(now.x, before.x), taking(now.y, before.y), taking(now.z, before.z), now.u};
        }
        store_rows(velocity, rows, now);
    }
};

struct PointLanes {
    V arm_a;
    V arm_b;
    V mass;
    V bias;
    V old;  // impulse so far
};

template <BlockKind kKind>
HWY_INLINE V residual(const Pair<kKind>& pair, const PointLanes& p) {
    return hn::Add(pair.jv(pair.normal_velocity, p.arm_a, p.arm_b), p.bias);
}

// Inverse effective mass of two rows that push along the same axis against each other.
template <BlockKind kKind>
HWY_INLINE V coupling_by_turning(V arm_a, V arm_b, V other_arm_a, V other_arm_b) {
    V k = hn::Mul(arm_b, other_arm_b);
    if constexpr (moves_a(kKind)) k = hn::Add(k, hn::Mul(arm_a, other_arm_a));
    return k;
}

template <BlockKind kKind>
HWY_INLINE V coupling(const Pair<kKind>& pair, const PointLanes& p, const PointLanes& q) {
    return hn::Add(pair.inverse_mass, coupling_by_turning<kKind>(p.arm_a, p.arm_b, q.arm_a, q.arm_b));
}

struct Impulses {
    V first;
    V second;
};

// The normal rows of a manifold: K x = -b has the solution inverse (k01 b1 - k11 b0, k01 b0 - k00 b1).
struct Normals {
    V k00, k11, k01;
    V mass0, mass1;
    V k01_mass0;
    V inverse;
    M regular;  // else there is one point, or the two are too near each other to be told apart
};

template <BlockKind kKind>
HWY_INLINE Normals couple(const Pair<kKind>& pair, const std::array<PointLanes, 2>& p) {
    Normals n;
    n.k00 = coupling(pair, p[0], p[0]);
    n.k11 = coupling(pair, p[1], p[1]);
    n.k01 = coupling(pair, p[0], p[1]);
    n.mass0 = p[0].mass;
    n.mass1 = p[1].mass;
    n.k01_mass0 = hn::Mul(n.k01, n.mass0);
    const V product = hn::Mul(n.k00, n.k11);
    const V determinant = hn::Sub(product, hn::Mul(n.k01, n.k01));
    n.inverse = hn::Div(set(1), determinant);
    n.regular = hn::And(hn::Gt(determinant, hn::Mul(set(1e-3f), product)), hn::Gt(n.mass1, hn::Zero(D())));
    return n;
}

// The same of rows that give. What a row gives adds K impulse_scale / mass_scale to its K, which makes it
// K / mass_scale, since the two scales add up to 1.
HWY_INLINE Normals softened(Normals n, V mass_scale0, V mass_scale1) {
    n.k00 = hn::Div(n.k00, mass_scale0);
    n.k11 = hn::Div(n.k11, mass_scale1);
    n.mass0 = hn::Mul(n.mass0, mass_scale0);
    n.mass1 = hn::Mul(n.mass1, mass_scale1);
    n.k01_mass0 = hn::Mul(n.k01, n.mass0);
    n.inverse = hn::Div(set(1), hn::Sub(hn::Mul(n.k00, n.k11), hn::Mul(n.k01, n.k01)));
    return n;
}

// Brings both points to their targets at once: sweeping would leave a part of the push-out velocity, and turn
// what lands flat about its first point. b is what their velocities would miss if their impulses were zero.
// As solve_both in contact_constraint.cpp: the case that fits is selected, from the last to the first.
HWY_INLINE Impulses solve_normals(const Normals& n, V b0, V b1, V old1) {
    const V zero = hn::Zero(D());
    const V both0 = hn::Mul(n.inverse, hn::Sub(hn::Mul(n.k01, b1), hn::Mul(n.k11, b0)));
    const V both1 = hn::Mul(n.inverse, hn::Sub(hn::Mul(n.k01, b0), hn::Mul(n.k00, b1)));
    const M both = hn::And(hn::Ge(both0, zero), hn::Ge(both1, zero));
    const V alone0 = hn::Neg(hn::Mul(b0, n.mass0));
    const M only0 = hn::And(hn::Ge(alone0, zero), hn::Ge(hn::Add(hn::Mul(n.k01, alone0), b1), zero));
    const V alone1 = hn::Neg(hn::Mul(b1, n.mass1));
    const M only1 = hn::And(hn::Ge(alone1, zero), hn::Ge(hn::Add(hn::Mul(n.k01, alone1), b0), zero));
    const V first = hn::IfThenElse(both, both0, hn::IfThenElseZero(only0, alone0));
    const V second =
        hn::IfThenElse(both, both1, hn::IfThenZeroElse(only0, hn::IfThenElseZero(only1, alone1)));
    // One after the other, where the two cannot be told apart.
    const V swept0 = hn::Max(hn::Sub(alone0, hn::Mul(n.k01_mass0, old1)), zero);
    const V swept1 = hn::Max(hn::Sub(alone1, hn::Mul(n.mass1, hn::Mul(n.k01, swept0))), zero);
    return {hn::IfThenElse(n.regular, first, swept0), hn::IfThenElse(n.regular, second, swept1)};
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#endif
