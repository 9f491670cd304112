// Shape casts against marching: going on by the distance that is left, in double, by a second implementation.
#include "collide/shape_cast.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "physics/support/random_shapes.h"
#include "physics/support/rounded_hull.h"

namespace cairn::physics {
namespace {

using namespace test;

RelativePose moved(const RelativePose& pose, Vec2 by) {
    return {pose.p + by, pose.q};
}

RoundedHull moved(RoundedHull hull, Point by) {
    for (Point& p : hull.core) p = p + by;
    return hull;
}

struct March {
    bool hit = false;
    double fraction = 0;
    double nearest = 0;
    Point normal;
};

// Straight motion cannot close a gap faster than by its own length, so nothing is jumped over.
March march(const RoundedHull& fixed, const RoundedHull& moving, Point translation) {
    March result{false, 0, INFINITY, {}};
    const double whole = norm(translation);
    double travelled = 0;
    for (int i = 0; i < 100'000 && travelled <= whole; ++i) {
        const Separation at = separation(fixed, moved(moving, (travelled / whole) * translation));
        result.nearest = std::min(result.nearest, at.distance);
        if (at.distance < 1e-8) return {true, travelled / whole, at.distance, at.normal};
        travelled += at.distance;
    }
    return result;
}

Convex rod() {
    return make_convex(Capsule{{-1, 0}, {1, 0}, 0.5f}).value();
}
Convex disc(float radius) {
    return make_convex(Circle{{}, radius}).value();
}

}  // namespace

TEST_CASE("a moving shape meets another where marching does") {
    Random random(1);
    int hits = 0;
    int misses = 0;
    int overlaps = 0;
    for (const Form form_a : kForms) {
        for (const Form form_b : kForms) {
            for (int round = 0; round < 300; ++round) {
                const Convex fixed = random_convex(random, form_a);
                const Convex moving = random_convex(random, form_b);
                const RelativePose pose{random.vector(-5, 5), Rotation::from_angle(random.real(-4, 4))};
                const Vec2 translation = random.vector(-8, 8);
                const RoundedHull hull_f = rounded_hull(fixed);
                const RoundedHull hull_m = rounded_hull(moving, pose);
                INFO("forms " << static_cast<int>(form_a) << " and " << static_cast<int>(form_b) << ", round "
                              << round);
                const double at_start = separation(hull_f, hull_m).distance;
                if (std::fabs(at_start) < 2e-5) continue;
                const auto hit = cast_shape(fixed, moving, pose, translation);
                if (at_start < 0) {
                    ++overlaps;
                    REQUIRE(hit);
                    REQUIRE(hit->fraction == 0);
                    REQUIRE(static_cast<double>(hit->overlap) == Approx(-at_start).margin(3e-6).epsilon(0));
                    continue;
                }
                const March expected = march(hull_f, hull_m, to_point(translation));
                if (!expected.hit) {
                    if (expected.nearest > 1e-5) REQUIRE_FALSE(hit);
                    misses += hit ? 0 : 1;
                    continue;
                }
                const double whole = norm(to_point(translation));
                const double incidence = -dot(expected.normal, to_point(translation)) / whole;
                if (incidence < 0.05 || expected.fraction > 1 - 1e-5) continue;  // rounding decides
                ++hits;
                REQUIRE(hit);
                REQUIRE(hit->overlap == 0);
                const double off = std::fabs(static_cast<double>(hit->fraction) - expected.fraction) * whole;
                REQUIRE(off < 6e-6 / incidence);
                REQUIRE(length(hit->normal) == Approx(1).epsilon(1e-5));
                REQUIRE(dot(hit->normal, translation) < 0);
                const RelativePose there = moved(pose, hit->fraction * translation);
                const Point point = to_point(hit->point);
                REQUIRE(signed_distance(hull_f, point) == Approx(0).margin(2e-3));
                REQUIRE(signed_distance(rounded_hull(moving, there), point) == Approx(0).margin(2e-3));
            }
        }
    }
    CHECK(hits > 1000);
    CHECK(misses > 1000);
    CHECK(overlaps > 100);
}

TEST_CASE("a disc meets a disc where the quadratic formula says") {
    // Centres 1.5 m apart at the hit, 0.9 m beside the line: x = 6 - sqrt(1.5^2 - 0.9^2) = 4.8.
    const auto hit = cast_shape(disc(1), disc(0.5f), {{-6, 0.9f}, {}}, {12, 0});
    REQUIRE(hit);
    CHECK(static_cast<double>(hit->fraction) == Approx(4.8 / 12));
    CHECK(static_cast<double>(hit->normal.x) == Approx(-1.2 / 1.5));
    CHECK(static_cast<double>(hit->normal.y) == Approx(0.9 / 1.5));
    CHECK(static_cast<double>(hit->point.x) == Approx(-0.8));
    CHECK(static_cast<double>(hit->point.y) == Approx(0.6));
}

TEST_CASE("a disc meets the side and the round end of a capsule exactly") {
    const auto side = cast_shape(rod(), disc(0.25f), {{0.3f, 3}, {}}, {0, -4});
    REQUIRE(side);
    CHECK(static_cast<double>(side->fraction) == Approx((3 - 0.75) / 4));
    CHECK(side->normal == Vec2{0, 1});
    CHECK(side->point == Vec2{0.3f, 0.5f});
    const auto end = cast_shape(rod(), disc(0.25f), {{5, 0}, {}}, {-4, 0});
    REQUIRE(end);
    CHECK(static_cast<double>(end->fraction) == Approx((5 - 1.75) / 4));
    CHECK(end->point == Vec2{1.5f, 0});
}

TEST_CASE("a box that falls flat on a wider one meets it in the middle of its own side") {
    const Convex floor = make_convex(Box{10, 1}).value();
    const Convex box = make_convex(Box{0.5f, 0.5f}).value();
    const auto hit = cast_shape(floor, box, {{3, 3.5f}, {}}, {0, -4});
    REQUIRE(hit);
    CHECK(hit->fraction == 0.5f);
    CHECK(hit->normal == Vec2{0, 1});
    CHECK(hit->point == Vec2{3, 1});
}

TEST_CASE("shapes that touch at the start meet when they move together, and not when they part") {
    const Convex box = make_convex(Box{1, 1}).value();
    const RelativePose above{{0, 2}, {}};
    const auto together = cast_shape(box, box, above, {0, -1});
    REQUIRE(together);
    CHECK(together->fraction == 0);
    CHECK(together->overlap == 0);
    CHECK(together->normal == Vec2{0, 1});
    CHECK_FALSE(cast_shape(box, box, above, {0, 1}));
    CHECK_FALSE(cast_shape(box, box, above, {1, 0}));
}

TEST_CASE("a cast without length meets what it overlaps, and nothing else") {
    const auto hit = cast_shape(rod(), disc(1), {{0, 1}, {}}, {});
    REQUIRE(hit);
    CHECK(hit->fraction == 0);
    CHECK(hit->overlap == 0.5f);
    CHECK(hit->normal == Vec2{0, 1});
    CHECK_FALSE(cast_shape(rod(), disc(1), {{0, 3}, {}}, {}));
}

TEST_CASE("a cast of a kilometre meets a grain of a centimetre to float's precision") {
    const auto hit = cast_shape(disc(0.01f), disc(0.01f), {{-1000, 0}, {}}, {2000, 0});
    REQUIRE(hit);
    CHECK(static_cast<double>(hit->fraction) * 2000 == Approx(999.98).margin(2e-4).epsilon(0));
}

}  // namespace cairn::physics
