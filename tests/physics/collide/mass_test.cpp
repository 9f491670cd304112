// Mass properties against closed forms, and against the polygon formula on a finely sampled outline.
#include "collide/mass.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "physics/support/precise.h"
#include "physics/support/random_shapes.h"
#include "physics/support/rounded_hull.h"

namespace cairn::physics {
namespace {

using namespace test;

// The shapes are given in float (6e-8 relative); a moment of second order carries four lengths.
constexpr double kFloat = 1e-6;

MassSum mass_of_geometry(const Geometry& geometry, double density = 1) {
    return mass_of(make_convex(geometry).value(), density);
}

double central_inertia(const MassSum& sum) {
    return sum.inertia - (sum.moment_x * sum.moment_x + sum.moment_y * sum.moment_y) / sum.mass;
}

// The outline with `arcs` chords for each rounded corner, as a plain polygon.
std::vector<Point> sampled_outline(const RoundedHull& hull, int arcs) {
    std::vector<Point> outline;
    const int n = hull.count();
    for (int i = 0; i < n; ++i) {
        double from = -kPiD / 2;
        double turn = 2 * kPiD;
        if (n > 1) {
            const Point before = hull.at(i) - hull.at(i + n - 1);
            const Point after = hull.at(i + 1) - hull.at(i);
            from = std::atan2(before.y, before.x) - kPiD / 2;
            turn = n == 2 ? kPiD : std::atan2(cross(before, after), dot(before, after));
        }
        for (int k = 0; k <= arcs; ++k) {
            const double angle = from + turn * k / arcs;
            outline.push_back(hull.at(i) + hull.radius * Point{std::cos(angle), std::sin(angle)});
        }
    }
    return outline;
}

// Source: Green's theorem on a polygon.
MassSum mass_of_polygon(const std::vector<Point>& outline) {
    MassSum sum;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point a = outline[i];
        const Point b = outline[(i + 1) % outline.size()];
        const double c = cross(a, b);
        sum +=
            {c / 2, c * (a.x + b.x) / 6, c * (a.y + b.y) / 6, c * (dot(a, a) + dot(a, b) + dot(b, b)) / 12};
    }
    return sum;
}

}  // namespace

TEST_CASE("the mass of a disc is pi r^2, its inertia m r^2 / 2, moved by the parallel-axis theorem") {
    const MassSum sum = mass_of_geometry(Circle{.center_m = {3, -2}, .radius_m = 0.5f}, 4);
    const double mass = 4 * kPiD * 0.25;
    CHECK(sum.mass == Approx(mass).epsilon(kFloat));
    CHECK(sum.moment_x == Approx(3 * mass).epsilon(kFloat));
    CHECK(sum.moment_y == Approx(-2 * mass).epsilon(kFloat));
    CHECK(sum.inertia == Approx(mass * 0.125 + mass * 13).epsilon(kFloat));
}

TEST_CASE("a segment has no mass") {
    const MassSum sum = mass_of_geometry(Segment{{1, 2}, {3, -1}}, 5);
    CHECK(sum.mass == 0);
    CHECK(sum.moment_x == 0);
    CHECK(sum.moment_y == 0);
    CHECK(sum.inertia == 0);
}

TEST_CASE("the mass of a box is w h, its inertia m (w^2 + h^2) / 12, however it is turned") {
    for (const float angle : {0.0f, 0.3f, 1.5f, -2.0f}) {
        const MassSum sum = mass_of_geometry(Box{1, 0.25f, {2, 1}, angle}, 3);
        CHECK(sum.mass == Approx(3).epsilon(kFloat));
        CHECK(sum.moment_x == Approx(6).epsilon(kFloat));
        CHECK(sum.moment_y == Approx(3).epsilon(kFloat));
        CHECK(central_inertia(sum) == Approx(3 * (4 + 0.25) / 12).epsilon(1e-5));  // cancels two digits
    }
}

