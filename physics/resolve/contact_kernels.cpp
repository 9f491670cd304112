// SIMD passes over contact blocks. Glossary: v velocity, w scaled angular velocity, d motion since the start
// of the step, theta scaled angle; n, t normal and tangent; r scaled arm; s separation; p impulse.
//     Jv = n . (vB - vA) + rB wB - rA wA,    s = s0 + n . (dB - dA) + rB thetaB - rA thetaA
// Inside a block only the scalars n . dv and t . dv are kept; they expand to vectors once, at the end.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "resolve/contact_kernels.cpp"
#include "resolve/contact_kernels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <span>

#include <cairn/physics/tuning.h>

#include "base/prefetch.h"
#include "base/simd_rows-inl.h"
#include "base/standing.h"
#include "resolve/contact_pair-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

// Of a block, all that a pass touches.
constexpr std::size_t kFetchedBytes = offsetof(ContactBlock, total_impulse);

// Blocks ahead of which bodies are asked for.
constexpr std::size_t kBodiesAhead = 2;
constexpr std::size_t kRowFloats = sizeof(VelocityRow) / sizeof(float);

// The friction row: limited by the sum of the normal impulses.
template <BlockKind kKind, bool kWatched>
HWY_INLINE V solve_friction(ContactBlock& block, int lane, Pair<kKind>& pair, V normal_sum,
                            const Taking<kWatched>& taking) {
    const V arm_a = load(block.tangent_arm_a, lane);
    const V arm_b = load(block.tangent_arm_b, lane);
    const V limit = hn::Mul(load(block.friction, lane), normal_sum);
    const V old = load(block.friction_impulse, lane);
    const V wanted =
        hn::Sub(old, hn::Mul(load(block.tangent_mass, lane), pair.jv(pair.tangent_velocity, arm_a, arm_b)));
    const V impulse = taking(hn::Max(hn::Neg(limit), hn::Min(wanted, limit)), old);
    store(impulse, block.friction_impulse, lane);
    const V change = hn::Sub(impulse, old);
    pair.turn(change, arm_a, arm_b);
    return change;
}

// The impulse about which a contact is soft: the estimate, but not much more than what it bore last, so that
// an estimate that is wrong cannot push.
HWY_INLINE V base_of(V static_impulse, V last) {
    return hn::Min(static_impulse, hn::Mul(hn::Set(D(), kStaticsTrust), last));
}

// A loaded point that opens by less than can be seen stays soft: a hard stop there would ratchet.
HWY_INLINE M is_apart(V separation, V base_impulse) {
    const V zero = hn::Zero(D());
    const V gap = hn::IfThenElseZero(hn::Gt(base_impulse, zero), hn::Set(D(), tuning::kLinearSlop_m));
    return hn::Gt(separation, gap);
}

// Rows that get a kick do not stand any more.
template <BlockKind kKind>
HWY_INLINE void disturb(const ContactBlock& block, int lane, V impulses, V inverse_mass,
                        std::uint8_t* standing) {
    const V kick = hn::Mul(impulses, inverse_mass);
    for (unsigned kicked = bits_of(hn::Gt(kick, set(kStillSpeed_m_s))); kicked != 0; kicked &= kicked - 1) {
        const int i = lane + std::countr_zero(kicked);
        standing[block.b[i]] = kMoves;
        if constexpr (moves_a(kKind)) standing[block.a[i]] = kMoves;
    }
}

