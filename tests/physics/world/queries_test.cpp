// Queries of a world against a look at every shape.
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <vector>

#include "collide/ray_cast.h"
#include "physics/support/making.h"
#include "physics/support/random_shapes.h"
#include "physics/support/rounded_hull.h"

namespace cairn::physics {
namespace {

using namespace test;

struct Placed {
    ShapeId id;
    BodyId body;
    Convex convex;
    Filter filter;
};

Geometry random_geometry(Random& random, std::array<Vec2, kMaxPolygonVertices>& points) {
    switch (random.below(4)) {
        case 0:
            return Circle{random.vector(-0.3, 0.3), random.real_f(0.1, 0.8)};
        case 1:
            return Capsule{{-0.5f, 0}, random.vector(0, 1), random.real_f(0.1, 0.4)};
        case 2:
            return Box{random.real_f(0.1, 1), random.real_f(0.1, 1), {}, random.real_f(-3, 3), 0.05f};
        default: {
            const Convex polygon = random_polygon(random, 0);
            points = polygon.outline.points_m;
            return Polygon{.points_m = std::span(points).first(polygon.count())};
        }
    }
}

// 300 shapes on static, kinematic and dynamic bodies, after some steps of motion.
struct Crowd {
    World world{{.gravity_m_s2 = {}}};
    std::vector<Placed> shapes;
    double offset;

    explicit Crowd(std::uint64_t seed, double origin = 0) : offset(origin) {
        Random random(seed);
        for (int i = 0; i < 200; ++i) {
            const BodyType types[] = {BodyType::Static, BodyType::Kinematic, BodyType::Dynamic};
            const BodyId body =
                world
                    .create_body({.type = types[random.below(3)],
                                  .position_m = {origin + random.real(-20, 20), random.real(-20, 20)},
                                  .angle_rad = random.real(-3, 3),
                                  .linear_velocity_m_s = random.vector(-2, 2),
                                  .angular_velocity_rad_s = random.real_f(-1, 1)})
                    .value();
            for (int shape = random.below(3); shape >= 0; --shape) {
                std::array<Vec2, kMaxPolygonVertices> points;
                const Geometry geometry = random_geometry(random, points);
                const Filter filter{.categories = std::uint64_t{1} << random.below(4)};
                const ShapeId id = world.create_shape(body, geometry, {.filter = filter}).value();
                shapes.push_back({id, body, make_convex(geometry).value(), filter});
            }
        }
        run_for(world, 0.5);
    }
    [[nodiscard]] Transform transform(const Placed& shape) const {
        return world.body(shape.body)->transform();
    }
};

}  // namespace

TEST_CASE("a ray through a crowd meets what it meets when every shape is asked") {
    for (const double origin : {0.0, 1e5}) {
        const Crowd crowd(1, origin);
        Random random(2);
        int hits = 0;
        for (int ray = 0; ray < 3'000; ++ray) {
            const Position from{origin + random.real(-25, 25), random.real(-25, 25)};
            const Vec2 translation = random.vector(-30, 30);
            const QueryFilter filter{.mask = random.chance(0.5) ? ~std::uint64_t{0} : random.bits() & 15};
            std::optional<double> expected;
            for (const Placed& shape : crowd.shapes) {
                if ((shape.filter.categories & filter.mask) == 0) continue;
                const Transform xf = crowd.transform(shape);
                const auto hit = cast_ray(shape.convex, inverse_transform_point(xf, from),
                                          inverse_rotate(xf.q, translation));
                if (hit && (!expected || static_cast<double>(hit->fraction) < *expected))
                    expected = static_cast<double>(hit->fraction);
            }
            const auto hit = crowd.world.cast_ray(from, translation, filter).value();
            REQUIRE(hit.has_value() == expected.has_value());
            if (!hit) continue;
            ++hits;
            REQUIRE(static_cast<double>(hit->fraction) == *expected);
            REQUIRE(crowd.world.shape(hit->shape)->body() == hit->body);
            REQUIRE(length(hit->normal) == Approx(1).epsilon(1e-5));
            REQUIRE(dot(hit->normal, translation) < 0);
            REQUIRE(length(hit->point_m - (from + hit->fraction * translation)) == 0);
        }
        CHECK(hits > 1000);
    }
}

TEST_CASE("a point in a crowd is in a shape exactly when it is so for one of all") {
    const Crowd crowd(3);
    Random random(4);
    int found = 0;
    for (int i = 0; i < 5'000; ++i) {
        const Position point{random.real(-20, 20), random.real(-20, 20)};
        bool inside = false;
        bool doubtful = false;
        for (const Placed& shape : crowd.shapes) {
            const Transform xf = crowd.transform(shape);
            const double distance =
                signed_distance(rounded_hull(shape.convex), to_point(inverse_transform_point(xf, point)));
            inside = inside || distance < 0;
            doubtful = doubtful || std::fabs(distance) < 1e-5;
        }
        if (doubtful) continue;
        const auto shape = crowd.world.shape_at(point).value();
        REQUIRE(shape.has_value() == inside);
        if (!shape) continue;
        ++found;
        REQUIRE(crowd.world.shape_at(point).value() == shape);
        REQUIRE_FALSE(crowd.world.shape_at(point, {.mask = 0}).value());
    }
    CHECK(found > 500);
}

TEST_CASE("a ray that starts in a shape sees only the others") {
    World world({.gravity_m_s2 = {}});
    add(world, {}, Circle{{}, 1});
    const BodyId other = add(world, {.position_m = {5, 0}}, Circle{{}, 1});
    const auto hit = world.cast_ray({0, 0}, {10, 0}).value();
    REQUIRE(hit);
    CHECK(hit->body == other);
    CHECK(hit->fraction == Approx(0.4));
}

TEST_CASE("of two shapes at the same distance the one made first is met") {
    World world({.gravity_m_s2 = {}});
    const BodyId first = add(world, {.position_m = {5, 0}}, Circle{{}, 1});
    add(world, {.type = BodyType::Static, .position_m = {5, 0}}, Circle{{}, 1});
    CHECK(world.cast_ray({0, 0}, {10, 0}).value()->body == first);
}

TEST_CASE("a query filter with categories sees only shapes whose masks meet them") {
    World world;
    add(world, {.type = BodyType::Static}, Circle{}, {.filter = {.categories = 1, .mask = 2}});
    CHECK(world.shape_at({0, 0}, {.categories = 2}).value());
    CHECK_FALSE(world.shape_at({0, 0}, {.categories = 4}).value());
    CHECK(world.cast_ray({-5, 0}, {10, 0}, {.categories = 2}).value());
    CHECK_FALSE(world.cast_ray({-5, 0}, {10, 0}, {.categories = 4}).value());
}

TEST_CASE("queries see bodies where they were teleported, and not where they were") {
    World world;
    const BodyId body = add(world, {}, Circle{});
    world.body(body)->set_transform({50, 0}, 0).value();
    CHECK(world.shape_at({50, 0}).value());
    CHECK_FALSE(world.shape_at({0, 0}).value());
    world.destroy_body(body).value();
    CHECK_FALSE(world.shape_at({50, 0}).value());
}

}  // namespace cairn::physics
