// Outlines cut into convex parts. Oracles: the shoelace formula, and for points at random the count of
// crossings of a ray with the outline.
#include "bind/convex_parts.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include <cairn/engine/random.h>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

using physics::Vec2;
using Outline = std::vector<Vec2>;

double area(const Outline& outline) {
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
        twice += static_cast<double>(a.x) * static_cast<double>(b.y) -
                 static_cast<double>(b.x) * static_cast<double>(a.y);
    }
    return twice / 2;
}

bool contains(const Outline& outline, double x, double y) {
    bool is_inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto ax = static_cast<double>(outline[i].x), ay = static_cast<double>(outline[i].y);
        const Vec2 next = outline[(i + 1) % outline.size()];
        const auto bx = static_cast<double>(next.x), by = static_cast<double>(next.y);
        if ((ay > y) != (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)) is_inside = !is_inside;
    }
    return is_inside;
}

bool is_convex(const Outline& part) {
    for (std::size_t i = 0; i < part.size(); ++i) {
        const Vec2 a = part[i], b = part[(i + 1) % part.size()], c = part[(i + 2) % part.size()];
        if (cross(b - a, c - b) < 0) return false;
    }
    return true;
}

/// Round a point, so that it never crosses itself; deep dents.
Outline star(engine::Random& random, int corners) {
    Outline outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        const double radius = 1 + 4 * random.uniform();
        outline.push_back(
            {static_cast<float>(radius * std::cos(angle)), static_cast<float>(radius * std::sin(angle))});
    }
    return outline;
}

std::string fault(const Outline& outline) {
    const auto parts = convex_parts(outline);
    return parts ? std::string() : parts.error().message;
}

}  // namespace

TEST_CASE("the parts of a dented outline are convex, have at most eight corners and cover it once") {
    engine::Random random(7);
    for (int trial = 0; trial < 200; ++trial) {
        Outline outline = star(random, 4 + trial % 40);
        if (trial % 2 == 1) std::reverse(outline.begin(), outline.end());
        const auto parts = convex_parts(outline);
        INFO(trial);
        REQUIRE(parts);
        double sum = 0;
        for (const Outline& part : *parts) {
            CHECK(part.size() <= 8);
            if (parts->size() > 1) CHECK(is_convex(part));
            sum += std::abs(area(part));
        }
        CHECK(sum == Approx(std::abs(area(outline))).margin(0.02));  // slivers that nobody sees are left out
        for (int i = 0; i < 50; ++i) {
            const double x = 10 * random.uniform() - 5, y = 10 * random.uniform() - 5;
            int covers = 0;
            for (const Outline& part : *parts) covers += contains(part, x, y) ? 1 : 0;
            CHECK(covers <= 1);
        }
    }
}

TEST_CASE("what the physics takes as it is comes back unchanged") {
    const Outline square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const Outline clockwise = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    const Outline with_middles = {{0, 0}, {0.5f, 0.001f}, {1, 0}, {1, 0.5f}, {1, 1}, {0, 1}, {0, 0}};
    for (const Outline& outline : {square, clockwise, with_middles}) {
        const auto parts = convex_parts(outline);
        REQUIRE(parts);
        REQUIRE(parts->size() == 1);
        CHECK(parts->front() == outline);
    }
    CHECK(convex_parts(Outline{{0, 0}, {1, 0}})->size() == 1);          // for the physics to refuse
    CHECK(convex_parts(Outline{{0, 0}, {1, 0}, {2, 0}})->size() == 1);  // likewise
}

TEST_CASE("an L is two parts, and a disc of 12 corners as few as there must be") {
    CHECK(convex_parts(Outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})->size() == 2);
    Outline disc;
    for (int i = 0; i < 12; ++i) {
        const double angle = 2 * std::numbers::pi * i / 12;
        disc.push_back({static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))});
    }
    CHECK(convex_parts(disc)->size() == 2);
}

TEST_CASE("an outline that crosses or touches itself is refused, with the sides that do") {
    CHECK(fault({{0, 0}, {2, 2}, {2, 0}, {0, 2}}) ==
          "points: the side from corner 1 to 2 meets that from corner 3 to 4; the corners must stand in the "
          "order in "
          "which they go round the outline");
    CHECK(fault({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}).find("meets") != std::string::npos);
    CHECK(fault(Outline(300, Vec2{1, 0})).find("points has 300 corners, but must have at most 256") == 0);
}

TEST_CASE("a body of a dented polygon has the mass of what was drawn") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} l = { {0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2} }\n"
                      "b = w:add_polygon{ points = l, density = 2 }") == "");
    CHECK(bench.value("b:mass()") == "6.0");
    CHECK(bench.value("#b:shapes()") == "2");
    CHECK(bench.value("w:body_at(1.5, 1.5) == nil") == "true");  // in the dent
    CHECK(bench.value("w:body_at(0.5, 1.5) == b") == "true");
    CHECK(bench.value("select('#', b:add_polygon{ points = l })") == "2");
    CHECK(bench.run("w:add_polygon{ points = { {0, 0}, {2, 2}, {2, 0}, {0, 2} } }")
              .find("test.lua:1: World:add_polygon: points: the side from corner 1 to 2 meets") == 0);
    CHECK(bench.run("w:shapes_overlapping{ shape = 'polygon', points = l }").find("must be convex") !=
          std::string::npos);
    CHECK(bench.value("w:body_count()") == "1");
}

}  // namespace cairn::scripting::test