template <BlockKind kKind, bool kWatched>
HWY_INLINE void solve_lanes(ContactBlock& block, int lane, float* velocity, const ContactPassTime& time,
                            const Taking<kWatched>& taking, std::uint8_t* standing) {
    const V one = set(1);
    const V nx = load(block.normal_x, lane);
    const V ny = load(block.normal_y, lane);
    Pair<kKind> pair(block, lane, velocity, nx, ny);
    std::array<PointLanes, 2> points;
    std::array<V, 2> base;
    std::array<V, 2> mass_scale;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ContactBlockPoint& stored = block.points[i];
        PointLanes& p = points[i];
        p.old = load(stored.impulse, lane);
        p.arm_a = load(stored.arm_a, lane);
        p.arm_b = load(stored.arm_b, lane);
        p.mass = load(stored.mass, lane);
        const V s = load(stored.separation, lane);
        base[i] = base_of(load(stored.static_impulse, lane), p.old);
        const M apart = is_apart(s, base[i]);
        const V soft_bias =
            hn::Max(hn::Mul(set(time.softness.bias_rate), s), set(-time.max_push_out_speed_m_s));
        p.bias = hn::IfThenElse(apart, hn::Mul(s, set(time.inverse_h_1_s)), soft_bias);
        mass_scale[i] = hn::IfThenElse(apart, one, set(time.softness.mass_scale));
    }
    const V old0 = points[0].old;
    const V old1 = points[1].old;
    const Normals rigid = couple(pair, points);
    const Normals soft = softened(rigid, mass_scale[0], mass_scale[1]);
    const V give0 = hn::Sub(soft.k00, rigid.k00);
    const V give1 = hn::Sub(soft.k11, rigid.k11);
    const V b0 = hn::Sub(
        residual(pair, points[0]),
        hn::Add(hn::Mul(give0, base[0]), hn::Add(hn::Mul(rigid.k00, old0), hn::Mul(rigid.k01, old1))));
    const V b1 = hn::Sub(
        residual(pair, points[1]),
        hn::Add(hn::Mul(give1, base[1]), hn::Add(hn::Mul(rigid.k01, old0), hn::Mul(rigid.k11, old1))));
    const Impulses found = solve_normals(soft, b0, b1, old1);
    const Impulses now{taking(found.first, old0), taking(found.second, old1)};

    store(now.first, block.points[0].impulse, lane);
    store(now.second, block.points[1].impulse, lane);
    const V change0 = hn::Sub(now.first, old0);
    const V change1 = hn::Sub(now.second, old1);
    pair.turn(change0, points[0].arm_a, points[0].arm_b);
    pair.turn(change1, points[1].arm_a, points[1].arm_b);
    const V tangent_change = solve_friction(block, lane, pair, hn::Add(now.first, now.second), taking);
    pair.finish(block, lane, velocity, nx, ny, hn::Add(change0, change1), tangent_change, taking);
    if constexpr (kWatched) {
        const V kicks = hn::Add(hn::Abs(change0), hn::Add(hn::Abs(change1), hn::Abs(tangent_change)));
        disturb<kKind>(block, lane, kicks, pair.inverse_mass, standing);
    }
}

