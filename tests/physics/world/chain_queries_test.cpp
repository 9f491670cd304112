// Queries, sensors and movers at chains: solid from the front, not there from behind, and no joins.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <cairn/physics/mover.h>

#include "physics/support/making.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using namespace test;

// Along y = 0 from x = 10 to x = -10 in steps of 20 cm: free above.
ChainId add_chain_ground(World& world) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 100; ++i) points.push_back({10 - 0.2f * static_cast<float>(i), 0});
    const BodyId body = world.create_body({.type = BodyType::Static}).value();
    return world.create_chain(body, {.points_m = points}).value();
}

}  // namespace

TEST_CASE("a shape that moves down on a chain hits it as it would hit a box, and upward it passes") {
    World chain;
    World box;
    add_chain_ground(chain);
    add(box, {.type = BodyType::Static, .position_m = {0, -1}}, Box{10, 1});
    Random random(11);
    for (int round = 0; round < 500; ++round) {
        const Geometry shapes[] = {Circle{{}, 0.3f}, Capsule{{-0.2f, 0}, {0.2f, 0.1f}, 0.1f}, Box{0.3f, 0.1f},
                                   Segment{{-0.2f, 0}, {0.3f, 0.1f}}};
        const Geometry& shape = shapes[random.below(4)];
        const Transform start{{random.real(-8, 8), random.real(0.5, 2)},
                              Rotation::from_angle(random.real(-3, 3))};
        const Vec2 way{random.real_f(-1, 1), random.real_f(-4, -0.1)};
        const auto at_chain = chain.cast_shape(shape, start, way).value();
        const auto at_box = box.cast_shape(shape, start, way).value();
        REQUIRE(at_chain.has_value() == at_box.has_value());
        const Transform below{{start.p.x, -start.p.y}, start.q};
        REQUIRE_FALSE(chain.cast_shape(shape, below, -way).value());
        if (!at_chain) continue;
        CHECK(at_chain->fraction == Approx(at_box->fraction).margin(1e-5));
        CHECK(at_chain->normal.y == Approx(1).margin(1e-6));
        CHECK(at_chain->point_m.y == Approx(0).margin(1e-4));
    }
}

TEST_CASE("a shape that glides along a chain a hair above it hits none of the joins") {
    World world;
    add_chain_ground(world);
    for (const float gap : {0.0f, 1e-6f, 1e-4f}) {
        CHECK_FALSE(world.cast_shape(Circle{{}, 0.25f}, {{-8, 0.25 + gap}, {}}, {16, 0}).value());
        CHECK_FALSE(world.cast_shape(Box{0.25f, 0.25f}, {{-8, 0.25 + gap}, {}}, {16, 0}).value());
    }
}

TEST_CASE("overlaps, nearest points and planes are those of the front of a chain") {
    World world;
    const ChainId id = add_chain_ground(world);
    const Circle disc{{}, 0.25f};
    // The middles of segments are at odd multiples of 10 cm.
    CHECK(world.shapes_overlapping(disc, {{0.1, 0.2}, {}}).value().size() == 3);
    CHECK(world.shapes_overlapping(disc, {{0.1, -0.2}, {}}).value().empty());
    CHECK(world.shapes_in_box({0.05, -0.1}, {0.15, 0.2}).value().size() == 1);
    CHECK(world.shapes_in_box({0.05, -0.2}, {0.15, 0.1}).value().empty());
    const auto nearest = world.closest_point({0.1, 0.5}, 1).value();
    REQUIRE(nearest);
    CHECK(nearest->distance_m == Approx(0.5));
    CHECK(world.shape(nearest->shape)->chain() == id);
    CHECK_FALSE(world.closest_point({0.1, -0.5}, 1).value());

    const auto planes = world.collision_planes(disc, {{0.1, 0.24}, {}}, 0.01f).value();
    REQUIRE(planes.size() == 1);
    CHECK(planes[0].normal == Vec2{0, 1});
    CHECK(planes[0].separation_m == Approx(-0.01).margin(1e-6));
    CHECK(world.collision_planes(disc, {{0.1, -0.24}, {}}, 0.01f).value().empty());
    // Over a join too, all planes are the chain's.
    for (const CollisionPlane& plane :
         world.collision_planes(Box{0.3f, 0.25f}, {{0.2, 0.24}, {}}, 0.01f).value()) {
        CHECK(plane.normal == Vec2{0, 1});
        CHECK(plane.separation_m == Approx(-0.01).margin(1e-6));
    }
}

TEST_CASE("a sensor sees a chain that is in front of it, and not one that has it behind") {
    World world;
    add_chain_ground(world);
    const auto sensor_at = [&](double y) {
        const BodyId body = add(world, {.type = BodyType::Kinematic, .position_m = {0.1, y}},
                                Circle{{}, 0.25f}, {.sensor = true});
        return world.body(body)->shapes()[0];
    };
    const ShapeId above = sensor_at(0.2);
    const ShapeId below = sensor_at(-0.2);
    world.step(kStep_s).value();
    CHECK(world.sensor_overlaps(above)->size() == 3);
    CHECK(world.sensor_overlaps(below)->empty());
}

TEST_CASE("a mover walks along a chain at the speed of its stick, down a valley and up again") {
    for (const float depth : {0.0f, 2.0f}) {
        World world;
        std::vector<Vec2> points;
        for (int i = 0; i <= 100; ++i) {
            const float x = 10 - 0.2f * static_cast<float>(i);
            points.push_back({x, depth * (x * x / 100 - 1)});
        }
        const BodyId ground = world.create_body({.type = BodyType::Static}).value();
        world.create_chain(ground, {.points_m = points}).value();
        Mover mover = Mover::create({}, {-8, depth * (0.64 - 1) + 0.3}).value();
        int in_the_air = 0;
        for (int i = 0; i < 300; ++i) {
            const Vec2 v = Vec2{3, mover.velocity().y} + kStep_s * world.gravity();
            mover.move(world, v, kStep_s).value();
            world.step(kStep_s).value();
            if (i > 30 && !mover.is_grounded()) ++in_the_air;
        }
        INFO("valley of " << depth << " m");
        CHECK(in_the_air == 0);
        CHECK(mover.position().x > 5.5);
        CHECK(mover.position().x < 7.1);
    }
}

TEST_CASE("a mover jumps through a chain from below and stands on it") {
    World world;
    add_chain_ground(world);
    add(world, {.type = BodyType::Static, .position_m = {0, -4}}, Box{10, 1});
    Mover mover = Mover::create({}, {0, -2.9}).value();
    double highest = -3;
    for (int i = 0; i < 240; ++i) {
        Vec2 v = mover.velocity() + kStep_s * world.gravity();
        if (i == 30) v = {0, 10};
        mover.move(world, v, kStep_s).value();
        world.step(kStep_s).value();
        highest = std::max(highest, mover.position().y);
    }
    CHECK(highest > 1);
    CHECK(mover.is_grounded());
    CHECK(mover.position().y == Approx(0).margin(0.02));
}

}  // namespace cairn::physics
