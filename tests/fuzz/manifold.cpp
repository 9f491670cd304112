// Fuzz target: two shapes have contact points when they are within reach, and none of them is nearer than the
// shapes are.
#include "collide/manifold.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/physics/tuning.h>

#include "fuzz/input.h"
#include "physics/support/rounded_hull.h"

using namespace cairn::physics;
using fuzz::require;

namespace {

constexpr float kReach_m = tuning::kSpeculativeDistance_m;
constexpr double kRounding_m = 1e-6;
constexpr double kExtent_m = 6;  // of the shapes made up here
// Of two faces with about the same overlap either may count.
constexpr double kTolerance_m = 0.2 * static_cast<double>(tuning::kLinearSlop_m);

// How far B is in front of A along a direction, which is at most the distance.
double separation_along(Vec2 normal, const test::RoundedHull& a, const test::RoundedHull& b) {
    double front_of_a = -std::numeric_limits<double>::infinity();
    double back_of_b = -front_of_a;
    for (const test::Point p : a.core)
        front_of_a = std::max(front_of_a, test::dot(p, test::to_point(normal)));
    for (const test::Point p : b.core) back_of_b = std::min(back_of_b, test::dot(p, test::to_point(normal)));
    return back_of_b - front_of_a - a.radius - b.radius;
}

void check(const Convex& a, const Convex& b, const RelativePose& b_in_a) {
    const Manifold m = collide(a, b, b_in_a, kReach_m);
    require(m.count >= 0 && m.count <= 2, "a manifold has at most two points");
    if (a.is_line() && b.is_line()) {
        require(m.count == 0, "lines do not meet");
        return;
    }
    const test::Separation exact = test::separation(test::rounded_hull(a), test::rounded_hull(b, b_in_a));
    if (exact.distance < static_cast<double>(kReach_m) - kTolerance_m) {
        require(m.count > 0, "shapes within reach have a contact point");
    }
    if (m.count == 0) return;
    require(exact.distance < static_cast<double>(kReach_m) + kTolerance_m,
            "shapes out of reach have no contact point");
    require(std::abs(length(m.normal) - 1) < 1e-3f, "the normal has length 1");
    float least = m.points[0].separation;
    for (int i = 0; i < m.count; ++i) {
        require(is_finite(m.points[i].point), "points are finite");
        require(m.points[i].separation <= kReach_m + 1e-5f, "points are within reach");
        least = std::min(least, m.points[i].separation);
    }
    require(m.count < 2 || m.points[0].id != m.points[1].id, "points have different ids");
    // Between nearest points the normal is known to the rounding of these, as seen from their distance.
    const double radii = static_cast<double>(a.radius()) + static_cast<double>(b.radius());
    const double cores_apart = std::max(exact.distance + radii, static_cast<double>(kAllButTouching_m));
    const double slant = exact.cores_overlap ? 0 : kRounding_m / cores_apart;
    require(separation_along(m.normal, test::rounded_hull(a), test::rounded_hull(b, b_in_a)) >
                exact.distance - kTolerance_m - slant * kExtent_m,
            "along the normal the shapes are as far apart as they are");
    require(std::abs(static_cast<double>(least) - exact.distance) < kTolerance_m,
            "the deepest point is as near as the shapes are");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input in(data, size);
    const Result<Convex> a = fuzz::small_shape(in);
    const Result<Convex> b = fuzz::small_shape(in);
    if (!a || !b) return 0;
    const RelativePose b_in_a = fuzz::small_pose(in);
    check(*a, *b, b_in_a);
    check(*b, *a, fuzz::inverse_of(b_in_a));
    return 0;
}
