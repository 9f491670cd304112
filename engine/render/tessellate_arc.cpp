// Circles, arcs and capsules as polygons. Invariant: a chord is never further than a tenth of a pixel from
// its arc, up to the largest number of segments.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/tessellate.h"

namespace cairn::engine {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// A tenth of a pixel cannot be seen under an edge that is a pixel wide; half a pixel can, as a faint
/// polygon.
constexpr float kTolerance = 0.1f;

/// Enough for radii up to 21,000 pixels; only more would show corners again.
constexpr int kMaxSegments = 1024;

/// From this radius in pixels on, a circle has the largest number of segments. Floats do not tell the cosine
/// of a much larger one from 1.
constexpr float kMostNeeding = 1e6f;

Vec2 on_circle(Vec2 center, float radius, float angle_rad) {
    return center + Vec2{std::cos(angle_rad), std::sin(angle_rad)} * radius;
}

}  // namespace

int circle_segments(float radius_pixels) {
    // Of a radius that is no number, too: the points of such a circle are none either and draw nothing.
    if (!(radius_pixels < kMostNeeding)) return kMaxSegments;
    // The sagitta of a chord over the angle 2 pi / n is r (1 - cos(pi / n)).
    const float cosine = 1 - kTolerance / std::max(radius_pixels, kTolerance);
    const float needed = std::ceil(kPi / std::acos(cosine));
    const int segments = static_cast<int>(std::clamp(needed, 8.0f, static_cast<float>(kMaxSegments)));
    return (segments + 3) / 4 * 4;
}

std::vector<Vec2> circle_points(Vec2 center, float radius, const Affine2& output_from_local) {
    const int n = circle_segments(radius * output_from_local.mean_scale());
    // A regular polygon has the area n/2 r^2 sin(2 pi / n); this radius makes it pi r^2.
    const float sector = 2 * kPi / static_cast<float>(n);
    const float polygon_radius = radius * std::sqrt(sector / std::sin(sector));
    std::vector<Vec2> points;
    points.reserve(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i)
        points.push_back(
            output_from_local.apply(on_circle(center, polygon_radius, sector * static_cast<float>(i))));
    return points;
}

std::vector<Vec2> arc_points(Vec2 center, float radius, float from_rad, float to_rad,
                             const Affine2& output_from_local) {
    const int whole_turn = circle_segments(radius * output_from_local.mean_scale());
    const float turns = std::min(std::fabs(to_rad - from_rad) / (2 * kPi), 1.0f);
    const int n = std::max(1, static_cast<int>(std::ceil(turns * static_cast<float>(whole_turn))));
    std::vector<Vec2> points;
    points.reserve(static_cast<std::size_t>(n) + 1);
    for (int i = 0; i <= n; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(n);
        points.push_back(
            output_from_local.apply(on_circle(center, radius, from_rad + (to_rad - from_rad) * share)));
    }
    return points;
}

std::vector<Vec2> capsule_points(Vec2 a, Vec2 b, float radius, const Affine2& output_from_local) {
    const Vec2 axis = b - a;
    if (length(axis) == 0) return circle_points(a, radius, output_from_local);
    const float axis_angle_rad = std::atan2(axis.y, axis.x);
    const int half = circle_segments(radius * output_from_local.mean_scale()) / 2;
    std::vector<Vec2> points;
    points.reserve(2 * static_cast<std::size_t>(half + 1));
    for (const auto& [center, start_rad] :
         {std::pair{b, axis_angle_rad - kPi / 2}, std::pair{a, axis_angle_rad + kPi / 2}})
        for (int i = 0; i <= half; ++i) {
            const float angle_rad = start_rad + kPi * static_cast<float>(i) / static_cast<float>(half);
            points.push_back(output_from_local.apply(on_circle(center, radius, angle_rad)));
        }
    return points;
}

}  // namespace cairn::engine
