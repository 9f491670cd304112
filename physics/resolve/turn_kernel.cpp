// With r from the centre of mass to the point, less what is round of the shape and does not turn, and R the
// turn by the angle theta since the start of the step:
//     n . (R r - r) = (r x n) sin(theta) - (n . r) (1 - cos(theta))
// The linear form has (r x n) theta in place of that, which is the arm times the scaled angle.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "resolve/turn_kernel.cpp"
#include "resolve/turn_kernel.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/simd_rows-inl.h"
#include "resolve/contact_pair-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

// The sums below are right to 2e-6 up to a quarter turn; what turns further counts as having turned so far.
constexpr float kFarthestSquare = 0.25f * kPi * kPi;

struct Turn {
    V sine;    // sin(theta) / theta - 1
    V cosine;  // 1 - cos(theta)
};

HWY_INLINE V sum_up(V z, float first, V rest) {
    return hn::Add(set(first), hn::Mul(z, rest));
}

HWY_INLINE Turn turn_of(const Columns& pose) {
    const V angle = hn::Mul(pose.u, pose.z);
    const V z = hn::Min(hn::Mul(angle, angle), set(kFarthestSquare));
    V sine = sum_up(z, -1.0f / 5040, set(1.0f / 362880));
    sine = sum_up(z, -1.0f / 6, sum_up(z, 1.0f / 120, sine));
    V cosine = sum_up(z, 1.0f / 720, sum_up(z, -1.0f / 40320, set(1.0f / 3628800)));
    cosine = sum_up(z, 0.5f, sum_up(z, -1.0f / 24, cosine));
    return {hn::Mul(z, sine), hn::Mul(z, cosine)};
}

HWY_INLINE V bend_of(V arm, V bow, const Columns& pose, const Turn& turn) {
    return hn::Sub(hn::Mul(hn::Mul(arm, pose.z), turn.sine), hn::Mul(bow, turn.cosine));
}

template <BlockKind kKind>
HWY_INLINE void bend_lanes(ContactBlock& block, TurnLanes& turning, int lane, const float* pose) {
    const M turns = wanted_lanes(turning.used, lane);
    const Columns pose_b = load_rows(pose, block.b.data() + lane);
    const Turn turn_b = turn_of(pose_b);
    Columns pose_a{};
    Turn turn_a{};
    if constexpr (reads_a(kKind)) {
        pose_a = load_rows(pose, block.a.data() + lane);
        turn_a = turn_of(pose_a);
    }
    for (std::size_t i = 0; i < turning.bend.size(); ++i) {
        ContactBlockPoint& point = block.points[i];
        V bend = bend_of(load(point.arm_b, lane), load(turning.bow_b, lane), pose_b, turn_b);
        if constexpr (reads_a(kKind)) {
            const V of_a = bend_of(load(point.arm_a, lane), load(turning.bow_a, lane), pose_a, turn_a);
            bend = hn::Sub(bend, of_a);
        }
        const V start = load(point.start_separation, lane);
        const V bent = hn::Add(start, hn::Sub(bend, load(turning.bend[i], lane)));
        store(hn::IfThenElse(turns, bent, start), point.start_separation, lane);
        store(hn::IfThenElseZero(turns, bend), turning.bend[i], lane);
    }
}

template <BlockKind kKind>
void bend_all(std::span<ContactBlock* const> blocks, const float* pose) {
    for (ContactBlock* const block : blocks) {
        if (block->turning == nullptr) continue;
        for (int lane = 0; lane < kLanes; lane += kStep)
            bend_lanes<kKind>(*block, *block->turning, lane, pose);
    }
}

void bend_separations(std::span<ContactBlock* const> blocks, BlockKind kind, const float* pose) {
    switch (kind) {
        case BlockKind::TwoBodies:
            return bend_all<BlockKind::TwoBodies>(blocks, pose);
        case BlockKind::OneBody:
            return bend_all<BlockKind::OneBody>(blocks, pose);
        case BlockKind::Carried:
            return bend_all<BlockKind::Carried>(blocks, pose);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(bend_separations);

void bend_separations(std::span<ContactBlock* const> blocks, BlockKind kind, const PoseRow* pose) {
    HWY_DYNAMIC_DISPATCH(bend_separations)(blocks, kind, &pose->d.x);
}

}  // namespace cairn::physics
#endif
