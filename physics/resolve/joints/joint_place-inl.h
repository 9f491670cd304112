// What the kernels share that place joints at the start of a step. Glossary: c, s cosine and sine of how b
// stands to a. To be included as joint_block-inl.h.
#if defined(CAIRN_PHYSICS_RESOLVE_JOINTS_JOINT_PLACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CAIRN_PHYSICS_RESOLVE_JOINTS_JOINT_PLACE_INL_H_
#undef CAIRN_PHYSICS_RESOLVE_JOINTS_JOINT_PLACE_INL_H_
#else
#define CAIRN_PHYSICS_RESOLVE_JOINTS_JOINT_PLACE_INL_H_
#endif

#include "base/simd_rows-inl.h"
#include "resolve/joints/joint_block-inl.h"

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

// How the bodies of a block stand.
struct PlaceLanes {
    alignas(32) Lanes<float> cos_a;
    Lanes<float> sin_a;
    Lanes<float> cos_b;
    Lanes<float> sin_b;
};

// The same of some lanes.
struct Stance {
    V c_a, s_a, c_b, s_b;

    HWY_INLINE Stance(const PlaceLanes& places, int lane)
        : c_a(load(places.cos_a, lane)),
          s_a(load(places.sin_a, lane)),
          c_b(load(places.cos_b, lane)),
          s_b(load(places.sin_b, lane)) {}

    [[nodiscard]] HWY_INLINE Pair2 rotate_a(V x, V y) const { return rotate(c_a, s_a, x, y); }
    [[nodiscard]] HWY_INLINE Pair2 rotate_b(V x, V y) const { return rotate(c_b, s_b, x, y); }
    // As cosine and sine, of b relative to a.
    [[nodiscard]] HWY_INLINE Pair2 turn() const {
        return {hn::Add(hn::Mul(c_a, c_b), hn::Mul(s_a, s_b)), hn::Sub(hn::Mul(c_a, s_b), hn::Mul(s_a, c_b))};
    }
};

// The part of a block that says where its bodies are.
HWY_INLINE PinBlock& place_of(PinBlock& block) {
    return block;
}
HWY_INLINE PinBlock& place_of(DriveBlock& block) {
    return block.pin;
}
HWY_INLINE WheelBlock& place_of(WheelBlock& block) {
    return block;
}

// Sets rows and offsets of a block, too. Unused lanes stay those of the world's row.
template <class Block>
HWY_INLINE PlaceLanes places_of(const AnchorBlock& anchor, Block& block, const Place* all) {
    PlaceLanes places;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        if (anchor.joint[lane] < 0) {
            places.cos_a[lane] = places.cos_b[lane] = 1;
            places.sin_a[lane] = places.sin_b[lane] = 0;
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
    return places;
}

// The scales of the arms of some lanes.
template <JointBlockKind kKind>
struct ArmScales {
    V a;
    V b;

    HWY_INLINE ArmScales(const JointRows& rows, int lane, const float* velocity, const float* pose)
        : a(of(rows.a, lane, velocity, pose)), b(of_pushed(rows.b, lane, velocity, pose)) {}

  private:
    HWY_INLINE static V of(const Lanes<std::int32_t>& rows, int lane, const float* velocity,
                           const float* pose) {
        if constexpr (kKind == JointBlockKind::TwoBodies) return of_pushed(rows, lane, velocity, pose);
        return load_rows(pose, rows.data() + lane).u;
    }
    HWY_INLINE static V of_pushed(const Lanes<std::int32_t>& rows, int lane, const float* velocity,
                                  const float* pose) {
        const V k = load_rows(pose, rows.data() + lane).u;
        return pushed(load_rows(velocity, rows.data() + lane).u, k);
    }
};

HWY_INLINE void scale_impulse(Lanes<float>& impulse, int lane, float ratio) {
    store(hn::Mul(set(ratio), load(impulse, lane)), impulse, lane);
}

struct PlaceTask {
    AnchorBlock* anchors;
    std::span<const int> blocks;
    const Place* places;
    const float* velocity;
    const float* pose;
    float impulse_ratio;
};

// Calls place<kind>(task, anchors, block, stance, lane) for all lanes, and tells whether it found some torn.
template <JointBlockKind kKind, class Block, class PlaceLane>
bool place_all(const PlaceTask& task, Block* pool, const PlaceLane& place) {
    M torn = hn::FirstN(D(), 0);
    for (const int i : task.blocks) {
        AnchorBlock& anchor = task.anchors[i];
        const PlaceLanes places = places_of(anchor, place_of(pool[i]), task.places);
        for (int lane = 0; lane < kLanes; lane += kStep)
            torn = hn::Or(
                torn, place.template operator()<kKind>(task, anchor, pool[i], Stance(places, lane), lane));
    }
    return !hn::AllFalse(D(), torn);
}

template <class Block, class PlaceLane>
bool place_kind(const PlaceTask& task, Block* pool, JointBlockKind kind, const PlaceLane& place) {
    switch (kind) {
        case JointBlockKind::TwoBodies:
            return place_all<JointBlockKind::TwoBodies>(task, pool, place);
        case JointBlockKind::Anchored:
            return place_all<JointBlockKind::Anchored>(task, pool, place);
    }
    return false;
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#endif
