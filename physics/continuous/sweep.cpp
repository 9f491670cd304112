// Conservative advancement.
#include "continuous/sweep.h"

#include <limits>

namespace cairn::physics {

SweptPose pose_at(const Sweep& sweep, float time_s) {
    const Rotation q = Rotation::from_small_angle(sweep.spin * time_s) * sweep.rotation;
    return {sweep.center + time_s * sweep.velocity - rotate(q, sweep.local_center), q};
}

RelativePose relative_pose_at(const Sweep& a, const Sweep& b, float time_s) {
    return relative_pose(pose_at(a, time_s), pose_at(b, time_s));
}

std::optional<float> time_of_impact(const Sweep& a, const Sweep& b, float duration_s, float gap_m,
                                    const AxisGap& seen) {
    // What rotation can add to the closing speed, at most: it does not move the rims of discs.
    const auto spin_speed_of = [](const Sweep& sweep) {
        if (sweep.spin == 0) return 0.0f;
        const float arm = farthest_distance(*sweep.shape, sweep.local_center) - sweep.shape->radius();
        return std::fabs(sweep.spin) * arm;
    };
    const float spin_speed = spin_speed_of(a) + spin_speed_of(b);
    // Half of gap_m past the target, so that rounding cannot make the rounds creep towards it for ever.
    // Infinite where the gap never closes.
    const auto time_to_close = [&](const AxisGap& at) {
        const float closing = dot(a.velocity - b.velocity, at.axis) + spin_speed;
        return closing > 0 ? (at.gap_m - 0.5f * gap_m) / closing : std::numeric_limits<float>::infinity();
    };
    // Straight motion is exact after one or two rounds; a spin that grazes takes many.
    constexpr int kMaxRounds = 256;
    float time = seen.gap_m > gap_m ? time_to_close(seen) : 0;
    Vec2 guess = inverse_rotate(a.rotation, b.center - a.center);
    for (int round = 0; round < kMaxRounds; ++round) {
        if (time >= duration_s) return {};
        const SweptPose pose_a = pose_at(a, time);
        const Distance at =
            distance_between(*a.shape, *b.shape, relative_pose(pose_a, pose_at(b, time)), guess);
        if (at.distance <= gap_m) return time > 0 ? std::optional(time) : std::nullopt;
        guess = at.normal;
        time += time_to_close({rotate(pose_a.rotation, at.normal), at.distance});
    }
    return time;
}

}  // namespace cairn::physics
