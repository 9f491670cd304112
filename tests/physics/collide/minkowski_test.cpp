// Distance and depth from the Minkowski difference against all pairs of features.
#include "collide/minkowski.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "collide/distance.h"
#include "physics/support/random_shapes.h"
#include "physics/support/rounded_hull.h"

namespace cairn::physics {
namespace {

using namespace test;

Clearance clearance_of(const Convex& fixed, const Convex& moving, const RelativePose& pose) {
    return clearance(minkowski_difference(fixed, moving, pose));
}

}  // namespace

TEST_CASE("the distance of two shapes, or the depth of their overlap, is that of all pairs of features") {
    Random random(1);
    int apart = 0;
    int overlapping = 0;
    for (const Form form_a : kForms) {
        for (const Form form_b : kForms) {
            for (int round = 0; round < 300; ++round) {
                const Convex a = random_convex(random, form_a);
                const Convex b = random_convex(random, form_b);
                const RelativePose pose{random.vector(-2.5, 2.5), Rotation::from_angle(random.real(-4, 4))};
                const Separation expected = separation(rounded_hull(a), rounded_hull(b, pose));
                const Clearance found = clearance_of(a, b, pose);
                INFO("forms " << static_cast<int>(form_a) << " and " << static_cast<int>(form_b) << ", round "
                              << round);
                REQUIRE(static_cast<double>(found.distance) ==
                        Approx(expected.distance).margin(3e-6).epsilon(0));
                REQUIRE(length(found.normal) == Approx(1).epsilon(1e-5));
                (expected.distance > 0 ? apart : overlapping) += 1;
                const double cores = expected.distance + static_cast<double>(a.radius() + b.radius());
                if (std::fabs(cores) < 0.01 || expected.cores_overlap) continue;
                REQUIRE(dot(to_point(found.normal), expected.normal) > 1 - 1e-4);
            }
        }
    }
    CHECK(apart > 3000);
    CHECK(overlapping > 2000);
}

TEST_CASE("a shape that is pushed out along the normal by the depth just touches") {
    Random random(2);
    int pushed = 0;
    for (int round = 0; round < 5'000; ++round) {
        const Convex a = random_convex(random, kForms[random.below(6)]);
        const Convex b = random_convex(random, kForms[random.below(6)]);
        RelativePose pose{random.vector(-1, 1), Rotation::from_angle(random.real(-4, 4))};
        const Clearance found = clearance_of(a, b, pose);
        if (found.distance >= 0) continue;
        ++pushed;
        pose.p += -found.distance * found.normal;
        const Separation after = separation(rounded_hull(a), rounded_hull(b, pose));
        REQUIRE(after.distance == Approx(0).margin(1e-5));
    }
    CHECK(pushed > 2000);
}

TEST_CASE("parallel and degenerate outlines have a distance too") {
    const Convex rod = make_convex(Capsule{{-1, 0}, {1, 0}, 0.25f}).value();
    const Convex disc = make_convex(Circle{{}, 0.5f}).value();
    const Convex box = make_convex(Box{1, 1}).value();
    const RelativePose here{};
    CHECK(clearance_of(rod, rod, {{0, 2}, {}}).distance == 1.5f);
    CHECK(clearance_of(rod, rod, {{0, 2}, {-1, 0}}).distance == 1.5f);
    CHECK(clearance_of(rod, rod, {{5, 0}, {}}).distance == 2.5f);
    CHECK(clearance_of(rod, rod, {{1, 0}, {}}).distance == -0.5f);
    CHECK(clearance_of(rod, rod, {{1, 0}, {}}).normal.x == 0);
    CHECK(clearance_of(disc, disc, here).distance == -1);
    CHECK(clearance_of(disc, disc, here).normal == Vec2{0, 1});
    CHECK(clearance_of(box, box, {{3, 0}, {}}).distance == 1);
    CHECK(clearance_of(box, box, {{3, 0}, {0, 1}}).normal == Vec2{1, 0});
    CHECK(clearance_of(box, box, {{0.5f, 0}, {}}).distance == -1.5f);
}

TEST_CASE("shapes that are apart meet at the nearest point of the fixed one's surface") {
    Random random(3);
    for (int round = 0; round < 5'000; ++round) {
        const Convex a = random_convex(random, kForms[random.below(6)]);
        const Convex b = random_convex(random, kForms[random.below(6)]);
        const RelativePose pose{random.vector(-3, 3), Rotation::from_angle(random.real(-4, 4))};
        const Clearance found = clearance_of(a, b, pose);
        if (found.distance < 0.01f) continue;
        const Point on_a = to_point(meeting_point(a, b, pose, found));
        REQUIRE(signed_distance(rounded_hull(a), on_a) == Approx(0).margin(2e-3));
        REQUIRE(signed_distance(rounded_hull(b, pose), on_a) ==
                Approx(static_cast<double>(found.distance)).margin(2e-3));
    }
}

TEST_CASE("edges that lie along each other meet in the middle of where they do") {
    const Convex wide = make_convex(Box{2, 1}).value();
    const Convex narrow = make_convex(Box{0.5f, 0.5f}).value();
    const auto meet = [&](Vec2 p) {
        const RelativePose pose{p, {}};
        return meeting_point(wide, narrow, pose, clearance_of(wide, narrow, pose));
    };
    CHECK(meet({1, 2}) == Vec2{1, 1});
    CHECK(meet({2, 2}) == Vec2{1.75f, 1});
    CHECK(meet({-3, 0}) == Vec2{-2, 0});
}

TEST_CASE("two points that rounding has made one say nothing about inside and outside") {
    MinkowskiDifference square;
    square.count = 5;
    const Vec2 points[] = {{-1, -1}, {1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const Vec2 normals[] = {{0, -1}, {0, 0}, {1, 0}, {0, 1}, {-1, 0}};
    for (int i = 0; i < 5; ++i) {
        square.points[static_cast<std::size_t>(i)] = points[i];
        square.normals[static_cast<std::size_t>(i)] = normals[i];
    }
    const Clearance inside = clearance(square);
    CHECK(inside.distance == Approx(-1));
    CHECK(length(inside.normal) == Approx(1));

    // The origin on the doubled point itself.
    for (int i = 0; i < 5; ++i) square.points[static_cast<std::size_t>(i)] -= Vec2{1, -1};
    const Clearance touching = clearance(square);
    CHECK(touching.distance == Approx(0).margin(1e-6));
    CHECK(length(touching.normal) == Approx(1));
}

}  // namespace cairn::physics
