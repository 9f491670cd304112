// Distances by the module's search against all pairs of features.
#include "collide/distance.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "physics/support/random_shapes.h"
#include "physics/support/rounded_hull.h"

namespace cairn::physics {

using namespace test;

TEST_CASE("the distance of two shapes is the least of all pairs of features, with its direction") {
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
                // Whatever the guess.
                const Vec2 guess = round % 4 == 0 ? Vec2{} : random.vector(-2, 2);
                const Distance d =
                    round % 4 == 1 ? distance_between(a, b, pose) : distance_between(a, b, pose, guess);
                INFO("forms " << static_cast<int>(form_a) << " and " << static_cast<int>(form_b) << ", round "
                              << round);
                if (expected.cores_overlap) {
                    REQUIRE(d.distance == 0);
                    REQUIRE(d.normal == Vec2{});
                    ++overlapping;
                    continue;
                }
                ++apart;
                // Coordinates of up to 4 m in float, through a rotation and a few products.
                REQUIRE(static_cast<double>(d.distance) == Approx(expected.distance).margin(3e-6).epsilon(0));
                const double cores = expected.distance + static_cast<double>(a.radius() + b.radius());
                if (cores < 0.01) continue;  // too near for the direction of a float difference
                REQUIRE(dot(to_point(d.normal), expected.normal) > 1 - 1e-4);
                const Point way = to_point(d.point_b) - to_point(d.point_a);
                REQUIRE(norm(way) == Approx(cores).margin(3e-6).epsilon(0));
            }
        }
    }
    CHECK(apart > 3000);
    CHECK(overlapping > 500);
}

// Two corners of b lie 0.5 mm apart, so two edges of the difference are all but one line.
TEST_CASE("the distance to a long edge is that of the nearest of several corners beside its end") {
    const std::array<Vec2, 3> large{
        {{-0.929060817f, 0.164705992f}, {1.92156863f, 1.92156863f}, {-0.51346612f, 1.92156863f}}};
    const std::array<Vec2, 3> small{
        {{1.92108035f, 1.92156863f}, {1.92156863f, 1.92156863f}, {1.92156863f, 1.92181277f}}};
    const Convex a = make_convex(Polygon{large}).value();
    const Convex b = make_convex(Polygon{small}).value();
    const RelativePose pose{{3.84313726f, 3.84179449f}, Rotation::from_angle(3.1415926535897931)};
    const RelativePose mirrored{-inverse_rotate(pose.q, pose.p), inverse(pose.q)};
    const Separation expected = separation(rounded_hull(a), rounded_hull(b, pose));
    CHECK(static_cast<double>(distance_between(a, b, pose).distance) ==
          Approx(expected.distance).margin(3e-6).epsilon(0));
    CHECK(static_cast<double>(distance_between(b, a, mirrored).distance) ==
          Approx(expected.distance).margin(3e-6).epsilon(0));
}

}  // namespace cairn::physics