template <BlockKind kKind, bool kWatched>
HWY_INLINE void relax_lanes(ContactBlock& block, int lane, float* velocity, const float* pose,
                            const ContactPassTime& time, const Taking<kWatched>& taking,
                            std::uint8_t* standing) {
    const V nx = load(block.normal_x, lane);
    const V ny = load(block.normal_y, lane);
    const Columns pose_b = load_rows(pose, block.b.data() + lane);
    Columns pose_a{};
    V dx = pose_b.x;
    V dy = pose_b.y;
    if constexpr (reads_a(kKind)) {
        pose_a = load_rows(pose, block.a.data() + lane);
        dx = hn::Sub(dx, pose_a.x);
        dy = hn::Sub(dy, pose_a.y);
    }
    const V moved = hn::Add(hn::Mul(nx, dx), hn::Mul(ny, dy));

    Pair<kKind> pair(block, lane, velocity, nx, ny);
    std::array<PointLanes, 2> points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        ContactBlockPoint& stored = block.points[i];
        PointLanes& p = points[i];
        p.old = load(stored.impulse, lane);
        p.arm_a = load(stored.arm_a, lane);
        p.arm_b = load(stored.arm_b, lane);
        p.mass = load(stored.mass, lane);
        V s = hn::Add(load(stored.start_separation, lane), hn::Add(moved, hn::Mul(p.arm_b, pose_b.z)));
        if constexpr (reads_a(kKind)) s = hn::Sub(s, hn::Mul(p.arm_a, pose_a.z));
        store(taking(s, load(stored.separation, lane)), stored.separation, lane);
        p.bias = hn::IfThenElseZero(is_apart(s, base_of(load(stored.static_impulse, lane), p.old)),
                                    hn::Mul(s, hn::Set(D(), time.inverse_h_1_s)));
    }
    const V tangent_arm_a = load(block.tangent_arm_a, lane);
    const V tangent_arm_b = load(block.tangent_arm_b, lane);
    const V k0t = coupling_by_turning<kKind>(points[0].arm_a, points[0].arm_b, tangent_arm_a, tangent_arm_b);
    const V k1t = coupling_by_turning<kKind>(points[1].arm_a, points[1].arm_b, tangent_arm_a, tangent_arm_b);
    const V old0 = points[0].old;
    const V old1 = points[1].old;
    const V old_tangent = load(block.friction_impulse, lane);

    // Normals, friction, and normals again, since friction turns the bodies and what comes last is satisfied
    // best. All of it in impulses: what one row adds to another follows from how they couple.
    const Normals normals = couple(pair, points);
    V b0 =
        hn::Sub(residual(pair, points[0]), hn::Add(hn::Mul(normals.k00, old0), hn::Mul(normals.k01, old1)));
    V b1 =
        hn::Sub(residual(pair, points[1]), hn::Add(hn::Mul(normals.k01, old0), hn::Mul(normals.k11, old1)));
    const V sliding = pair.jv(pair.tangent_velocity, tangent_arm_a, tangent_arm_b);
    const Impulses before = solve_normals(normals, b0, b1, old1);
    const V slip = hn::Add(sliding, hn::Add(hn::Mul(k0t, hn::Sub(before.first, old0)),
                                            hn::Mul(k1t, hn::Sub(before.second, old1))));
    const V wanted = hn::Sub(old_tangent, hn::Mul(load(block.tangent_mass, lane), slip));
    const V limit = hn::Mul(load(block.friction, lane), hn::Add(before.first, before.second));
    const V tangent = taking(hn::Max(hn::Neg(limit), hn::Min(wanted, limit)), old_tangent);
    const V tangent_change = hn::Sub(tangent, old_tangent);
    b0 = hn::Add(b0, hn::Mul(k0t, tangent_change));
    b1 = hn::Add(b1, hn::Mul(k1t, tangent_change));
    const Impulses found = solve_normals(normals, b0, b1, before.second);
    const Impulses now{taking(found.first, old0), taking(found.second, old1)};

    store(tangent, block.friction_impulse, lane);
    store(now.first, block.points[0].impulse, lane);
    store(now.second, block.points[1].impulse, lane);
    if (block.reports) {
        store(hn::Add(load(block.total_impulse[0], lane), now.first), block.total_impulse[0], lane);
        store(hn::Add(load(block.total_impulse[1], lane), now.second), block.total_impulse[1], lane);
    }
    const V change0 = hn::Sub(now.first, old0);
    const V change1 = hn::Sub(now.second, old1);
    pair.turn(change0, points[0].arm_a, points[0].arm_b);
    pair.turn(change1, points[1].arm_a, points[1].arm_b);
    pair.turn(tangent_change, tangent_arm_a, tangent_arm_b);
    pair.finish(block, lane, velocity, nx, ny, hn::Add(change0, change1), tangent_change, taking);
    if constexpr (kWatched) {
        const V kicks = hn::Add(hn::Abs(change0), hn::Add(hn::Abs(change1), hn::Abs(tangent_change)));
        disturb<kKind>(block, lane, kicks, pair.inverse_mass, standing);
    }
}

