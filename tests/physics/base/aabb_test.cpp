#include "base/aabb.h"

#include <catch2/catch.hpp>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using test::Random;

Aabb random_box(Random& random) {
    const Vec2 lower = random.vector(-5, 5);
    const float width = random.real_f(0, 3);
    return {lower, lower + Vec2{width, random.real_f(0, 3)}};
}

}  // namespace

TEST_CASE("boxes far from the origin are rounded outward") {
    Random random(1);
    for (const double far : {0.0, 1e3, 1e7, -1e7, 1e12}) {
        for (int i = 0; i < 5'000; ++i) {
            const Position origin{far + random.real(-100, 100), -far + random.real(-100, 100)};
            const Vec2 lower = random.vector(-2, 0);
            const Vec2 upper = random.vector(0, 2);
            const Aabb box = make_aabb(origin, lower, upper);
            // In double the corners are exact to 1e-16 relative, far below the float spacing being tested.
            REQUIRE(static_cast<double>(box.lower.x) <= origin.x + static_cast<double>(lower.x));
            REQUIRE(static_cast<double>(box.lower.y) <= origin.y + static_cast<double>(lower.y));
            REQUIRE(static_cast<double>(box.upper.x) >= origin.x + static_cast<double>(upper.x));
            REQUIRE(static_cast<double>(box.upper.y) >= origin.y + static_cast<double>(upper.y));
            // And by no more than one place of float.
            const auto spacing = static_cast<double>(std::nextafter(std::fabs(box.upper.x), INFINITY) -
                                                     std::fabs(box.upper.x));
            REQUIRE(static_cast<double>(box.upper.x) <= origin.x + static_cast<double>(upper.x) + spacing);
        }
    }
}

TEST_CASE("a number that float holds is rounded to itself") {
    CHECK(round_up(1.5) == 1.5f);
    CHECK(round_down(-0.25) == -0.25f);
    CHECK(round_up(16777217.0) == 16777218.0f);
    CHECK(round_down(16777217.0) == 16777216.0f);
}

TEST_CASE("overlap, containment and merging agree with intervals on both axes") {
    Random random(2);
    for (int i = 0; i < 20'000; ++i) {
        const Aabb a = random_box(random);
        const Aabb b = random_box(random);
        const bool meet_x = std::max(a.lower.x, b.lower.x) <= std::min(a.upper.x, b.upper.x);
        const bool meet_y = std::max(a.lower.y, b.lower.y) <= std::min(a.upper.y, b.upper.y);
        REQUIRE(overlap(a, b) == (meet_x && meet_y));
        REQUIRE(overlap(b, a) == overlap(a, b));
        const Aabb both = merged(a, b);
        REQUIRE(contains(both, a));
        REQUIRE(contains(both, b));
        if (contains(a, b)) REQUIRE(half_perimeter(both) == half_perimeter(a));
        REQUIRE(contains(grown(a, 0.1f), a));
        REQUIRE_FALSE(contains(a, grown(a, 0.1f)));
    }
}

TEST_CASE("boxes that share only an edge or a corner overlap") {
    const Aabb box{{0, 0}, {1, 1}};
    CHECK(overlap(box, {{1, 0}, {2, 1}}));
    CHECK(overlap(box, {{1, 1}, {2, 2}}));
    CHECK_FALSE(overlap(box, {{1.001f, 0}, {2, 1}}));
}

}  // namespace cairn::physics
