// Ray casts against sphere tracing: marching along the ray by the distance from the shape.
#include "collide/ray_cast.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "physics/support/random_shapes.h"
#include "physics/support/rounded_hull.h"

namespace cairn::physics {
namespace {

using namespace test;

struct March {
    bool hit = false;
    double fraction = 0;
    double nearest = 0;  // least distance from the shape on the way
};

// The distance from the surface never overestimates how far one may go, so no shape is jumped over.
March march(const RoundedHull& hull, Point origin, Point translation) {
    March result{false, 0, INFINITY};
    const double whole = norm(translation);
    double travelled = 0;
    for (int i = 0; i < 100'000 && travelled <= whole; ++i) {
        const double distance = signed_distance(hull, origin + (travelled / whole) * translation);
        result.nearest = std::min(result.nearest, distance);
        if (distance < 1e-10) return {true, travelled / whole, distance};
        travelled += distance;
    }
    return result;
}

Point outward(const RoundedHull& hull, Point p) {
    constexpr double kH = 1e-6;
    const double dx = signed_distance(hull, {p.x + kH, p.y}) - signed_distance(hull, {p.x - kH, p.y});
    const double dy = signed_distance(hull, {p.x, p.y + kH}) - signed_distance(hull, {p.x, p.y - kH});
    return (1 / norm({dx, dy})) * Point{dx, dy};
}

}  // namespace

TEST_CASE("a ray meets a segment from both sides, and not past its ends") {
    const Convex segment = make_convex(Segment{{-1, 1}, {1, 1}}).value();
    const auto from_below = cast_ray(segment, {0.5f, 0}, {0, 4});
    REQUIRE(from_below);
    CHECK(from_below->fraction == 0.25f);
    CHECK(from_below->normal == Vec2{0, -1});
    const auto from_above = cast_ray(segment, {-0.5f, 2}, {0, -4});
    REQUIRE(from_above);
    CHECK(from_above->fraction == 0.25f);
    CHECK(from_above->normal == Vec2{0, 1});
    CHECK_FALSE(cast_ray(segment, {1.01f, 0}, {0, 4}));
    CHECK_FALSE(cast_ray(segment, {-2, 1}, {4, 0}));  // along it there is nothing to meet
}

TEST_CASE("a ray meets a shape where marching along it does") {
    Random random(1);
    int hits = 0;
    int misses = 0;
    for (const Form form : kForms) {
        for (int round = 0; round < 2'000; ++round) {
            const Convex shape = random_convex(random, form);
            const RoundedHull hull = rounded_hull(shape);
            const Vec2 origin = random.vector(-4, 4);
            const Vec2 translation = random.vector(-8, 8);
            if (std::fabs(signed_distance(hull, to_point(origin))) < 1e-5) continue;
            INFO("form " << static_cast<int>(form) << ", round " << round);
            const auto hit = cast_ray(shape, origin, translation);
            if (signed_distance(hull, to_point(origin)) < 0) {
                REQUIRE_FALSE(hit);  // from inside, a shape is not seen
                continue;
            }
            const March expected = march(hull, to_point(origin), to_point(translation));
            if (!expected.hit) {
                // What passes by within float rounding may count as touched.
                if (expected.nearest > 1e-5) REQUIRE_FALSE(hit);
                misses += hit ? 0 : 1;
                continue;
            }
            const Point p = to_point(origin) + expected.fraction * to_point(translation);
            const Point normal = outward(hull, p);
            const double incidence = -dot(normal, to_point(translation)) / norm(to_point(translation));
            if (incidence < 0.05) continue;  // grazing: rounding decides
            if (expected.fraction > 1 - 1e-5) continue;
            REQUIRE(hit);
            // Float places the surface to 1e-6 m; the slant stretches that along the ray.
            const double along = std::fabs(static_cast<double>(hit->fraction) - expected.fraction) *
                                 norm(to_point(translation));
            REQUIRE(along < 3e-6 / incidence);
            REQUIRE(length(hit->normal) == Approx(1).epsilon(1e-5));
            // At a sharp corner any normal between the two edges' would do.
            const Point next = p + 1e-4 * Point{-normal.y, normal.x};
            const Point before = p - 1e-4 * Point{-normal.y, normal.x};
            const bool smooth = dot(outward(hull, next), outward(hull, before)) > 0.99;
            if (smooth) REQUIRE(dot(to_point(hit->normal), normal) > 0.9999);
            ++hits;
        }
    }
    CHECK(hits > 500);
    CHECK(misses > 1000);
}

TEST_CASE("no ray slips in at the corners of a shape") {
    Random random(2);
    int rays = 0;
    for (const Form form : kForms) {
        for (int round = 0; round < 2'000; ++round) {
            const Convex shape = random_convex(random, form);
            for (int i = 0; i < shape.count() && shape.count() > 1; ++i) {
                // Where two parts of the surface meet: the beginning of the edge from this corner.
                const Vec2 joint = shape.point(i) + shape.radius() * shape.normals[i];
                const Vec2 origin = joint + random.real_f(0.5, 3) * (joint - shape.centroid);
                const Vec2 way = 2 * (shape.centroid - origin);
                const auto hit = cast_ray(shape, origin, way);
                INFO("form " << static_cast<int>(form) << ", round " << round << ", corner " << i);
                REQUIRE(hit);
                const Vec2 at = origin + hit->fraction * way;
                REQUIRE(std::fabs(signed_distance(rounded_hull(shape), to_point(at))) < 1e-5);
                ++rays;
            }
        }
    }
    CHECK(rays > 10'000);
}

TEST_CASE("no ray slips in at the tip of a needle") {
    // Both edges lost this ray by the last bit; it ended 4.7 mm deep in the shape.
    const std::array points{Vec2{-0.807843089f, -0.807843089f}, Vec2{-0.800701857f, -0.807843089f},
                            Vec2{1.29411769f, 1.29411769f}, Vec2{-0.807843089f, -0.799664259f}};
    const Convex needle = make_convex(Polygon{points}).value();
    const auto hit = cast_ray(needle, {2.58823538f, 2.58823538f}, {-3.23137236f, -3.23137236f});
    REQUIRE(hit);
    CHECK(hit->fraction == Approx(0.4005).margin(1e-4));
}

TEST_CASE("no ray slips through a chain where two segments meet") {
    Random random(3);
    for (int round = 0; round < 20'000; ++round) {
        const Vec2 a = random.vector(-3, -2);
        const Vec2 joint = random.vector(-1, 1);
        const Vec2 b = random.vector(2, 3);
        const Convex first = make_chain_segment({}, b, joint, a);  // from right to left: met from above
        const Convex second = make_chain_segment(b, joint, a, {});
        const Vec2 way{random.real_f(-0.5, 0.5), -4};
        const Vec2 origin = joint - random.real_f(0.3, 0.7) * way;
        INFO("round " << round);
        const bool meets = cast_ray(first, origin, way) || cast_ray(second, origin, way);
        REQUIRE(meets);
    }
}

TEST_CASE("a ray that stops short of a shape does not meet it") {
    const Convex disc = make_convex(Circle{{5, 0}, 1}).value();
    CHECK_FALSE(cast_ray(disc, {0, 0}, {3.9f, 0}));
    const auto hit = cast_ray(disc, {0, 0}, {8, 0});
    REQUIRE(hit);
    CHECK(hit->fraction == 0.5f);
    CHECK(hit->normal == Vec2{-1, 0});
}

TEST_CASE("a ray without length meets nothing") {
    const Convex disc = make_convex(Circle{{0, 0}, 1}).value();
    CHECK_FALSE(cast_ray(disc, {0, 0}, {}));
    CHECK_FALSE(cast_ray(disc, {3, 0}, {}));
}

TEST_CASE("a ray along the face of a box, outside of it, does not meet it") {
    const Convex box = make_convex(Box{1, 1}).value();
    CHECK_FALSE(cast_ray(box, {-3, 1.001f}, {6, 0}));
    CHECK(cast_ray(box, {-3, 0.999f}, {6, 0}));
}

TEST_CASE("a ray meets a box the same way from all four sides") {
    const Convex box = make_convex(Box{1, 1, {2, 3}}).value();
    const Vec2 directions[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    for (const Vec2 d : directions) {
        const auto hit = cast_ray(box, Vec2{2, 3} - 5 * d, 10 * d);
        REQUIRE(hit);
        CHECK(static_cast<double>(hit->fraction) == Approx(0.4));
        CHECK(hit->normal == -d);
    }
}

}  // namespace cairn::physics
