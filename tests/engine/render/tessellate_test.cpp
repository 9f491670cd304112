// Triangles against the areas of the shapes: the sum of (area * mean coverage) must be the shape's area.
#include "render/tessellate.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

using namespace cairn::engine;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
const Brush kWhite{Color{1, 1, 1, 1}};

/// Alpha stands for coverage: the brush is opaque.
double covered_area(const TriangleList& list) {
    double sum = 0;
    for (std::size_t i = 0; i < list.indices.size(); i += 3) {
        const RenderVertex& a = list.vertices[list.indices[i]];
        const RenderVertex& b = list.vertices[list.indices[i + 1]];
        const RenderVertex& c = list.vertices[list.indices[i + 2]];
        const double area = 0.5 * std::fabs(cross(b.position - a.position, c.position - a.position));
        sum += area * (a.color.a + b.color.a + c.color.a) / (3.0 * 255);
    }
    return sum;
}

TriangleList filled(std::span<const Vec2> points) {
    TriangleList list;
    fill_convex(points, kWhite, list);
    return list;
}

TriangleList stroked(std::span<const Vec2> points, bool closed, float width, LineCap cap = LineCap::Butt) {
    TriangleList list;
    stroke(points, closed, width, cap, kWhite, list);
    return list;
}

std::vector<Vec2> rotated_box(float width, float height, float angle_rad) {
    std::vector<Vec2> points = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    for (Vec2& p : points) p = Vec2{100, 80} + Affine2::rotation(angle_rad).apply(p);
    return points;
}

}  // namespace

TEST_CASE("the triangles of a box cover its area, at any angle and in either winding") {
    // Where the rims of two edges meet, coverage is not their product: about a third of a pixel in all.
    for (const float angle_rad : {0.0f, 0.3f, 1.0f, 2.5f}) {
        std::vector<Vec2> box = rotated_box(40, 25, angle_rad);
        CHECK(covered_area(filled(box)) == Approx(1000).margin(0.5));
        std::reverse(box.begin(), box.end());
        CHECK(covered_area(filled(box)) == Approx(1000).margin(0.5));
    }
}

TEST_CASE("circles have a limited number of segments, whatever their radius in pixels is") {
    const int most = circle_segments(1e5f);
    CHECK(most == 1024);
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float radius : {1e6f, 1e30f, std::numeric_limits<float>::max(), infinity, infinity - infinity})
        CHECK(circle_segments(radius) == most);
    CHECK(circle_segments(0) == 8);
    // The determinant of this map is infinity - infinity.
    Affine2 huge = Affine2::scaling({1e20f, 1e20f}) * Affine2::scaling({1e20f, 1e20f});
    huge.b = huge.c = 1e30f;
    CHECK(circle_points({0, 0}, 1, huge).size() == 1024);
    CHECK(arc_points({0, 0}, 1, 0, kPi, huge).size() == 513);
    CHECK(capsule_points({0, 0}, {1, 0}, 1, huge).size() == 1026);
}

TEST_CASE("the triangles of a circle cover its area") {
    for (const float radius : {1.0f, 3.0f, 10.0f, 77.7f, 1000.0f}) {
        const double expected = std::numbers::pi * radius * radius;
        // The rim adds pi / 12: the integral of a linear ramp one pixel wide around a circle.
        INFO("radius " << radius);
        CHECK(covered_area(filled(circle_points({500, 500}, radius, {}))) ==
              Approx(expected).epsilon(0.002).margin(0.4));
    }
}

TEST_CASE("a circle's segments are enough to hide its corners") {
    for (const float radius : {2.0f, 20.0f, 200.0f, 20000.0f}) {
        const float sagitta = radius * (1 - std::cos(kPi / static_cast<float>(circle_segments(radius))));
        CHECK(sagitta <= 0.11f);
    }
}

TEST_CASE("a circle under a transform that stretches is an ellipse of the right area") {
    const auto points =
        circle_points({0, 0}, 10, Affine2::translation({50, 50}) * Affine2::scaling({3, 0.5f}));
    CHECK(covered_area(filled(points)) == Approx(std::numbers::pi * 30 * 5).epsilon(0.01));
}

