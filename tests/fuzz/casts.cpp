// Fuzz target: rays and moving shapes stop at the surface, having met nothing on the way there, and miss only
// what is not in their way.
#include <cmath>

#include "collide/ray_cast.h"
#include "collide/shape_cast.h"
#include "fuzz/input.h"
#include "physics/support/rounded_hull.h"

using namespace cairn::physics;
using fuzz::require;

namespace {

constexpr double kTolerance_m = 1e-3;
constexpr int kSamples = 64;

Vec2 along(Vec2 origin, Vec2 translation, double fraction) {
    return origin + static_cast<float>(fraction) * translation;
}

void check_ray(const Convex& shape, Vec2 origin, Vec2 translation) {
    const test::RoundedHull exact = test::rounded_hull(shape);
    const auto depth_at = [&](double fraction) {
        return -test::signed_distance(exact, test::to_point(along(origin, translation, fraction)));
    };
    const bool starts_outside = depth_at(0) < -kTolerance_m;
    const auto hit = cast_ray(shape, origin, translation);
    if (hit) {
        require(hit->fraction >= 0 && hit->fraction <= 1, "a ray is hit between its ends");
        require(std::abs(depth_at(static_cast<double>(hit->fraction))) < kTolerance_m,
                "a ray is hit on the surface");
        require(std::abs(length(hit->normal) - 1) < 1e-3f, "the normal has length 1");
        require(dot(hit->normal, translation) < 1e-3f, "a ray enters against the normal");
    }
    if (!starts_outside) return;
    const double end = hit ? static_cast<double>(hit->fraction) : 1;
    for (int i = 0; i <= kSamples; ++i) {
        require(depth_at(end * i / kSamples) < kTolerance_m, "a ray meets nothing before its hit");
    }
}

void check_shape(const Convex& fixed, const Convex& moving, const RelativePose& start, Vec2 translation) {
    const test::RoundedHull exact = test::rounded_hull(fixed);
    const auto gap_at = [&](double fraction) {
        const RelativePose pose{along(start.p, translation, fraction), start.q};
        return test::separation(exact, test::rounded_hull(moving, pose)).distance;
    };
    const auto hit = cast_shape(fixed, moving, start, translation);
    if (hit) {
        require(hit->fraction >= 0 && hit->fraction <= 1, "a shape is met between its ends");
        require(hit->overlap >= 0, "an overlap is not negative");
        require(std::abs(length(hit->normal) - 1) < 1e-3f, "the normal has length 1");
        if (hit->overlap == 0) {
            require(std::abs(gap_at(static_cast<double>(hit->fraction))) < kTolerance_m,
                    "shapes touch where they meet");
        }
    }
    if (gap_at(0) < kTolerance_m) return;
    const double end = hit ? static_cast<double>(hit->fraction) : 1;
    for (int i = 0; i <= kSamples; ++i) {
        require(gap_at(end * i / kSamples) > -kTolerance_m, "shapes do not overlap before they meet");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input in(data, size);
    const Result<Convex> fixed = fuzz::small_shape(in);
    const Result<Convex> moving = fuzz::small_shape(in);
    if (!fixed || !moving) return 0;
    const RelativePose start = fuzz::small_pose(in);
    const Vec2 translation = in.vector(-8, 8);
    check_ray(*fixed, start.p, translation);
    check_shape(*fixed, *moving, start, translation);
    return 0;
}
