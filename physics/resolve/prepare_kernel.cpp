// Preparation of blocks. Glossary: r arm from a centre of mass to a point, n normal, t tangent, k =
// sqrt(1/I), K inverse effective mass:
//     arm = k (r x n),    K = 1/mA + 1/mB + arm_a^2 + arm_b^2
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "resolve/prepare_kernel.cpp"
#include "resolve/prepare_kernel.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cairn/physics/tuning.h>

#include "base/simd_rows-inl.h"
#include "resolve/contact_constraint.h"
#include "resolve/deep_overlap.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

struct Remembered {
    V impulse;
    M any;
};

// The impulse of the feature in the last step. Missing features are never asked for.
HWY_INLINE Remembered recall(VI id, VI old0, VI old1, V impulse0, V impulse1) {
    const M first = hn::RebindMask(D(), hn::Eq(id, old0));
    const M second = hn::RebindMask(D(), hn::Eq(id, old1));
    return {hn::IfThenElse(first, impulse0, hn::IfThenElseZero(second, impulse1)), hn::Or(first, second)};
}

struct Bodies {
    Columns velocity_a, velocity_b;
    V k_a, k_b;
    V inverse_mass;
};

HWY_INLINE Bodies load_bodies(const ContactBlock& block, const float* velocity, const float* pose, int lane) {
    const std::int32_t* a = block.a.data() + lane;
    const std::int32_t* b = block.b.data() + lane;
    Bodies bodies{load_rows(velocity, a), load_rows(velocity, b), load_rows(pose, a).u, load_rows(pose, b).u,
                  hn::Zero(D())};
    bodies.inverse_mass = hn::Add(bodies.velocity_a.u, bodies.velocity_b.u);
    return bodies;
}

HWY_INLINE V cross(V ax, V ay, V bx, V by) {
    return hn::Sub(hn::Mul(ax, by), hn::Mul(ay, bx));
}

// Effective mass. Bodies of which nothing can move, in unused lanes, get 0.
HWY_INLINE V effective_mass(const Bodies& bodies, V response_a, V arm_b) {
    const V k = hn::Add(bodies.inverse_mass, hn::Add(response_a, hn::Mul(arm_b, arm_b)));
    return hn::IfThenElseZero(hn::Gt(k, hn::Zero(D())), hn::Div(set(1), k));
}

// A body without inverse mass is turned by nothing, whatever its arm.
HWY_INLINE V response(const Columns& velocity, V arm) {
    return hn::IfThenElseZero(hn::Gt(velocity.u, hn::Zero(D())), hn::Mul(arm, arm));
}