TEST_CASE("the triangles of a capsule cover its area") {
    const auto points = capsule_points({20, 30}, {60, 60}, 8, {});
    CHECK(covered_area(filled(points)) == Approx(50 * 16 + std::numbers::pi * 64).epsilon(0.01));
    CHECK(covered_area(filled(capsule_points({5, 5}, {5, 5}, 3, {}))) ==
          Approx(std::numbers::pi * 9).margin(0.4));
}

TEST_CASE("slivers thinner than a pixel are faint instead of fat") {
    for (const float thickness : {0.9f, 0.5f, 0.1f, 0.03f}) {
        INFO("thickness " << thickness);
        // The ends add up to a pixel's width of rim.
        CHECK(covered_area(filled(rotated_box(100, thickness, 0.4f))) ==
              Approx(100 * thickness).epsilon(0.03));
    }
}

TEST_CASE("polygons without area add nothing") {
    CHECK(filled(std::vector<Vec2>{}).indices.empty());
    CHECK(filled(std::vector<Vec2>{{1, 1}, {5, 5}}).indices.empty());
    CHECK(filled(std::vector<Vec2>{{1, 1}, {5, 5}, {9, 9}}).indices.empty());
    CHECK(filled(std::vector<Vec2>{{3, 3}, {3, 3}, {3, 3}, {3, 3}}).indices.empty());
}

TEST_CASE("repeated corners change nothing") {
    const std::vector<Vec2> triangle = {{10, 10}, {50, 10}, {30, 40}};
    const std::vector<Vec2> doubled = {{10, 10}, {10, 10}, {50, 10}, {30, 40}, {30, 40}, {10, 10}};
    CHECK(filled(doubled).vertices.size() == filled(triangle).vertices.size());
    CHECK(covered_area(filled(doubled)) == Approx(covered_area(filled(triangle))));
}

TEST_CASE("a line covers its length times its width, however thin") {
    const std::array<Vec2, 2> line = {Vec2{10, 20}, {90, 80}};
    for (const float width : {0.25f, 1.0f, 2.0f, 7.5f}) {
        INFO("width " << width);
        CHECK(covered_area(stroked(line, false, width)) == Approx(100 * width).epsilon(0.01));
    }
}

TEST_CASE("round caps add a circle") {
    const std::array<Vec2, 2> line = {Vec2{50, 50}, {150, 50}};
    CHECK(covered_area(stroked(line, false, 12, LineCap::Round)) ==
          Approx(100 * 12 + std::numbers::pi * 36).epsilon(0.01));
    CHECK(covered_area(stroked(std::array{Vec2{9, 9}, Vec2{9, 9}}, false, 12, LineCap::Round)) ==
          Approx(std::numbers::pi * 36).epsilon(0.02));
    CHECK(stroked(std::array{Vec2{9, 9}, Vec2{9, 9}}, false, 12, LineCap::Butt).indices.empty());
}

TEST_CASE("an outline of a box has mitred corners and the area between two boxes") {
    const auto box = rotated_box(60, 40, 0.7f);
    CHECK(covered_area(stroked(box, true, 4)) == Approx(64 * 44 - 56 * 36).margin(2));
    // Sharp corners: the outermost vertex lies on the diagonal of a box that is grown by half the width and
    // the rim.
    double farthest = 0;
    const Vec2 middle = (box[0] + box[2]) * 0.5f;
    for (const RenderVertex& v : stroked(box, true, 4).vertices)
        farthest = std::max<double>(farthest, length(v.position - middle));
    CHECK(farthest == Approx(std::hypot(30 + 2.5, 20 + 2.5)).margin(0.01));
}

TEST_CASE("an outline of a circle covers the ring") {
    CHECK(covered_area(stroked(circle_points({100, 100}, 50, {}), true, 6)) ==
          Approx(2 * std::numbers::pi * 50 * 6).epsilon(0.005));
}

TEST_CASE("a sharp turn is rounded and never reaches further than the line is wide") {
    const std::array<Vec2, 3> spike = {Vec2{0, 0}, {100, 0}, {0, 5}};
    for (const RenderVertex& v : stroked(spike, false, 10, LineCap::Round).vertices)
        CHECK(v.position.x <= 100 + 5.5f + 0.01f);
}