template <BlockKind kKind>
HWY_INLINE void warm_start_lanes(ContactBlock& block, int lane, float* velocity, V step_ratio,
                                 V friction_ratio) {
    const V nx = load(block.normal_x, lane);
    const V ny = load(block.normal_y, lane);
    Pair<kKind> pair(block, lane, velocity, nx, ny);
    V sum = hn::Zero(D());
    for (ContactBlockPoint& point : block.points) {
        const V remembered = load(point.impulse, lane);
        const V at_rest = load(point.static_impulse, lane);
        const V scaled = hn::Min(hn::Mul(step_ratio, remembered), hn::Max(remembered, at_rest));
        const V impulse = hn::IfThenElse(hn::Lt(remembered, hn::Zero(D())), at_rest, scaled);
        store(impulse, point.impulse, lane);
        pair.turn(impulse, load(point.arm_a, lane), load(point.arm_b, lane));
        sum = hn::Add(sum, impulse);
    }
    const V tangent = hn::Mul(friction_ratio, load(block.friction_impulse, lane));
    store(tangent, block.friction_impulse, lane);
    pair.turn(tangent, load(block.tangent_arm_a, lane), load(block.tangent_arm_b, lane));
    pair.finish(block, lane, velocity, nx, ny, sum, tangent);
}

HWY_INLINE void fetch_bodies_ahead(std::span<ContactBlock* const> blocks, std::size_t at,
                                   const float* velocity) {
    if (at + kBodiesAhead >= blocks.size()) return;
    const ContactBlock& block = *blocks[at + kBodiesAhead];
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        prefetch_to_write(velocity + kRowFloats * static_cast<std::size_t>(block.a[lane]));
        prefetch_to_write(velocity + kRowFloats * static_cast<std::size_t>(block.b[lane]));
    }
}

// Bits: lanes of which not both bodies stand.
HWY_INLINE unsigned disturbed_lanes(const ContactBlock& block, const std::uint8_t* standing) {
    unsigned lanes = 0;
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const unsigned both = standing[block.a[lane]] & standing[block.b[lane]] & kStands;
        lanes |= (both ^ kStands) << lane;
    }
    return lanes;
}

// Calls pass(block, lane) for all blocks.
template <class LanesPass>
HWY_INLINE void for_blocks(const ContactBlocks& run, const float* velocity, const LanesPass& pass) {
    const auto& blocks = run.blocks;
    for (std::size_t n = 0; n < blocks.size(); ++n) {
        if (n + kBlocksAhead < blocks.size()) prefetch(blocks[n + kBlocksAhead], kFetchedBytes);
        if (run.are_shared) fetch_bodies_ahead(blocks, n, velocity);
        for (int lane = 0; lane < kLanes; lane += kStep) pass(*blocks[n], lane);
    }
}

// Calls pass(block, lane, lanes that take part) for blocks of which not all bodies stand, a few at a time:
// blocks of a colour share no body, so none of them disturbs another.
template <class LanesPass>
HWY_INLINE void for_disturbed_blocks(const ContactBlocks& run, const float* velocity, const LanesPass& pass) {
    constexpr std::size_t kAtOnce = 2 * kBlocksAhead;
    std::array<ContactBlock*, kAtOnce> found;
    std::array<unsigned, kAtOnce> lanes;
    for (std::size_t first = 0; first < run.blocks.size(); first += kAtOnce) {
        const std::size_t last = std::min(first + kAtOnce, run.blocks.size());
        std::size_t count = 0;
        for (std::size_t n = first; n < last; ++n) {
            if (n + kAtOnce < run.blocks.size()) prefetch(run.blocks[n + kAtOnce], kCacheLine_B);
            ContactBlock* const block = run.blocks[n];
            lanes[count] = disturbed_lanes(*block, run.standing);
            if (lanes[count] == 0) continue;
            prefetch(block, kFetchedBytes);
            found[count++] = block;
        }
        const std::span<ContactBlock* const> disturbed(found.data(), count);
        for (std::size_t n = 0; n < count; ++n) {
            if (run.are_shared) fetch_bodies_ahead(disturbed, n, velocity);
            for (int lane = 0; lane < kLanes; lane += kStep)
                pass(*disturbed[n], lane, Taking<true>{wanted_lanes(lanes[n], lane)});
        }
    }
}

