// Distances by the module's search against all pairs of features.
#include "collide/distance.h"

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
                const Distance d = distance_between(a, b, pose);
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

}  // namespace cairn::physics
