// Queries of a world against a look at every shape.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <optional>
#include <thread>
#include <vector>

#include "collide/ray_cast.h"
#include "collide/shape_cast.h"
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
    // In a frame with the world's axes, whose origin is the given place.
    [[nodiscard]] RoundedHull hull_about(const Placed& shape, Position about) const {
        const Transform xf = transform(shape);
        return rounded_hull(shape.convex, {xf.p - about, xf.q});
    }
};

struct Probe {
    std::array<Vec2, kMaxPolygonVertices> points{};
    Geometry geometry;
    Convex convex;
    Transform pose;

    Probe(Random& random, double origin)
        : geometry(random_geometry(random, points)),
          convex(make_convex(geometry).value()),
          pose{{origin + random.real(-22, 22), random.real(-22, 22)},
               Rotation::from_angle(random.real(-3, 3))} {}
    Probe(const Probe&) = delete;
    Probe& operator=(const Probe&) = delete;
};

std::vector<ShapeId> ordered(std::vector<ShapeId> shapes) {
    std::sort(shapes.begin(), shapes.end(), [](ShapeId a, ShapeId b) { return a.index1 < b.index1; });
    return shapes;
}

// All that a query can answer, to compare as a whole.
struct Answers {
    std::vector<double> numbers;
    std::vector<std::uint64_t> shapes;

    template <class Hit>
    void take(const Hit& hit, float number) {
        numbers.push_back(static_cast<double>(number));
        shapes.push_back(hit.shape.bits());
    }
    friend bool operator==(const Answers&, const Answers&) = default;
};

Answers ask_everything(const World& world, std::uint64_t seed) {
    Random random(seed);
    Answers answers;
    for (int i = 0; i < 200; ++i) {
        const Probe probe(random, 0);
        const Vec2 translation = random.vector(-20, 20);
        const auto is_odd = [](ShapeId shape, BodyId) { return shape.index1 % 2 == 1; };
        const QueryFilter filter = i % 2 == 0 ? QueryFilter{} : QueryFilter{.accepts = is_odd};
        if (const auto hit = world.cast_ray(probe.pose.p, translation, filter).value())
            answers.take(*hit, hit->fraction);
        for (const RayHit& hit : world.cast_ray_all(probe.pose.p, translation, filter).value())
            answers.take(hit, hit.fraction);
        if (const auto hit = world.cast_shape(probe.geometry, probe.pose, translation, filter).value())
            answers.take(*hit, hit->fraction);
        for (const ShapeHit& hit :
             world.cast_shape_all(probe.geometry, probe.pose, translation, filter).value()) {
            answers.take(hit, hit.fraction);
        }
        for (const SurfacePoint& point : world.closest_points(probe.pose.p, 3, filter).value())
            answers.take(point, point.distance_m);
        for (const CollisionPlane& plane :
             world.collision_planes(probe.geometry, probe.pose, 1, filter).value()) {
            answers.take(plane, plane.separation_m);
        }
        for (const ShapeId shape : world.shapes_overlapping(probe.geometry, probe.pose, filter).value())
            answers.shapes.push_back(shape.bits());
        for (const ShapeId shape :
             world.shapes_in_box(probe.pose.p, probe.pose.p + Vec2{3, 2}, filter).value()) {
            answers.shapes.push_back(shape.bits());
        }
        if (const auto shape = world.shape_at(probe.pose.p, filter).value())
            answers.shapes.push_back(shape->bits());
    }
    return answers;
}

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

TEST_CASE("a ray through a crowd meets each shape that it meets alone, nearest first") {
    const Crowd crowd(5);
    Random random(6);
    std::size_t most = 0;
    for (int ray = 0; ray < 1'000; ++ray) {
        const Position from{random.real(-25, 25), random.real(-25, 25)};
        const Vec2 translation = random.vector(-40, 40);
        std::map<std::uint64_t, float> expected;
        for (const Placed& shape : crowd.shapes) {
            const Transform xf = crowd.transform(shape);
            const auto hit =
                cast_ray(shape.convex, inverse_transform_point(xf, from), inverse_rotate(xf.q, translation));
            if (hit) expected[shape.id.bits()] = hit->fraction;
        }
        const std::vector<RayHit> hits = crowd.world.cast_ray_all(from, translation).value();
        REQUIRE(hits.size() == expected.size());
        most = std::max(most, hits.size());
        for (std::size_t i = 0; i < hits.size(); ++i) {
            REQUIRE(hits[i].fraction == expected.at(hits[i].shape.bits()));
            if (i > 0) REQUIRE(hits[i - 1].fraction <= hits[i].fraction);
        }
        const auto first = crowd.world.cast_ray(from, translation).value();
        REQUIRE(first.has_value() == !hits.empty());
        if (first) REQUIRE(first->shape == hits.front().shape);
    }
    CHECK(most > 10);
}

