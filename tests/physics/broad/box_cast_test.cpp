// Segments and moved boxes against boxes.
#include "broad/box_cast.h"

#include <catch2/catch.hpp>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using test::Random;

Aabb random_box(Random& random) {
    const Vec2 lower = random.vector(-5, 5);
    const float width = random.real_f(0, 4);
    return {lower, lower + Vec2{width, random.real_f(0, 4)}};
}

}  // namespace

TEST_CASE("a segment meets a box exactly when one of many points on it lies in the box") {
    Random random(3);
    int met = 0;
    for (int i = 0; i < 5'000; ++i) {
        const Aabb box = random_box(random);
        const Position origin{random.real(-8, 8), random.real(-8, 8)};
        const Vec2 translation = random.chance(0.1)   ? Vec2{random.real_f(-9, 9), 0}
                                 : random.chance(0.1) ? Vec2{0, random.real_f(-9, 9)}
                                                      : random.vector(-9, 9);
        const float fraction = random.real_f(0.1, 1);
        const BoxCast cast(origin, {}, translation);
        bool sampled = false;
        // The samples are 9 sqrt(2) / 2000 = 6 mm apart: a sample in the box proves a meeting, and a box
        // grown by that spacing which no sample enters proves that there is none.
        bool near = false;
        for (int k = 0; k <= 2000; ++k) {
            const double t = static_cast<double>(fraction) * k / 2000;
            const Vec2 p{static_cast<float>(origin.x + t * static_cast<double>(translation.x)),
                         static_cast<float>(origin.y + t * static_cast<double>(translation.y))};
            sampled = sampled || contains(grown(box, -1e-5f), Aabb{p, p});
            near = near || contains(grown(box, 0.007f), Aabb{p, p});
        }
        const bool meets = cast.enter(box) <= static_cast<double>(fraction);
        if (meets) REQUIRE(overlap(cast.bounds(fraction), box));
        if (sampled) REQUIRE(meets);
        if (!near) REQUIRE_FALSE(meets);
        met += meets ? 1 : 0;
    }
    CHECK(met > 100);
}

TEST_CASE("a segment without length meets the boxes that hold its point") {
    const BoxCast point({0.5, 0.5}, {}, {});
    CHECK(point.enter({{0, 0}, {1, 1}}) == 0);
    CHECK(point.enter({{1, 0}, {2, 1}}) > 1);
}

TEST_CASE("a moved box meets what its centre meets when the other is grown by its half extents") {
    Random random(4);
    int met = 0;
    for (int i = 0; i < 5'000; ++i) {
        const Aabb box = random_box(random);
        const Position center{random.real(-8, 8), random.real(-8, 8)};
        const Vec2 half = random.vector(0, 2);
        const Vec2 translation = random.vector(-9, 9);
        const double expected = BoxCast(center, {}, translation).enter({box.lower - half, box.upper + half});
        const double found = BoxCast(center, half, translation).enter(box);
        if (expected > 1) {
            // Touching within the rounding of float is as good as a miss.
            REQUIRE((found > 1 || BoxCast(center, half - Vec2{1e-5f, 1e-5f}, translation).enter(box) > 1));
            continue;
        }
        ++met;
        REQUIRE(found == Approx(expected).margin(1e-5));
    }
    CHECK(met > 500);
}

TEST_CASE("a segment far from the origin meets a box to within a unit of float there") {
    // Floats are 1 m apart at 1e7 m; the box of a point there is rounded outward to at most that.
    const Position origin{1e7 + 0.25, 1e7 + 0.25};
    const BoxCast cast(origin, {}, {4, 0});
    CHECK(cast.enter(make_aabb({1e7 + 2.5, 1e7 + 0.25}, {}, {})) == Approx(1.75 / 4));
    CHECK(cast.enter(make_aabb({1e7 + 2.5, 1e7 + 3.5}, {}, {})) > 1);
    CHECK(overlap(cast.bounds(1), make_aabb(origin, {}, {})));
}

}  // namespace cairn::physics