HWY_INLINE PreparedLanes prepare_part(const PoseLanes& poses, const ManifoldLanes& manifold,
                                      const float* velocity, const float* pose, int lane,
                                      FeatureLanes& features, float impact_speed_m_s, ContactBlock& block,
                                      ImpactLanes* impacts) {
    const V zero = hn::Zero(D());
    const Bodies bodies = load_bodies(block, velocity, pose, lane);
    const V nx = load(manifold.normal_x, lane);
    const V ny = load(manifold.normal_y, lane);
    const V dx = load(poses.dx, lane);
    const V dy = load(poses.dy, lane);
    const V along_normal = hn::Add(hn::Mul(nx, hn::Sub(bodies.velocity_b.x, bodies.velocity_a.x)),
                                   hn::Mul(ny, hn::Sub(bodies.velocity_b.y, bodies.velocity_a.y)));
    store(nx, block.normal_x, lane);
    store(ny, block.normal_y, lane);

    const VI old0 = load(features[0], lane);
    const VI old1 = load(features[1], lane);
    const V impulse0 = load(block.points[0].impulse, lane);
    const V impulse1 = load(block.points[1].impulse, lane);
    const bool bounces =
        impacts != nullptr && !hn::AllTrue(D(), hn::Eq(load(impacts->restitution, lane), zero));
    M used = hn::FirstN(D(), 0);
    M carried = used;
    M swings = used;
    M fast = used;
    M deep = used;
    for (int i = 0; i < 2; ++i) {
        const ManifoldPointLanes& from = manifold.points[i];
        ContactBlockPoint& to = block.points[i];
        const VI id = load(from.id, lane);
        const M is_used = hn::RebindMask(D(), hn::Ne(id, set_int(kNoFeature)));
        const V rx = load(from.x, lane);
        const V ry = load(from.y, lane);
        const V lever_a = hn::IfThenElseZero(is_used, cross(rx, ry, nx, ny));
        const V lever_b = hn::IfThenElseZero(is_used, cross(hn::Sub(rx, dx), hn::Sub(ry, dy), nx, ny));
        const V arm_a = hn::Mul(bodies.k_a, lever_a);
        const V arm_b = hn::Mul(bodies.k_b, lever_b);
        const V s = hn::IfThenElse(is_used, load(from.separation, lane), set(1));
        const V jv = hn::Add(
            along_normal, hn::Sub(hn::Mul(arm_b, bodies.velocity_b.z), hn::Mul(arm_a, bodies.velocity_a.z)));
        const Remembered last = recall(id, old0, old1, impulse0, impulse1);
        const M rests =
            hn::And(hn::Le(s, set(0.1f * tuning::kLinearSlop_m)), hn::Lt(hn::Abs(jv), set(kRestSpeed_m_s)));
        const V first_guess =
            hn::IfThenElse(last.any, last.impulse, hn::IfThenElseZero(rests, set(kUnknownImpulse)));
        store(arm_a, to.arm_a, lane);
        store(arm_b, to.arm_b, lane);
        store(hn::IfThenElseZero(is_used, effective_mass(bodies, response(bodies.velocity_a, arm_a), arm_b)),
              to.mass, lane);
        store(s, to.start_separation, lane);
        store(s, to.separation, lane);
        store(zero, to.static_impulse, lane);
        store(hn::IfThenElseZero(is_used, first_guess), to.impulse, lane);
        store(zero, block.total_impulse[i], lane);
        if (bounces) store(jv, impacts->closing_velocity[i], lane);
        store(id, features[i], lane);
        used = hn::Or(used, is_used);
        deep = hn::Or(deep, hn::Lt(s, set(-kDeepOverlap_m)));
        fast = hn::Or(fast, hn::And(is_used, hn::Gt(hn::Abs(jv), set(impact_speed_m_s))));
        carried = hn::Or(carried, hn::And(is_used, last.any));
        swings =
            hn::Or(swings, hn::Gt(hn::Max(hn::Abs(lever_a), hn::Abs(lever_b)), set(tuning::kLinearSlop_m)));
    }

    // Midway between the points, or at the only one.
    const M two = hn::RebindMask(D(), hn::Ne(load(manifold.points[1].id, lane), set_int(kNoFeature)));
    const V x0 = load(manifold.points[0].x, lane);
    const V y0 = load(manifold.points[0].y, lane);
    const V half = set(0.5f);
    const V mx = hn::IfThenElse(two, hn::Mul(half, hn::Add(x0, load(manifold.points[1].x, lane))), x0);
    const V my = hn::IfThenElse(two, hn::Mul(half, hn::Add(y0, load(manifold.points[1].y, lane))), y0);
    const V tx = ny;
    const V ty = hn::Neg(nx);
    const V arm_a = hn::IfThenElseZero(used, hn::Mul(bodies.k_a, cross(mx, my, tx, ty)));
    const V arm_b =
        hn::IfThenElseZero(used, hn::Mul(bodies.k_b, cross(hn::Sub(mx, dx), hn::Sub(my, dy), tx, ty)));
    store(arm_a, block.tangent_arm_a, lane);
    store(arm_b, block.tangent_arm_b, lane);
    store(hn::IfThenElseZero(used, effective_mass(bodies, response(bodies.velocity_a, arm_a), arm_b)),
          block.tangent_mass, lane);
    store(hn::IfThenElseZero(carried, load(block.friction_impulse, lane)), block.friction_impulse, lane);
    return {bits_of(hn::Not(used)), bits_of(fast), bits_of(swings), bits_of(deep)};
}

void prepare_block(const PoseLanes& poses, const ManifoldLanes& manifold, const float* velocity,
                   const float* pose, FeatureLanes& features, float impact_speed_m_s, ContactBlock& block,
                   ImpactLanes* impacts, PreparedLanes& prepared) {
    for (int lane = 0; lane < kLanes; lane += kStep) {
        const PreparedLanes part =
            prepare_part(poses, manifold, velocity, pose, lane, features, impact_speed_m_s, block, impacts);
        prepared.apart |= part.apart << lane;
        prepared.fast |= part.fast << lane;
        prepared.swings |= part.swings << lane;
        prepared.deep |= part.deep << lane;
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(prepare_block);

PreparedLanes prepare_block(const PoseLanes& poses, const ManifoldLanes& manifold,
                            const VelocityRow* velocity, const PoseRow* pose, FeatureLanes& features,
                            float impact_speed_m_s, ContactBlock& block, ImpactLanes* impacts) {
    PreparedLanes prepared;
    HWY_DYNAMIC_DISPATCH(prepare_block)
    (poses, manifold, &velocity->v.x, &pose->d.x, features, impact_speed_m_s, block, impacts, prepared);
    return prepared;
}

}  // namespace cairn::physics
#endif