TEST_CASE("a shape that moves through a crowd meets each shape that it meets alone, nearest first") {
    for (const double origin : {0.0, 1e7}) {
        const Crowd crowd(7, origin);
        Random random(8);
        std::size_t found = 0;
        for (int cast = 0; cast < 500; ++cast) {
            const Probe probe(random, origin);
            const Vec2 translation = (cast % 5 == 0 ? 20.0f : 1.0f) * random.vector(-10, 10);
            std::map<std::uint64_t, float> expected;
            for (const Placed& shape : crowd.shapes) {
                const Transform xf = crowd.transform(shape);
                const RelativePose pose{inverse_transform_point(xf, probe.pose.p),
                                        inverse(xf.q) * probe.pose.q};
                const auto hit =
                    cast_shape(shape.convex, probe.convex, pose, inverse_rotate(xf.q, translation));
                if (hit) expected[shape.id.bits()] = hit->fraction;
            }
            const auto hits = crowd.world.cast_shape_all(probe.geometry, probe.pose, translation).value();
            REQUIRE(hits.size() == expected.size());
            found += hits.size();
            for (std::size_t i = 0; i < hits.size(); ++i) {
                REQUIRE(hits[i].fraction == expected.at(hits[i].shape.bits()));
                REQUIRE(crowd.world.shape(hits[i].shape)->body() == hits[i].body);
                if (i > 0) REQUIRE(hits[i - 1].fraction <= hits[i].fraction);
            }
            const auto first = crowd.world.cast_shape(probe.geometry, probe.pose, translation).value();
            REQUIRE(first.has_value() == !hits.empty());
            if (first) REQUIRE(first->shape == hits.front().shape);
        }
        CHECK(found > 1000);
    }
}

TEST_CASE("a cast far from the origin hits where it does at the origin") {
    for (const double origin : {0.0, 1e7}) {
        World world;
        add(world, {.type = BodyType::Static, .position_m = {origin, 0}, .angle_rad = 0.5},
            Box{1, 1, {}, 0, 0.1f});
        const Transform start{{origin + 5.123, 0.3}, {}};
        const auto hit = world.cast_shape(Circle{{}, 0.3f}, start, {-10, 0}).value();
        REQUIRE(hit);
        World home;
        add(home, {.type = BodyType::Static, .angle_rad = 0.5}, Box{1, 1, {}, 0, 0.1f});
        const auto expected = home.cast_shape(Circle{{}, 0.3f}, {{5.123, 0.3}, {}}, {-10, 0}).value();
        CHECK(static_cast<double>(hit->fraction) ==
              Approx(static_cast<double>(expected->fraction)).margin(1e-6));
        CHECK(hit->point_m.x - origin == Approx(expected->point_m.x).margin(1e-5));
        CHECK(hit->point_m.y == Approx(expected->point_m.y).margin(1e-5));
    }
}

TEST_CASE("what a shape overlaps in a crowd is what it overlaps pair by pair") {
    for (const double origin : {0.0, 1e7}) {
        const Crowd crowd(9, origin);
        Random random(10);
        std::size_t found = 0;
        for (int i = 0; i < 1'000; ++i) {
            const Probe probe(random, origin);
            const RoundedHull hull = rounded_hull(probe.convex, {{}, probe.pose.q});
            std::vector<ShapeId> expected;
            bool doubtful = false;
            for (const Placed& shape : crowd.shapes) {
                const double distance = separation(crowd.hull_about(shape, probe.pose.p), hull).distance;
                if (distance < 0) expected.push_back(shape.id);
                doubtful = doubtful || std::fabs(distance) < 2e-5;
            }
            if (doubtful) continue;
            found += expected.size();
            REQUIRE(crowd.world.shapes_overlapping(probe.geometry, probe.pose).value() == ordered(expected));
        }
        CHECK(found > 500);
    }
}

