// What faces a direction adds up to the width across it.
#include "collide/outline_pieces.h"

#include <catch2/catch.hpp>

#include "physics/support/random_shapes.h"
#include "physics/support/rounded_hull.h"

namespace cairn::physics {

using namespace test;

TEST_CASE("the facing pieces of any outline add up to its width across the direction") {
    Random random(1);
    for (int round = 0; round < 3'000; ++round) {
        const Convex shape = random_convex(random, kForms[random.below(6)]);
        const Vec2 flow = rotate(Rotation::from_angle(random.real(-4, 4)), {random.real_f(0.1, 5), 0});
        const Point along = (1 / norm(to_point(flow))) * to_point(flow);
        const Point across{-along.y, along.x};
        double low = INFINITY;
        double high = -INFINITY;
        for (const Point p : rounded_hull(shape).core) {
            low = std::min(low, dot(p, across));
            high = std::max(high, dot(p, across));
        }
        const double width = high - low + 2 * static_cast<double>(shape.radius());
        Point sum;
        const RoundedHull hull = rounded_hull(shape);
        visit_facing_pieces(
            shape, [&](Vec2) { return flow; },
            [&](const OutlinePiece& piece) {
                sum = sum + to_point(piece.area);
                REQUIRE(dot(piece.area, flow) <= 1e-6f);
                REQUIRE(signed_distance(hull, to_point(piece.point)) == Approx(0).margin(1e-5));
            });
        REQUIRE(-dot(sum, along) == Approx(width).margin(2e-5).epsilon(0));
    }
}

TEST_CASE("all pieces of a disc that face anything at all make a closed outline") {
    const Convex disc = make_convex(Circle{{1, 2}, 0.5f}).value();
    Vec2 sum;
    float length_m = 0;
    for (const Vec2 flow : {Vec2{1, 0}, Vec2{-1, 0}}) {
        visit_facing_pieces(
            disc, [&](Vec2) { return flow; },
            [&](const OutlinePiece& piece) {
                sum += piece.area;
                length_m += length(piece.area);
            });
    }
    CHECK(length(sum) < 1e-5f);
    CHECK(length_m == Approx(kPi).epsilon(0.01));
}

}  // namespace cairn::physics
