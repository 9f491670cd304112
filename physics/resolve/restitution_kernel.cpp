// The formulas are those of resolve/restitution.cpp.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "resolve/restitution_kernel.cpp"
#include "resolve/restitution_kernel.h"

#include <array>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/simd_rows-inl.h"
#include "resolve/contact_pair-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

// Relative acceleration along the normal, times a substep.
template <BlockKind kKind>
HWY_INLINE V opening_kick(const ContactBlock& block, int lane, const float* kick, V nx, V ny) {
    const Columns b = load_rows(kick, block.b.data() + lane);
    V along = hn::Add(hn::Mul(nx, b.x), hn::Mul(ny, b.y));
    if constexpr (reads_a(kKind)) {
        const Columns a = load_rows(kick, block.a.data() + lane);
        along = hn::Sub(along, hn::Add(hn::Mul(nx, a.x), hn::Mul(ny, a.y)));
    }
    return along;
}

HWY_INLINE V not_negative(V x) {
    return hn::Max(x, hn::Zero(D()));
}

HWY_INLINE V leaving_speed(V closing, V start_separation, V separation, V restitution, V twice_g) {
    const V impact_squared =
        not_negative(hn::Sub(hn::Mul(closing, closing), hn::Mul(twice_g, start_separation)));
    const V given_back = hn::Mul(hn::Mul(restitution, restitution), impact_squared);
    return hn::Sqrt(not_negative(hn::Add(given_back, hn::Mul(twice_g, separation))));
}

template <BlockKind kKind>
HWY_INLINE void give_back_lanes(ContactBlock& block, const ImpactLanes& impacts, int lane, float* velocity,
                                const float* kick, const ReboundTime& time) {
    const V zero = hn::Zero(D());
    const M wanted = wanted_lanes(block.bounces, lane);
    std::array<M, 2> met;
    for (std::size_t i = 0; i < met.size(); ++i) {
        const M is_fast = hn::Le(load(impacts.closing_velocity[i], lane), set(-time.slow_m_s));
        met[i] = hn::And(wanted, hn::And(is_fast, hn::Gt(load(block.total_impulse[i], lane), zero)));
    }
    const M bounces = hn::Or(met[0], met[1]);
    if (hn::AllFalse(D(), bounces)) return;

    const V nx = load(block.normal_x, lane);
    const V ny = load(block.normal_y, lane);
    const V restitution = load(impacts.restitution, lane);
    const V twice_g = hn::Mul(set(2 * time.inverse_h_1_s), opening_kick<kKind>(block, lane, kick, nx, ny));
    Pair<kKind> pair(block, lane, velocity, nx, ny);
    std::array<PointLanes, 2> points;
    std::array<V, 2> missing;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ContactBlockPoint& stored = block.points[i];
        PointLanes& p = points[i];
        p = {load(stored.arm_a, lane), load(stored.arm_b, lane), load(stored.mass, lane), zero,
             load(stored.impulse, lane)};
        // Points that did not meet fast keep the velocity that they have.
        V start = load(stored.start_separation, lane);
        if (block.turning != nullptr) start = hn::Sub(start, load(block.turning->bend[i], lane));
        const V target = leaving_speed(load(impacts.closing_velocity[i], lane), start,
                                       load(stored.separation, lane), restitution, twice_g);
        missing[i] = hn::IfThenElseZero(met[i], hn::Sub(residual(pair, p), target));
    }
    const V old0 = points[0].old;
    const V old1 = points[1].old;
    const Normals normals = couple(pair, points);
    const V b0 = hn::Sub(missing[0], hn::Add(hn::Mul(normals.k00, old0), hn::Mul(normals.k01, old1)));
    const V b1 = hn::Sub(missing[1], hn::Add(hn::Mul(normals.k01, old0), hn::Mul(normals.k11, old1)));
    const Impulses now = solve_normals(normals, b0, b1, old1);
    const V change0 = hn::IfThenElseZero(bounces, hn::Sub(now.first, old0));
    const V change1 = hn::IfThenElseZero(bounces, hn::Sub(now.second, old1));
    pair.turn(change0, points[0].arm_a, points[0].arm_b);
    pair.turn(change1, points[1].arm_a, points[1].arm_b);
    pair.finish(block, lane, velocity, nx, ny, hn::Add(change0, change1), zero);
    // They are no first guess for the next step, in which the bodies part.
    store(hn::IfThenZeroElse(bounces, old0), block.points[0].impulse, lane);
    store(hn::IfThenZeroElse(bounces, old1), block.points[1].impulse, lane);
    store(hn::IfThenZeroElse(bounces, load(block.friction_impulse, lane)), block.friction_impulse, lane);
}

template <BlockKind kKind>
void give_back_all(std::span<const BouncingBlock> blocks, float* velocity, const float* kick,
                   const ReboundTime& time) {
    for (const BouncingBlock& block : blocks) {
        for (int lane = 0; lane < kLanes; lane += kStep)
            give_back_lanes<kKind>(*block.contacts, *block.impacts, lane, velocity, kick, time);
    }
}

void give_back_blocks(std::span<const BouncingBlock> blocks, BlockKind kind, float* velocity,
                      const float* kick, const ReboundTime& time) {
    switch (kind) {
        case BlockKind::TwoBodies:
            return give_back_all<BlockKind::TwoBodies>(blocks, velocity, kick, time);
        case BlockKind::OneBody:
            return give_back_all<BlockKind::OneBody>(blocks, velocity, kick, time);
        case BlockKind::Carried:
            return give_back_all<BlockKind::Carried>(blocks, velocity, kick, time);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(give_back_blocks);

void give_back_blocks(std::span<const BouncingBlock> blocks, BlockKind kind, VelocityRow* velocity,
                      const VelocityRow* kick, const ReboundTime& time) {
    HWY_DYNAMIC_DISPATCH(give_back_blocks)(blocks, kind, &velocity->v.x, &kick->v.x, time);
}

}  // namespace cairn::physics
#endif