TEST_CASE("what is in a box is what a box-shaped body would overlap, however large the box") {
    for (const double origin : {0.0, 1e7}) {
        const Crowd crowd(11, origin);
        Random random(12);
        std::size_t found = 0;
        for (int i = 0; i < 1'000; ++i) {
            const Position lower{origin + random.real(-25, 20), random.real(-25, 20)};
            const Vec2 size = random.vector(0, i % 10 == 0 ? 40 : 3);
            const Position upper = lower + size;
            const Vec2 width{static_cast<float>(upper.x - lower.x), static_cast<float>(upper.y - lower.y)};
            const RoundedHull box{{{0, 0}, to_point({width.x, 0}), to_point(width), to_point({0, width.y})},
                                  0};
            std::vector<ShapeId> expected;
            bool doubtful = false;
            for (const Placed& shape : crowd.shapes) {
                const double distance = separation(crowd.hull_about(shape, lower), box).distance;
                if (distance < 0) expected.push_back(shape.id);
                doubtful = doubtful || std::fabs(distance) < 2e-5;
            }
            if (doubtful) continue;
            found += expected.size();
            REQUIRE(crowd.world.shapes_in_box(lower, upper).value() == ordered(expected));
        }
        CHECK(found > 500);
        CHECK(crowd.world.shapes_in_box({-1e12, -1e12}, {1e12, 1e12}).value().size() == crowd.shapes.size());
    }
}

TEST_CASE("a box without width or height meets what the line or point meets") {
    World world;
    add(world, {.type = BodyType::Static}, Circle{{}, 1});
    CHECK(world.shapes_in_box({-3, 0.5}, {3, 0.5}).value().size() == 1);
    CHECK(world.shapes_in_box({0.5, -3}, {0.5, 3}).value().size() == 1);
    CHECK(world.shapes_in_box({0.6, 0.6}, {0.6, 0.6}).value().size() == 1);
    CHECK(world.shapes_in_box({0.8, 0.8}, {0.8, 0.8}).value().empty());
    CHECK(world.shapes_in_box({0.8, 0.8}, {2, 2}).value().empty());
}

TEST_CASE("the closest point in a crowd is that of the nearest shape") {
    for (const double origin : {0.0, 1e7}) {
        const Crowd crowd(13, origin);
        Random random(14);
        std::size_t found = 0;
        for (int i = 0; i < 1'000; ++i) {
            const Position from{origin + random.real(-25, 25), random.real(-25, 25)};
            const double radius = random.real(0.1, 3);
            double nearest = radius;
            std::size_t within = 0;
            bool doubtful = false;
            for (const Placed& shape : crowd.shapes) {
                const double distance = signed_distance(crowd.hull_about(shape, from), {});
                nearest = std::min(nearest, distance);
                within += distance <= radius ? 1 : 0;
                doubtful = doubtful || std::fabs(distance - radius) < 2e-5;
            }
            if (doubtful) continue;
            const auto points = crowd.world.closest_points(from, static_cast<float>(radius)).value();
            REQUIRE(points.size() == within);
            found += within;
            const auto closest = crowd.world.closest_point(from, static_cast<float>(radius)).value();
            REQUIRE(closest.has_value() == (within > 0));
            if (!closest) continue;
            REQUIRE(closest->shape == points.front().shape);
            REQUIRE(static_cast<double>(closest->distance_m) == Approx(nearest).margin(1e-5).epsilon(0));
            // From the surface, along the normal, by the distance: back where the question was asked.
            const Vec2 back = closest->point_m + closest->distance_m * closest->normal - from;
            REQUIRE(length(back) < 2e-3f);
        }
        CHECK(found > 500);
    }
}

TEST_CASE("the closest point of a disc, and of a box from inside, is where the formula says") {
    World world;
    const BodyId disc = add(world, {.type = BodyType::Static, .position_m = {10, 0}}, Circle{{}, 2});
    add(world, {.type = BodyType::Static}, Box{1, 2});
    const auto outside = world.closest_point({7, 4}, 10, {.mask = 1}).value();
    REQUIRE(outside);
    CHECK(outside->body == disc);
    CHECK(outside->distance_m == 3);
    CHECK(outside->normal.x == -0.6f);
    CHECK(outside->normal.y == 0.8f);
    CHECK(outside->point_m.x == Approx(8.8));
    CHECK(outside->point_m.y == Approx(1.6));
    const auto inside = world.closest_point({0.75, 0.5}, 0).value();
    REQUIRE(inside);
    CHECK(inside->distance_m == -0.25f);
    CHECK(inside->normal == Vec2{1, 0});
    CHECK(inside->point_m == Position{1, 0.5});
    CHECK_FALSE(world.closest_point({5, 0}, 2.5f).value());
}

