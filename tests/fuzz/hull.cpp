// Fuzz target: the convex hull of any points is convex, has corners that were given, and holds all of them.
#include "collide/hull.h"

#include <algorithm>
#include <vector>

#include <cairn/physics/tuning.h>

#include "fuzz/input.h"
#include "physics/support/rounded_hull.h"

using namespace cairn::physics;
using fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input in(data, size);
    std::vector<Vec2> points(static_cast<std::size_t>(in.below(24)));
    const bool is_coarse = in.flag();  // few different coordinates: equal points, points in line
    for (Vec2& p : points) {
        p = is_coarse ? Vec2{static_cast<float>(in.below(5)), static_cast<float>(in.below(5))}
                      : in.hostile_vector(-2, 2);
    }
    const Result<Hull> hull = make_hull(points);
    const bool all_finite = std::all_of(points.begin(), points.end(), [](Vec2 p) { return is_finite(p); });
    if (!hull) {
        require(!hull.error().message.empty(), "an error has a message");
        return 0;
    }
    require(all_finite, "points that are not finite are refused");
    require(hull->count >= 3 && hull->count <= kMaxPolygonVertices, "a hull has 3 to 8 corners");

    test::RoundedHull exact;
    for (int i = 0; i < hull->count; ++i) exact.core.push_back(test::to_point(hull->points[i]));
    double extent = 0;
    for (const Vec2 p : points) extent = std::max(extent, test::norm(test::to_point(p) - exact.core[0]));
    for (int i = 0; i < hull->count; ++i) {
        require(std::find(points.begin(), points.end(), hull->points[i]) != points.end(),
                "corners are points that were given");
        require(test::cross(exact.at(i + 1) - exact.at(i), exact.at(i + 2) - exact.at(i + 1)) > 0,
                "a hull turns left at each corner");
    }
    // What may be left out: points near another one, and corners that hardly stand out; twice, because a
    // point may be near one that was left out.
    const double left_out =
        2 * (std::max(static_cast<double>(tuning::kLinearSlop_m), 1e-3 * extent) + 1e-4 * extent);
    for (const Vec2 p : points) {
        require(test::signed_distance(exact, test::to_point(p)) <= left_out, "a hull holds its points");
    }
    return 0;
}
