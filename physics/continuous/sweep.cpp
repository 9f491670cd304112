// Conservative advancement.
#include "continuous/sweep.h"

namespace cairn::physics {

SweptPose pose_at(const Sweep& sweep, float time_s) {
    const Rotation q = Rotation::from_angle(static_cast<double>(sweep.spin * time_s)) * sweep.rotation;
    return {sweep.center + time_s * sweep.velocity - rotate(q, sweep.local_center), q};
}

RelativePose relative_pose_at(const Sweep& a, const Sweep& b, float time_s) {
    const SweptPose pose_a = pose_at(a, time_s);
    const SweptPose pose_b = pose_at(b, time_s);
    return {inverse_rotate(pose_a.rotation, pose_b.origin - pose_a.origin),
            inverse(pose_a.rotation) * pose_b.rotation};
}

std::optional<float> time_of_impact(const Sweep& a, const Sweep& b, float duration_s, float gap_m) {
    // What rotation can add to the closing speed, at most.
    const float spin_speed = std::fabs(a.spin) * farthest_distance(*a.shape, a.local_center) +
                             std::fabs(b.spin) * farthest_distance(*b.shape, b.local_center);
    // Straight motion is exact after one or two rounds; a spin that grazes takes many.
    constexpr int kMaxRounds = 256;
    float time = 0;
    for (int round = 0; round < kMaxRounds; ++round) {
        const RelativePose pose = relative_pose_at(a, b, time);
        const Distance at = distance_between(*a.shape, *b.shape, pose);
        if (at.distance <= gap_m) return time > 0 ? std::optional(time) : std::nullopt;
        const Vec2 normal = rotate(pose_at(a, time).rotation, at.normal);
        const float closing = dot(a.velocity - b.velocity, normal) + spin_speed;
        if (closing <= 0) return {};
        // Half of gap_m past the target, so that rounding cannot make the rounds creep towards it for ever.
        time += (at.distance - 0.5f * gap_m) / closing;
        if (time >= duration_s) return {};
    }
    return time;
}

}  // namespace cairn::physics