TEST_CASE("a shape stays clear of another as long as it stays in front of the plane between them") {
    const Crowd crowd(15);
    Random random(16);
    int planes_seen = 0;
    for (int i = 0; i < 500; ++i) {
        const Probe probe(random, 0);
        const auto planes = crowd.world.collision_planes(probe.geometry, probe.pose, 1).value();
        for (const CollisionPlane& plane : planes) {
            if (plane.separation_m < 0.01f) continue;
            ++planes_seen;
            // Anywhere along the plane, at the least clearance, by up to 3 m.
            const Vec2 move =
                (0.005f - plane.separation_m) * plane.normal + random.real_f(-3, 3) * left_perp(plane.normal);
            const Transform there{probe.pose.p + move, probe.pose.q};
            const auto overlapping = crowd.world.shapes_overlapping(probe.geometry, there).value();
            REQUIRE(std::count(overlapping.begin(), overlapping.end(), plane.shape) == 0);
        }
    }
    CHECK(planes_seen > 200);
}

TEST_CASE("a collision plane tells the edges that meet at a corner") {
    World world;
    add(world, {.type = BodyType::Static}, Box{1, 1});
    const Capsule rod{{0, 0}, {0, 1}, 0.25f};
    const auto corner = world.collision_planes(rod, {{-1.2, 1.2}, {}}, 1).value();
    REQUIRE(corner.size() == 1);
    CHECK(corner[0].normal_before == Vec2{0, 1});
    CHECK(corner[0].normal_after == Vec2{-1, 0});
    CHECK(corner[0].point_m == Position{-1, 1});
    CHECK_FALSE(corner[0].is_dynamic);
    const auto face = world.collision_planes(rod, {{-2, 0}, {}}, 1).value();
    REQUIRE(face.size() == 1);
    CHECK(face[0].normal == Vec2{-1, 0});
    CHECK(face[0].normal_before == Vec2{-1, 0});
    CHECK(face[0].normal_after == Vec2{-1, 0});
    CHECK(face[0].separation_m == 0.75f);
}

TEST_CASE("a query ignores the body it is told to, and asks the host about the others") {
    World world({.gravity_m_s2 = {}});
    const BodyId near = add(world, {.position_m = {2, 0}}, Circle{});
    const BodyId middle = add(world, {.position_m = {4, 0}}, Circle{});
    const BodyId far = add(world, {.position_m = {6, 0}}, Circle{});
    CHECK(world.cast_ray({0, 0}, {10, 0}, {.ignored_body = near}).value()->body == middle);
    const auto is_far = [&](ShapeId shape, BodyId body) { return world.contains(shape) && body == far; };
    CHECK(world.cast_ray({0, 0}, {10, 0}, {.accepts = is_far}).value()->body == far);
    CHECK(world.cast_ray_all({0, 0}, {10, 0}, {.ignored_body = middle}).value().size() == 2);
    const Transform start{};
    CHECK(world.cast_shape(Circle{}, start, {10, 0}, {.ignored_body = near}).value()->body == middle);
    CHECK(world.shapes_in_box({0, -1}, {10, 1}, {.accepts = is_far}).value().size() == 1);
    CHECK(world.closest_point({0, 0}, 10, {.ignored_body = near}).value()->body == middle);
    CHECK_FALSE(world.shape_at({2, 0}, {.ignored_body = near}).value());
}

TEST_CASE("queries see static, sleeping and moving bodies") {
    World world;
    add(world, {.type = BodyType::Static, .position_m = {0, 0}}, Circle{});
    add(world, {.type = BodyType::Kinematic, .position_m = {3, 0}}, Circle{});
    add(world, {.position_m = {6, 0}, .awake = false}, Circle{});
    add(world, {.position_m = {9, 0}}, Circle{});
    CHECK(world.cast_ray_all({-5, 0}, {20, 0}).value().size() == 4);
    CHECK(world.cast_shape_all(Circle{{}, 0.1f}, {{-5, 0}, {}}, {20, 0}).value().size() == 4);
    CHECK(world.shapes_in_box({-1, -1}, {10, 1}).value().size() == 4);
}

TEST_CASE("four threads that ask at once get the answers that one alone gets") {
    const Crowd crowd(17);
    const Answers expected[] = {ask_everything(crowd.world, 1), ask_everything(crowd.world, 2)};
    CHECK(expected[0].numbers.size() > 1000);
    std::array<Answers, 4> answers;
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        threads.emplace_back([&, i] { answers[i] = ask_everything(crowd.world, 1 + i % 2); });
    }
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < answers.size(); ++i) CHECK(answers[i] == expected[i % 2]);
}

}  // namespace cairn::physics
