// Features of two edges that face each other.
#pragma once

#include <algorithm>

#include <cairn/physics/math.h>

namespace cairn::physics {

struct Segment {
    Vec2 a;
    Vec2 b;
};

/// The nearest points of two segments, as fractions along each.
struct SegmentDistance {
    float fraction1 = 0;
    float fraction2 = 0;
    Vec2 point1;
    Vec2 point2;
};

/// Source: Ericson, "Real-Time Collision Detection", 2005, section 5.1.9. Neither segment may have length 0.
inline SegmentDistance nearest_points(const Segment& s1, const Segment& s2) {
    const Vec2 d1 = s1.b - s1.a;
    const Vec2 d2 = s2.b - s2.a;
    const Vec2 r = s1.a - s2.a;
    const float d11 = dot(d1, d1);
    const float d22 = dot(d2, d2);
    const float d12 = dot(d1, d2);
    const float r1 = dot(r, d1);
    const float r2 = dot(r, d2);
    const float denominator = d11 * d22 - d12 * d12;
    // Parallel segments: any point will do for the first guess.
    float f1 =
        denominator > 1e-6f * d11 * d22 ? std::clamp((d12 * r2 - r1 * d22) / denominator, 0.0f, 1.0f) : 0;
    float f2 = (d12 * f1 + r2) / d22;
    if (f2 < 0) {
        f2 = 0;
        f1 = std::clamp(-r1 / d11, 0.0f, 1.0f);
    } else if (f2 > 1) {
        f2 = 1;
        f1 = std::clamp((d12 - r1) / d11, 0.0f, 1.0f);
    }
    return {f1, f2, s1.a + f1 * d1, s2.a + f2 * d2};
}

}  // namespace cairn::physics
