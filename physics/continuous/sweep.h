// When two moving shapes first meet.
// Method: conservative advancement. Along the line of least distance the gap can close no faster than the
// bodies' relative speed along it plus what rotation may add; so time may advance by gap over that speed
// without missing anything. Source: Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", 1996.
#pragma once

#include <optional>

#include "collide/distance.h"

namespace cairn::physics {

/// A shape on its way: the body's pose at the start relative to a common origin, and its steady motion.
struct Sweep {
    const Convex* shape = nullptr;
    Vec2 center;  // of mass, m
    Rotation rotation;
    Vec2 local_center;  // of mass, in the body's frame
    Vec2 velocity;      // m/s
    float spin = 0;     // rad/s
};

/// The pose of the body's frame after time_s.
struct SweptPose {
    Vec2 origin;
    Rotation rotation;
};

SweptPose pose_at(const Sweep& sweep, float time_s);

/// The pose of b in the frame of a.
inline RelativePose relative_pose(const SweptPose& a, const SweptPose& b) {
    return {inverse_rotate(a.rotation, b.origin - a.origin), inverse(a.rotation) * b.rotation};
}

/// The same after time_s.
RelativePose relative_pose_at(const Sweep& a, const Sweep& b, float time_s);

/// An axis along which two shapes are at least this far apart; 0 says nothing.
struct AxisGap {
    Vec2 axis;  // unit, from a to b
    float gap_m = 0;
};

/// The time until the gap is closed to gap_m, up to duration_s; nothing when they start nearer than that, or
/// never meet. What was seen of their start saves a round.
std::optional<float> time_of_impact(const Sweep& a, const Sweep& b, float duration_s, float gap_m,
                                    const AxisGap& seen = {});

}  // namespace cairn::physics
