// Shapes in their common form: bounds, containment, extent; and the words of errors about geometry.
#include "collide/convex.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "physics/support/random_shapes.h"
#include "physics/support/rounded_hull.h"

namespace cairn::physics {
namespace {

using Catch::Matchers::Contains;
using namespace test;

std::string error_of(const Geometry& geometry) {
    const Result<Convex> convex = make_convex(geometry);
    return convex ? "no error" : convex.error().message;
}

// Half a unit in the last place of a coordinate of 2 m, through a rotation and two sums.
constexpr double kFloatRounding_m = 1e-6;

}  // namespace

TEST_CASE("a shape of which anything that follows from its points was changed is not consistent") {
    Random random(2);
    std::vector<Convex> shapes{make_chain_segment({}, {0, 0}, {1, 0}, Vec2{2, 1}),
                               make_chain_segment(Vec2{-1, 1}, {0, 0}, {1, 0}, {}),
                               make_convex(Box{0.3f, 0.7f, {0.1f, -0.2f}}).value(),
                               make_convex(Box{0.3f, 0.7f, {0.1f, -0.2f}, 0.4f, 0.1f}).value()};
    for (const Form form : kForms) {
        for (int i = 0; i < 100; ++i) shapes.push_back(random_convex(random, form));
    }
    for (const Convex& shape : shapes) {
        REQUIRE(is_consistent(shape));
        for (std::size_t i = 0; i < kMaxPolygonVertices; ++i) {
            // The one point of a circle may be anywhere, but its repetitions are where it is.
            Convex changed = shape;
            changed.outline.points_m[i].x += 0.125f;
            REQUIRE(!is_consistent(changed));
            changed = shape;
            changed.normals[i].y += 0.125f;
            REQUIRE(!is_consistent(changed));
        }
        Convex changed = shape;
        changed.centroid.y += 0.125f;
        REQUIRE(!is_consistent(changed));
        if (!shape.is_box) continue;
        changed = shape;
        changed.half_size.x *= 1.5f;
        REQUIRE(!is_consistent(changed));
        changed = shape;
        changed.outline.radius_m = 0.1f;
        REQUIRE(!is_consistent(changed));
    }
}

TEST_CASE("every shape's points run anticlockwise, with unit normals that point out") {
    Random random(1);
    for (const Form form : kForms) {
        for (int round = 0; round < 500; ++round) {
            const Convex shape = random_convex(random, form);
            const RoundedHull hull = rounded_hull(shape);
            for (int i = 0; i < shape.count() && shape.count() > 1; ++i) {
                const Point edge = hull.at(i + 1) - hull.at(i);
                const Point normal = to_point(shape.normals[i]);
                REQUIRE(norm(normal) == Approx(1).epsilon(1e-6));
                // To the right of the direction of travel; a normal is rounded to 6e-8 per component.
                REQUIRE(cross(normal, edge) == Approx(norm(edge)).epsilon(1e-6));
                REQUIRE(dot(normal, edge) == Approx(0).margin(1e-6 * norm(edge)));
                for (const Point p : hull.core) REQUIRE(dot(normal, p - hull.at(i)) <= kFloatRounding_m);
            }
        }
    }
}

TEST_CASE("a point is in a shape exactly when its distance from the core is at most the radius") {
    Random random(2);
    int inside = 0;
    for (const Form form : kForms) {
        for (int round = 0; round < 200; ++round) {
            const Convex shape = random_convex(random, form);
            const RoundedHull hull = rounded_hull(shape);
            for (int i = 0; i < 50; ++i) {
                const Vec2 p = random.vector(-2, 2);
                const double distance = signed_distance(hull, to_point(p));
                if (std::fabs(distance) < kFloatRounding_m) continue;
                INFO("form " << static_cast<int>(form) << ", distance " << distance);
                REQUIRE(contains_point(shape, p) == (distance < 0));
                inside += distance < 0 ? 1 : 0;
            }
        }
    }
    CHECK(inside > 2000);
}

TEST_CASE("bounds hold every point of a turned shape, and touch it on all four sides") {
    Random random(3);
    for (const Form form : kForms) {
        for (int round = 0; round < 500; ++round) {
            const Convex shape = random_convex(random, form);
            const Transform xf{{random.real(-50, 50), random.real(-50, 50)},
                               Rotation::from_angle(random.real(-4, 4))};
            const Aabb box = bounds(shape, xf);
            const RoundedHull hull = rounded_hull(shape, {{}, xf.q});
            double left = INFINITY;
            double right = -INFINITY;
            double bottom = INFINITY;
            double top = -INFINITY;
            for (const Point p : hull.core) {
                left = std::min(left, xf.p.x + p.x - hull.radius);
                right = std::max(right, xf.p.x + p.x + hull.radius);
                bottom = std::min(bottom, xf.p.y + p.y - hull.radius);
                top = std::max(top, xf.p.y + p.y + hull.radius);
            }
            // Rounded outward to float at 50 m: 4e-6 m.
            constexpr double kTolerance_m = 6e-6;
            REQUIRE(static_cast<double>(box.lower.x) == Approx(left).margin(kTolerance_m).epsilon(0));
            REQUIRE(static_cast<double>(box.upper.x) == Approx(right).margin(kTolerance_m).epsilon(0));
            REQUIRE(static_cast<double>(box.lower.y) == Approx(bottom).margin(kTolerance_m).epsilon(0));
            REQUIRE(static_cast<double>(box.upper.y) == Approx(top).margin(kTolerance_m).epsilon(0));
        }
    }
}

TEST_CASE("the farthest distance is that of the farthest core point, plus the radius") {
    const Convex box = make_convex(Box{3, 4, {}, 0, 0.5f}).value();
    CHECK(static_cast<double>(farthest_distance(box, {0, 0})) == Approx(5.5));
    CHECK(static_cast<double>(farthest_distance(box, {3, 4})) == Approx(10.5));
    const Convex disc = make_convex(Circle{{1, 0}, 2}).value();
    CHECK(static_cast<double>(farthest_distance(disc, {0, 0})) == Approx(3));
}

TEST_CASE("a turned and moved box has its corners where the formula puts them") {
    const Convex box = make_convex(Box{2, 1, {10, 20}, kPi / 2}).value();
    const Vec2 expected[] = {{11, 18}, {11, 22}, {9, 22}, {9, 18}};
    REQUIRE(box.count() == 4);
    for (int i = 0; i < 4; ++i) CHECK(length(box.point(i) - expected[i]) < 5e-6f);  // float at 20 m
}

TEST_CASE("bad geometry gives an error that names the field, the value and the rule") {
    CHECK_THAT(error_of(Circle{{}, 0}), Contains("circle.radius_m is 0") && Contains("greater than 0"));
    CHECK_THAT(error_of(Circle{{}, -1}), Contains("circle.radius_m is -1"));
    CHECK_THAT(error_of(Circle{{}, NAN}), Contains("circle.radius_m is nan"));
    CHECK_THAT(error_of(Circle{{}, 2e6f}), Contains("circle.radius_m") && Contains("1e6 m"));
    CHECK_THAT(error_of(Circle{{0, INFINITY}, 1}), Contains("circle.center_m is (0, inf)"));
    CHECK_THAT(error_of(Circle{{3e6f, 0}, 1}), Contains("circle.center_m") && Contains("1e6 m"));
    CHECK_THAT(error_of(Capsule{{0, 0}, {0.004f, 0}, 1}), Contains("capsule.a_m") && Contains("0.005 m"));
    CHECK_THAT(error_of(Capsule{{NAN, 0}, {1, 0}, 1}), Contains("capsule.a_m"));
    CHECK_THAT(error_of(Capsule{{0, 0}, {1, NAN}, 1}), Contains("capsule.b_m"));
    CHECK_THAT(error_of(Capsule{{0, 0}, {1, 0}, 0}), Contains("capsule.radius_m is 0"));
    CHECK_THAT(error_of(Box{0, 1}), Contains("box.half_width_m is 0"));
    CHECK_THAT(error_of(Box{1, -2}), Contains("box.half_height_m is -2"));
    CHECK_THAT(error_of(Box{1, 1, {NAN, 0}}), Contains("box.center_m"));
    CHECK_THAT(error_of(Box{1, 1e-8f, {3, 4}}),
               Contains("box.half_height_m is 1e-08, but must be large enough to tell its corners apart"));
    CHECK(make_convex(Box{1e6f, 0.5f}));
    CHECK(make_convex(Box{1e-8f, 1e-8f}));
    CHECK_THAT(error_of(Box{1, 1, {}, INFINITY}), Contains("box.angle_rad is inf"));
    CHECK_THAT(error_of(Box{1, 1, {}, 0, -0.1f}), Contains("box.radius_m is -0.1") && Contains("at least 0"));
    const std::array<Vec2, 3> triangle{Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}};
    CHECK_THAT(error_of(Polygon{triangle, NAN}), Contains("polygon.radius_m is nan"));
    CHECK_THAT(error_of(Polygon{std::span(triangle).first(2)}), Contains("2 distinct points"));
    const std::array<Vec2, 3> wild{Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 5e6f}};
    CHECK_THAT(error_of(Polygon{wild}), Contains("polygon.points_m[2] is 5e+06") && Contains("1e6 m"));
}

}  // namespace cairn::physics
