#include "collide/hull.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using Catch::Matchers::Contains;
using test::Random;

double turn(Vec2 o, Vec2 a, Vec2 b) {
    const auto d = [](float to, float from) { return static_cast<double>(to) - static_cast<double>(from); };
    return d(a.x, o.x) * d(b.y, o.y) - d(a.y, o.y) * d(b.x, o.x);
}

std::vector<Vec2> sorted(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(),
              [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    return points;
}

std::vector<Vec2> corners_of(const Hull& hull) {
    return {hull.points.begin(), hull.points.begin() + hull.count};
}

// The second implementation: a pair of points is an edge of the hull when all others lie to its left.
// `clear` tells whether no point is so near a line through two others that tolerances would decide.
std::vector<Vec2> corners_by_force(const std::vector<Vec2>& points, bool& clear) {
    std::vector<Vec2> corners;
    clear = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < points.size(); ++j) {
            if (i == j) continue;
            bool is_edge = true;
            for (std::size_t k = 0; k < points.size(); ++k) {
                if (k == i || k == j) continue;
                const double t = turn(points[i], points[j], points[k]);
                if (std::fabs(t) < 0.05) clear = false;
                if (t < 0) is_edge = false;
            }
            if (is_edge) corners.push_back(points[i]);
        }
    }
    return corners;
}

std::string error_of(const std::vector<Vec2>& points) {
    const Result<Hull> hull = make_hull(points);
    return hull ? "no error" : hull.error().message;
}

}  // namespace

TEST_CASE("the hull of random points has the corners that brute force finds") {
    Random random(1);
    int compared = 0;
    for (int round = 0; round < 20'000; ++round) {
        std::vector<Vec2> points(3 + random.below(7));
        for (Vec2& p : points) p = random.vector(-2, 2);
        bool clear = false;
        const std::vector<Vec2> expected = corners_by_force(points, clear);
        if (!clear || expected.size() > kMaxPolygonVertices) continue;
        const Result<Hull> hull = make_hull(points);
        REQUIRE(hull);
        REQUIRE(sorted(corners_of(*hull)) == sorted(expected));
        ++compared;
    }
    CHECK(compared > 1000);
}

TEST_CASE("a hull is convex, anticlockwise, made of given points, and holds all of them") {
    Random random(2);
    for (int round = 0; round < 20'000; ++round) {
        const float size = std::pow(10.0f, random.real_f(-2, 4));
        // Half of the rounds have points on a coarse grid: many on one line, many equal.
        const bool grid = random.chance(0.5);
        std::vector<Vec2> points(3 + random.below(10));
        for (Vec2& p : points) {
            p = grid ? Vec2{static_cast<float>(random.below(4)), static_cast<float>(random.below(4))}
                     : random.vector(-1, 1);
            p *= size;
        }
        const Result<Hull> result = make_hull(points);
        if (!result) continue;
        const std::vector<Vec2> hull = corners_of(*result);
        const std::size_t n = hull.size();
        REQUIRE(n >= 3);
        for (std::size_t i = 0; i < n; ++i) {
            const Vec2 a = hull[i];
            const Vec2 b = hull[(i + 1) % n];
            REQUIRE(std::find(points.begin(), points.end(), a) != points.end());
            REQUIRE(turn(a, b, hull[(i + 2) % n]) > 0);
            for (const Vec2 p : points) {
                const double outside = -turn(a, b, p) / static_cast<double>(length(b - a));
                // What is left out: near duplicates (within 0.001 of the size) and flat corners (within 1e-4
                // of a base which is at most 2 sqrt(2) sizes; several in a row add up).
                REQUIRE(outside <= 0.004 * static_cast<double>(size));
            }
        }
    }
}

TEST_CASE("points on the edges of a square are no corners") {
    const std::vector<Vec2> points{{0, 0}, {0.5f, 0}, {1, 0}, {1, 0.5f},
                                   {1, 1}, {0.3f, 1}, {0, 1}, {0.5f, 0.5f}};
    const Hull hull = make_hull(points).value();
    CHECK(sorted(corners_of(hull)) == std::vector<Vec2>{{0, 0}, {0, 1}, {1, 0}, {1, 1}});
}

TEST_CASE("the hull does not depend on the order of the points") {
    const std::vector<Vec2> octagon{{2, 0},  {1.4f, 1.4f},   {0, 2},  {-1.4f, 1.4f},
                                    {-2, 0}, {-1.4f, -1.4f}, {0, -2}, {1.4f, -1.4f}};
    const std::vector<Vec2> expected = corners_of(make_hull(octagon).value());
    CHECK(expected.size() == 8);
    Random random(3);
    std::vector<Vec2> shuffled = octagon;
    for (int round = 0; round < 100; ++round) {
        for (int i = 7; i > 0; --i) std::swap(shuffled[i], shuffled[random.below(i + 1)]);
        REQUIRE(corners_of(make_hull(shuffled).value()) == expected);
    }
}

TEST_CASE("points that enclose no area give an error that says why") {
    CHECK_THAT(error_of({}), Contains("0 distinct points") && Contains("at least 3"));
    CHECK_THAT(error_of({{0, 0}, {1, 0}}), Contains("2 distinct points"));
    CHECK_THAT(error_of({{0, 0}, {1, 0}, {1, 0}, {0.0001f, 0}}), Contains("2 distinct points"));
    CHECK_THAT(error_of({{0, 0}, {1, 1}, {2, 2}}), Contains("one line"));
    CHECK_THAT(error_of({{0, 0}, {1, 1.00001f}, {2, 2}, {3, 3}}), Contains("one line"));
    CHECK_THAT(error_of({{0, 0}, {4, 0}, {8, 0}, {5, 0.000244140625f}}),
               Contains("8 m long") && Contains("0.000244") && Contains("at least 8e-04 m wide"));
}

TEST_CASE("too many corners and points that are not numbers give an error that names them") {
    std::vector<Vec2> nonagon;
    for (int i = 0; i < 9; ++i) {
        const float angle = static_cast<float>(i) * 2 * kPi / 9;
        nonagon.push_back({std::cos(angle), std::sin(angle)});
    }
    CHECK_THAT(error_of(nonagon), Contains("9 corners") && Contains("at most 8"));
    CHECK_THAT(error_of({{0, 0}, {NAN, 0}, {1, 1}}), Contains("polygon.points_m[1]") && Contains("nan"));
    CHECK_THAT(error_of({{0, 0}, {1, 0}, {1, INFINITY}}), Contains("polygon.points_m[2]") && Contains("inf"));
}

TEST_CASE(
    "the tip of a needle is a corner of the hull, though it hardly stands out from the line of its sides") {
    // The tip is 12 mm above the next point and 0.06 mm beside the line through it.
    const std::array points{Vec2{-1.12151f, -1.37157f}, Vec2{-1.12157f, -1.12151f},
                            Vec2{-1.12157f, -1.10942f}, Vec2{-1.93732f, -2}, Vec2{-2, -2}};
    const Hull hull = make_hull(points).value();
    CHECK(std::count(hull.points.begin(), hull.points.begin() + hull.count, points[2]) == 1);
}

TEST_CASE("a point too far away for the square of its distance is not left out") {
    // Seen from that far, the other three are one.
    const std::array points{Vec2{-2, 2}, Vec2{2, 2}, Vec2{2, -2}, Vec2{-1, -1.5e32f}};
    const Result<Hull> hull = make_hull(points);
    REQUIRE_FALSE(hull);
    CHECK_THAT(hull.error().message, Contains("lie on one line"));
}

}  // namespace cairn::physics
