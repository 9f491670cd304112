// The plane solver against a search of all candidates: the wish, its feet on the planes, and their crossings.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <vector>

#include <cairn/physics/mover.h>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr float kGap_m = 0.005f;

CollisionPlane plane(Vec2 normal, float separation, bool is_dynamic = false) {
    CollisionPlane result;
    result.normal = normal;
    result.separation_m = separation;
    result.is_dynamic = is_dynamic;
    return result;
}

float worst_violation(Vec2 x, const std::vector<CollisionPlane>& planes) {
    float worst = 0;
    for (const CollisionPlane& p : planes)
        worst = std::max(worst, kGap_m - p.separation_m - dot(p.normal, x));
    return worst;
}

std::optional<float> least_distance_by_search(Vec2 wish, const std::vector<CollisionPlane>& planes) {
    std::vector<Vec2> candidates{wish};
    for (const CollisionPlane& a : planes) {
        const float least_a = kGap_m - a.separation_m;
        candidates.push_back(wish + (least_a - dot(a.normal, wish)) * a.normal);
        for (const CollisionPlane& b : planes) {
            const float area = cross(a.normal, b.normal);
            if (std::fabs(area) < 1e-4f) continue;
            const float least_b = kGap_m - b.separation_m;
            candidates.push_back((1 / area) * Vec2{least_a * b.normal.y - least_b * a.normal.y,
                                                   least_b * a.normal.x - least_a * b.normal.x});
        }
    }
    std::optional<float> best;
    for (const Vec2 x : candidates) {
        if (worst_violation(x, planes) > 1e-4f) continue;
        if (!best || length(x - wish) < *best) best = length(x - wish);
    }
    return best;
}

}  // namespace

TEST_CASE("the solved translation is the nearest one that all planes allow") {
    Random random(1);
    int solvable = 0;
    for (int round = 0; round < 20'000; ++round) {
        std::vector<CollisionPlane> planes;
        for (int i = random.below(6); i >= 0; --i) {
            const Rotation q = Rotation::from_angle(random.real(-kPi, kPi));
            planes.push_back(plane({q.c, q.s}, random.real_f(-0.1, 0.5)));
        }
        const Vec2 wish = random.vector(-2, 2);
        const auto expected = least_distance_by_search(wish, planes);
        if (!expected) continue;
        ++solvable;
        const Vec2 found = solve_planes(wish, planes, kGap_m);
        REQUIRE(worst_violation(found, planes) < 2e-4f);
        REQUIRE(length(found - wish) < *expected + 2e-3f);
    }
    CHECK(solvable > 10'000);
}

TEST_CASE("between planes that leave no room the overlap is shared") {
    const std::vector<CollisionPlane> vice{plane({1, 0}, -0.3f), plane({-1, 0}, -0.1f)};
    const Vec2 found = solve_planes({0, 1}, vice, 0);
    CHECK(found.x == Approx(0.1f).margin(1e-4));
    CHECK(found.y == 1);
}

TEST_CASE("a dynamic body yields where a wall does not") {
    const std::vector<CollisionPlane> vice{plane({1, 0}, -0.3f, true), plane({-1, 0}, -0.1f)};
    CHECK(solve_planes({0, 1}, vice, 0).x == Approx(-0.1f).margin(1e-4));
}

TEST_CASE("without planes every translation is allowed") {
    CHECK(solve_planes({3, -4}, {}, kGap_m) == Vec2{3, -4});
}

}  // namespace cairn::physics