TEST_CASE("the outer vertices of every rim are transparent, and inner ones carry the brush's alpha") {
    TriangleList list;
    fill_convex(rotated_box(40, 25, 0.2f), Brush(Color{1, 0, 0, 0.5f}), list);
    REQUIRE(list.vertices.size() == 8);
    for (std::size_t i = 0; i < 8; ++i) {
        CHECK(list.vertices[i].color.a == (i % 2 == 0 ? 128 : 0));
        CHECK(list.vertices[i].color.r == list.vertices[i].color.a);  // premultiplied
    }
}

TEST_CASE("a brush's texture coordinates follow the position and keep to their bounds") {
    const Brush brush(Color{}, Affine2::scaling({0.1f, 0.1f}), {0.25f, 0, 0.5f, 1});
    CHECK(brush.vertex({5, 3}, 1).uv == Vec2{0.5f, 0.3f});
    CHECK(brush.vertex({1, -2}, 1).uv == Vec2{0.25f, 0});
    CHECK(brush.vertex({9, 20}, 1).uv == Vec2{0.75f, 1});
}

TEST_CASE("color components are clamped to bytes") {
    CHECK(to_rgba8({2, -1, 0.5f, 1}) == Rgba8{255, 0, 128, 255});
    CHECK(to_rgba8({std::nanf(""), 0, 0, 1}) == Rgba8{0, 0, 0, 255});
}

// ---- Polygons with dents

namespace {

/// A star with as many points; every second corner is a dent.
std::vector<Vec2> star(int points, float outer, float inner) {
    std::vector<Vec2> corners;
    for (int i = 0; i < 2 * points; ++i) {
        const float angle_rad = kPi * static_cast<float>(i) / static_cast<float>(points);
        const float radius = i % 2 == 0 ? outer : inner;
        corners.push_back({100 + radius * std::cos(angle_rad), 100 + radius * std::sin(angle_rad)});
    }
    return corners;
}

}  // namespace

TEST_CASE("the triangles of polygons with dents cover their areas, in either winding") {
    // Of n kites with the diagonals R and 2 r sin(pi / n).
    const auto star_area = [](int n, double outer, double inner) {
        return n * outer * inner * std::sin(std::numbers::pi / n);
    };
    for (const int n : {4, 5, 12}) {
        std::vector<Vec2> corners = star(n, 60, 30);
        for (int winding = 0; winding < 2; ++winding) {
            TriangleList list;
            fill_simple(corners, kWhite, list);
            CHECK(covered_area(list) == Approx(star_area(n, 60, 30)).epsilon(0.005));
            CHECK(cut_into_triangles(star(n, 60, 30)).size() == static_cast<std::size_t>(2 * n - 2));
            std::reverse(corners.begin(), corners.end());
        }
    }
    // A comb, in which most corners are no ears.
    std::vector<Vec2> comb = {{0, 0}, {100, 0}, {100, 50}};
    for (float x = 90; x > 0; x -= 20) {
        comb.insert(comb.end(), {{x, 50}, {x, 10}, {x - 10, 10}, {x - 10, 50}});
    }
    comb.resize(comb.size() - 1);
    comb.push_back({0, 10});
    TriangleList list;
    fill_simple(comb, kWhite, list);
    CHECK(covered_area(list) == Approx(100 * 50 - 5 * 10 * 40).epsilon(0.01));
}

TEST_CASE("convex is what turns one way, once round") {
    CHECK(is_convex(circle_points({50, 50}, 1000, {})));
    CHECK(is_convex(rotated_box(40, 25, 0.7f)));
    CHECK(is_convex(std::array<Vec2, 4>{Vec2{0, 0}, {5, 0}, {10, 0}, {5, 5}}));
    CHECK(is_convex(std::array<Vec2, 3>{Vec2{0, 0}, {5, 5}, {10, 10}}));  // no area
    CHECK_FALSE(is_convex(star(5, 60, 30)));
    const std::vector<Vec2> points = star(5, 60, 30);
    const std::array<Vec2, 5> pentagram = {points[0], points[4], points[8], points[2], points[6]};
    CHECK_FALSE(is_convex(pentagram));
    CHECK(find_crossing(pentagram).has_value());
    CHECK_FALSE(find_crossing(points).has_value());
    const std::array<Vec2, 4> bow = {Vec2{0, 0}, {20, 20}, {20, 0}, {0, 20}};
    CHECK(find_crossing(bow) == std::pair<std::size_t, std::size_t>{0, 2});
}
