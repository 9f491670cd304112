#include "collide/ring.h"

#include <catch2/catch.hpp>
#include <set>
#include <utility>

#include "collide/mass.h"
#include "physics/support/random_shapes.h"
#include "physics/support/rings.h"

namespace cairn::physics {
namespace {

using namespace test;

double area_of(const Convex& shape) {
    return mass_of(shape, 1).mass;
}

TEST_CASE("The two parts of a ring add up to the whole, and are convex", "[ring]") {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const Ring ring = random_ring(random, 3 + random.below(10));
        const DirectedLine line = random_line(random);
        const Ring left = left_part(ring, line);
        const Ring right = left_part(ring, line.reversed());
        REQUIRE(area(left) + area(right) == Approx(area(ring)).epsilon(1e-12));
        REQUIRE(is_convex(left));
        REQUIRE(is_convex(right));
        for (const RingPoint p : left) REQUIRE(line.distance(p) >= -1e-12);
        for (const RingPoint p : right) REQUIRE(line.distance(p) <= 1e-12);
    }
}

TEST_CASE("The parts of a ring share the ends of the cut to the last bit", "[ring]") {
    Random random(2);
    int cut = 0;
    for (int i = 0; i < 500; ++i) {
        const Ring ring = random_ring(random, 7);
        const DirectedLine line = random_line(random);
        const Ring left = left_part(ring, line);
        const Ring right = left_part(ring, line.reversed());
        if (left.empty() || right.empty()) continue;
        ++cut;
        int shared = 0;
        for (const RingPoint p : left) shared += std::count(right.begin(), right.end(), p) > 0 ? 1 : 0;
        REQUIRE(shared == 2);
    }
    CHECK(cut > 100);
}

TEST_CASE("A line along an edge or past a ring leaves all of it on one side", "[ring]") {
    const Ring box = box_ring(2, 1);
    const DirectedLine below{{0, -1}, {1, 0}};
    CHECK(left_part(box, below) == box);
    CHECK(left_part(box, below.reversed()).empty());
    CHECK(left_part(box, below.shifted(-3)) == box);
    CHECK(left_part(box, below.shifted(3)).empty());
}

TEST_CASE("The least width of a ring is that of all directions", "[ring]") {
    Random random(3);
    for (int i = 0; i < 50; ++i) {
        const Ring ring = random_ring(random, 3 + random.below(8));
        double least = 1e9;
        for (int k = 0; k < 20000; ++k) {
            const double angle = k * deterministic::acos(-1) / 20000;
            const RingPoint direction{deterministic::cos(angle), deterministic::sin(angle)};
            double low = 1e9;
            double high = -1e9;
            for (const RingPoint p : ring) {
                low = std::min(low, dot(p, direction));
                high = std::max(high, dot(p, direction));
            }
            least = std::min(least, high - low);
        }
        REQUIRE(least_width(ring) == Approx(least).epsilon(1e-3));
    }
}

TEST_CASE("A line passes through a ring from side to side", "[ring]") {
    const DirectedLine slanting{{0, 0}, {0.6, 0.8}};
    const std::optional<Interval> way = interval_near(box_ring(3, 2), slanting, 1e-9);
    REQUIRE(way);
    CHECK(way->low == Approx(-2.5).epsilon(1e-6));
    CHECK(way->high == Approx(2.5).epsilon(1e-6));
    CHECK_FALSE(interval_near(box_ring(3, 2), slanting.shifted(10), 1e-9));
    // Within reach of the line there is the whole top side.
    const std::optional<Interval> top = interval_near(box_ring(3, 2), {{0, 2.01}, {1, 0}}, 0.02);
    REQUIRE(top);
    CHECK(top->low == Approx(-3));
    CHECK(top->high == Approx(3));
}

TEST_CASE("The ring of a rounded shape lies within it and leaves out little", "[ring]") {
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const Convex shape = random_convex(random, kForms[static_cast<std::size_t>(i) % kForms.size()]);
        const Ring ring = ring_of(shape);
        REQUIRE(is_convex(ring));
        const auto radius = static_cast<double>(shape.radius());
        REQUIRE(area(ring) <= area_of(shape) * (1 + 1e-6));
        REQUIRE(area(ring) >= area_of(shape) * (radius == 0 ? 1 - 1e-6 : 0.94));
    }
    CHECK(ring_of(*make_convex(Circle{{1, 2}, 3})).size() == 12);
}

TEST_CASE("A ring of many corners becomes shapes that cover it side by side", "[ring]") {
    Random random(5);
    for (int count = 3; count <= 40; ++count) {
        const Ring ring = random_ring(random, count);
        const std::vector<Convex> shapes = shapes_of(ring);
        if (count <= kMaxPolygonVertices) REQUIRE(shapes.size() == 1);
        double sum = 0;
        for (const Convex& shape : shapes) sum += area_of(shape);
        REQUIRE(sum == Approx(area(ring)).epsilon(2e-3));
    }
    CHECK(shapes_of({{0, 0}, {1, 0}, {2, 1e-9}}).empty());
    CHECK(shapes_of({}).empty());
}

TEST_CASE("The nearest point of an outline is no farther than any other", "[ring]") {
    Random random(6);
    for (int i = 0; i < 100; ++i) {
        const Ring ring = random_ring(random, 6);
        const RingPoint from{random.real(-4, 4), random.real(-4, 4)};
        double least = 1e9;
        for (std::size_t k = 0; k < ring.size(); ++k) {
            for (int n = 0; n <= 1000; ++n) {
                const RingPoint p = ring[k] + (n / 1000.0) * (ring[(k + 1) % ring.size()] - ring[k]);
                least = std::min(least, length(p - from));
            }
        }
        REQUIRE(length(nearest_on_outline(ring, from) - from) == Approx(least).margin(2e-3));
    }
}

}  // namespace
}  // namespace cairn::physics