TEST_CASE("the mass of a right triangle is w h / 2, its inertia m (w^2 + h^2) / 18") {
    const std::array<Vec2, 3> points{Vec2{0, 0}, Vec2{3, 0}, Vec2{0, 2}};
    const MassSum sum = mass_of_geometry(Polygon{.points_m = points});
    CHECK(sum.mass == Approx(3).epsilon(kFloat));
    CHECK(sum.moment_x / sum.mass == Approx(1).epsilon(kFloat));
    CHECK(sum.moment_y / sum.mass == Approx(2.0 / 3).epsilon(kFloat));
    CHECK(central_inertia(sum) == Approx(3 * (9.0 + 4) / 18).epsilon(1e-5));
}

TEST_CASE("the mass of a capsule is that of its rectangle and its two half discs") {
    constexpr double kLength = 2;
    constexpr double kRadius = 0.5;
    const MassSum sum = mass_of_geometry(Capsule{{-1, 0}, {1, 0}, 0.5f});
    const double rectangle = kLength * 2 * kRadius;
    const double half_disc = kPiD * kRadius * kRadius / 2;
    // A half disc: its centre lies 4 r / 3 pi from the diameter, about which its inertia is m r^2 / 2.
    const double offset = 4 * kRadius / (3 * kPiD);
    const double half_central = half_disc * (kRadius * kRadius / 2 - offset * offset);
    const double arm = kLength / 2 + offset;
    const double inertia = rectangle * (kLength * kLength + 4 * kRadius * kRadius) / 12 +
                           2 * (half_central + half_disc * arm * arm);
    CHECK(sum.mass == Approx(rectangle + 2 * half_disc).epsilon(kFloat));
    CHECK(sum.moment_x == Approx(0).margin(kFloat));
    CHECK(sum.moment_y == Approx(0).margin(kFloat));
    CHECK(sum.inertia == Approx(inertia).epsilon(kFloat));
}

TEST_CASE("mass, centre and inertia of any shape are those of its finely sampled outline") {
    Random random(1);
    for (const Form form : kForms) {
        for (int round = 0; round < 60; ++round) {
            const Convex shape = random_convex(random, form);
            const double density = random.real(0.1, 5);
            const MassSum sum = mass_of(shape, density);
            // Chords of an arc miss (step)^2 / 6 of it: with 2000 per corner at most 4e-7 for a full circle
            // and a quarter of that for a capsule's half.
            const MassSum expected = mass_of_polygon(sampled_outline(rounded_hull(shape), 4000));
            INFO("form " << static_cast<int>(form) << ", round " << round);
            REQUIRE(sum.mass == Approx(density * expected.mass).epsilon(2e-6));
            const double size = 2.5;  // of the shapes
            REQUIRE(sum.moment_x ==
                    Approx(density * expected.moment_x).epsilon(2e-6).margin(2e-6 * sum.mass * size));
            REQUIRE(sum.moment_y ==
                    Approx(density * expected.moment_y).epsilon(2e-6).margin(2e-6 * sum.mass * size));
            REQUIRE(sum.inertia == Approx(density * expected.inertia).epsilon(2e-6));
        }
    }
}

TEST_CASE("the mass of a rounded box is what a grid of points inside it counts") {
    const Convex shape = make_convex(Box{0.6f, 0.3f, {0.2f, -0.1f}, 0.4f, 0.15f}).value();
    const MassSum sum = mass_of(shape, 1);
    const RoundedHull hull = rounded_hull(shape);
    constexpr double kSpacing = 0.002;
    MassSum counted;
    for (double x = -1; x < 1.4; x += kSpacing) {
        for (double y = -1.2; y < 1.2; y += kSpacing) {
            if (signed_distance(hull, {x, y}) > 0) continue;
            const double cell = kSpacing * kSpacing;
            counted += {cell, cell * x, cell * y, cell * (x * x + y * y)};
        }
    }
    // Cells on the boundary count wholly or not at all: 4 m / spacing of them, right on average, so that the
    // error is about the root of their number times a cell: 45 * 4e-6 m^2 of 1.3 m^2.
    CHECK(sum.mass == Approx(counted.mass).epsilon(5e-4));
    CHECK(sum.moment_x == Approx(counted.moment_x).epsilon(2e-3));
    CHECK(sum.moment_y == Approx(counted.moment_y).epsilon(2e-3));
    CHECK(sum.inertia == Approx(counted.inertia).epsilon(1e-3));
}

}  // namespace cairn::physics
