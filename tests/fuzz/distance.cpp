// Fuzz target: the distance of two shapes is that of a brute-force search in double, whichever comes first.
#include "collide/distance.h"

#include <cmath>

#include "fuzz/input.h"
#include "physics/support/rounded_hull.h"

using namespace cairn::physics;
using fuzz::require;

namespace {

// Coordinates are below 10 m: some hundred units in the last place of a float.
constexpr double kTolerance_m = 1e-4;
// Cores nearer than this may count as overlapping.
constexpr double kTouching_m = 1e-3;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input in(data, size);
    const Result<Convex> a = fuzz::small_shape(in);
    const Result<Convex> b = fuzz::small_shape(in);
    if (!a || !b) return 0;
    const RelativePose b_in_a = fuzz::small_pose(in);

    const Distance d = distance_between(*a, *b, b_in_a);
    const Distance mirrored = distance_between(*b, *a, fuzz::inverse_of(b_in_a));
    const test::Separation exact = test::separation(test::rounded_hull(*a), test::rounded_hull(*b, b_in_a));
    const double radii = static_cast<double>(a->radius()) + static_cast<double>(b->radius());
    if (exact.distance + radii < kTouching_m) return 0;

    require(std::abs(static_cast<double>(d.distance) - exact.distance) < kTolerance_m,
            "the distance is that of brute force");
    require(std::abs(static_cast<double>(mirrored.distance) - exact.distance) < kTolerance_m,
            "the distance is the same from the other side");
    require(std::abs(length(d.normal) - 1) < 1e-4f, "the normal has length 1");
    const double between = test::norm(test::to_point(d.point_b) - test::to_point(d.point_a));
    require(std::abs(between - radii - exact.distance) < kTolerance_m,
            "the nearest points are as far apart as the cores");
    require(test::signed_distance(test::rounded_hull(*a), test::to_point(d.point_a)) +
                    static_cast<double>(a->radius()) <
                kTolerance_m,
            "the nearest point of a lies in its core");
    return 0;
}