template <BlockKind kKind>
void solve_all(const ContactBlocks& run, float* velocity, const ContactPassTime& time) {
    if (run.standing == nullptr) {
        for_blocks(run, velocity, [&](ContactBlock& block, int lane) HWY_ATTR {
            solve_lanes<kKind>(block, lane, velocity, time, Taking<false>{}, nullptr);
        });
    } else {
        const auto solve = [&](ContactBlock& block, int lane, const Taking<true>& taking) HWY_ATTR {
            solve_lanes<kKind>(block, lane, velocity, time, taking, run.standing);
        };
        for_disturbed_blocks(run, velocity, solve);
    }
}

template <BlockKind kKind>
void relax_all(const ContactBlocks& run, float* velocity, const float* pose, const ContactPassTime& time) {
    if (run.standing == nullptr) {
        for_blocks(run, velocity, [&](ContactBlock& block, int lane) HWY_ATTR {
            relax_lanes<kKind>(block, lane, velocity, pose, time, Taking<false>{}, nullptr);
        });
    } else {
        const auto relax = [&](ContactBlock& block, int lane, const Taking<true>& taking) HWY_ATTR {
            relax_lanes<kKind>(block, lane, velocity, pose, time, taking, run.standing);
        };
        for_disturbed_blocks(run, velocity, relax);
    }
}

template <BlockKind kKind>
void warm_start_all(const ContactBlocks& run, float* velocity, float step_ratio, float friction_ratio) {
    for_blocks(run, velocity, [&](ContactBlock& block, int lane) HWY_ATTR {
        warm_start_lanes<kKind>(block, lane, velocity, set(step_ratio), set(friction_ratio));
    });
}

void solve_blocks(const ContactBlocks& run, float* velocity, const ContactPassTime& time) {
    switch (run.kind) {
        case BlockKind::TwoBodies:
            return solve_all<BlockKind::TwoBodies>(run, velocity, time);
        case BlockKind::OneBody:
            return solve_all<BlockKind::OneBody>(run, velocity, time);
        case BlockKind::Carried:
            return solve_all<BlockKind::Carried>(run, velocity, time);
    }
}

void relax_blocks(const ContactBlocks& run, float* velocity, const float* pose, const ContactPassTime& time) {
    switch (run.kind) {
        case BlockKind::TwoBodies:
            return relax_all<BlockKind::TwoBodies>(run, velocity, pose, time);
        case BlockKind::OneBody:
            return relax_all<BlockKind::OneBody>(run, velocity, pose, time);
        case BlockKind::Carried:
            return relax_all<BlockKind::Carried>(run, velocity, pose, time);
    }
}

void warm_start_blocks(const ContactBlocks& run, float* velocity, float step_ratio, float friction_ratio) {
    switch (run.kind) {
        case BlockKind::TwoBodies:
            return warm_start_all<BlockKind::TwoBodies>(run, velocity, step_ratio, friction_ratio);
        case BlockKind::OneBody:
            return warm_start_all<BlockKind::OneBody>(run, velocity, step_ratio, friction_ratio);
        case BlockKind::Carried:
            return warm_start_all<BlockKind::Carried>(run, velocity, step_ratio, friction_ratio);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(solve_blocks);
HWY_EXPORT(relax_blocks);
HWY_EXPORT(warm_start_blocks);

void solve_blocks(const ContactBlocks& run, VelocityRow* velocity, const ContactPassTime& time) {
    HWY_DYNAMIC_DISPATCH(solve_blocks)(run, &velocity->v.x, time);
}

void relax_blocks(const ContactBlocks& run, VelocityRow* velocity, const PoseRow* pose,
                  const ContactPassTime& time) {
    HWY_DYNAMIC_DISPATCH(relax_blocks)(run, &velocity->v.x, &pose->d.x, time);
}

void warm_start_blocks(const ContactBlocks& run, VelocityRow* velocity, float step_ratio,
                       float friction_ratio) {
    HWY_DYNAMIC_DISPATCH(warm_start_blocks)(run, &velocity->v.x, step_ratio, friction_ratio);
}

}  // namespace cairn::physics
#endif
