// Segments in a world: what stands on them, what they weigh, whom they do not meet.
#include <catch2/catch.hpp>

#include "physics/support/making.h"

namespace cairn::physics {

using namespace test;

TEST_CASE("every kind of shape comes to rest on a line without thickness, and sleeps") {
    const std::array<Geometry, 4> forms{Circle{{}, 0.25f}, Capsule{{-0.25f, 0}, {0.25f, 0}, 0.25f},
                                        Box{0.25f, 0.25f}, Box{0.2f, 0.2f, {}, 0, 0.05f}};
    World world;
    add(world, {.type = BodyType::Static}, Segment{{-20, 0}, {20, 0}});
    std::vector<BodyId> bodies;
    for (std::size_t i = 0; i < forms.size(); ++i)
        bodies.push_back(add(world, {.position_m = {2.0 * static_cast<double>(i), 0.5}}, forms[i]));
    run_for(world, 4);
    for (const BodyId body : bodies) {
        INFO("height " << world.body(body)->position().y);
        CHECK(world.body(body)->position().y == Approx(0.25).margin(0.001));
        CHECK_FALSE(world.body(body)->is_awake());
    }
}

TEST_CASE("a stack of ten boxes stands on a segment as on a box") {
    World world;
    add(world, {.type = BodyType::Static}, Segment{{20, 0}, {-20, 0}});
    BodyId top;
    for (int i = 0; i < 10; ++i) top = add(world, {.position_m = {0, 0.5 + i}}, Box{0.5f, 0.5f});
    run_for(world, 5);
    CHECK(world.body(top)->position().y == Approx(9.5).margin(0.01));
    CHECK(world.body(top)->position().x == Approx(0).margin(0.001));
    CHECK(world.counts().awake_bodies == 0);
}

TEST_CASE("a dynamic body of segments alone keeps its velocity until it gets a shape with mass") {
    World world;
    add_ground(world);
    const BodyId body =
        add(world, {.position_m = {0, 3}, .linear_velocity_m_s = {1, 0}}, Segment{{-1, 0}, {1, 0}});
    CHECK(world.body(body)->mass() == 0);
    run_for(world, 1);
    CHECK(world.body(body)->linear_velocity() == Vec2{1, 0});
    CHECK(world.body(body)->position().y == 3);
    world.create_shape(body, Box{0.5f, 0.5f}, {.density_kg_m2 = 2}).value();
    CHECK(world.body(body)->mass() == 2);
    run_for(world, 0.1);
    CHECK(world.body(body)->linear_velocity().y < -0.9f);
}

TEST_CASE("a frame of segments around a weight lands on its segments") {
    World world;
    add_ground(world);
    const BodyId frame = add(world, {.position_m = {0, 2}}, Circle{{}, 0.2f});
    const std::array<Vec2, 4> corners{Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}};
    for (std::size_t i = 0; i < 4; ++i)
        world.create_shape(frame, Segment{corners[i], corners[(i + 1) % 4]}).value();
    run_for(world, 3);
    CHECK(world.body(frame)->position().y == Approx(1).margin(0.01));
    CHECK_FALSE(world.body(frame)->is_awake());
}

TEST_CASE("segments of different bodies make no contact, not even as neighbours in the broad phase") {
    World world({.gravity_m_s2 = {}});
    add(world, {.type = BodyType::Static}, Segment{{-1, 0}, {1, 0}});
    const BodyId cross = add(world, {.angular_velocity_rad_s = 1}, Segment{{0, -1}, {0, 1}});
    world.create_shape(cross, Circle{{5, 5}, 0.1f}).value();
    run_for(world, 0.1);
    CHECK(world.counts().contacts == 0);
}

}  // namespace cairn::physics
