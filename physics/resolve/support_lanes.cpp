// A vertical load acts about a point at its horizontal distance x, which follows from its arms about the
// normal n and the tangent t of the contact:  x = (n . up) (r x n) - (n . right) (r x t)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "resolve/support_lanes.cpp"
#include "resolve/support_lanes.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/motion.h"
#include "base/simd_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

HWY_INLINE void find_part(const ContactBlock& block, BlockKind kind, Vec2 up, int lane, SupportLanes& out) {
    const V zero = hn::Zero(D());
    const V nx = load(block.normal_x, lane);
    const V ny = load(block.normal_y, lane);
    const Vec2 right = right_perp(up);
    const V along = hn::Add(hn::Mul(nx, set(up.x)), hn::Mul(ny, set(up.y)));
    const V across = hn::Add(hn::Mul(nx, set(right.x)), hn::Mul(ny, set(right.y)));
    // The normal points from a to b.
    const M b_stands = hn::Gt(along, zero);
    const auto b_stands_int = hn::RebindMask(DI(), b_stands);
    const M has_point = hn::Gt(load(block.points[0].mass, lane), zero);
    const M has_two = hn::Gt(load(block.points[1].mass, lane), zero);
    M bears = hn::Gt(hn::Abs(along), set(kind == BlockKind::TwoBodies ? kBearingBetween : kBearing));
    const VI a = load(block.a, lane);
    const VI b = load(block.b, lane);
    VI lower = hn::IfThenElse(b_stands_int, a, b);
    if (kind != BlockKind::TwoBodies) {  // a has no weight
        // With one point it does not matter where friction acts; with two it must hold, or they share
        // otherwise.
        const M holds = hn::Ge(hn::Mul(load(block.friction, lane), along), hn::Abs(across));
        const M is_slope = hn::And(hn::Gt(along, set(kSlope)), hn::Or(hn::Not(has_two), holds));
        bears = hn::Or(hn::And(bears, b_stands), is_slope);
        lower = set_int(kWorldRow);
    }
    bears = hn::And(bears, has_point);
    const VI upper = hn::IfThenElse(b_stands_int, b, a);
    store(hn::IfThenElse(hn::RebindMask(DI(), bears), upper, set_int(kWorldRow)), out.upper, lane);
    store(lower, out.lower, lane);
    store(hn::IfThenElse(hn::RebindMask(DI(), has_two), set_int(2), set_int(1)), out.points, lane);
    store(hn::Abs(along), out.steepness, lane);
    const V shift_a = hn::Mul(across, load(block.tangent_arm_a, lane));
    const V shift_b = hn::Mul(across, load(block.tangent_arm_b, lane));
    for (int i = 0; i < 2; ++i) {
        const V x_a = hn::Sub(hn::Mul(along, load(block.points[i].arm_a, lane)), shift_a);
        const V x_b = hn::Sub(hn::Mul(along, load(block.points[i].arm_b, lane)), shift_b);
        store(hn::IfThenElse(b_stands, x_b, x_a), out.x[i], lane);
        store(hn::IfThenElse(b_stands, x_a, x_b), out.x_below[i], lane);
        store(zero, out.impulse[i], lane);
    }
}

void find_supports(const ContactBlock& block, BlockKind kind, Vec2 up, SupportLanes& out) {
    for (int lane = 0; lane < kLanes; lane += kStep) find_part(block, kind, up, lane, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(find_supports);

void find_supports(const ContactBlock& block, BlockKind kind, Vec2 up, SupportLanes& out) {
    HWY_DYNAMIC_DISPATCH(find_supports)(block, kind, up, out);
}

}  // namespace cairn::physics
#endif
