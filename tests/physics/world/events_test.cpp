// Contact events, against what was arranged to happen.
#include <catch2/catch.hpp>
#include <cmath>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

struct Told {
    int begins = 0;
    int ends = 0;
    int hits = 0;
};

Told tell(const World& world) {
    return {static_cast<int>(world.contact_begins().size()), static_cast<int>(world.contact_ends().size()),
            static_cast<int>(world.contact_hits().size())};
}

Told run_and_count(World& world, double time_s) {
    Told sum;
    for (int i = 0; i < static_cast<int>(std::lround(time_s * 60)); ++i) {
        world.step(kStep_s).value();
        const Told now = tell(world);
        sum.begins += now.begins;
        sum.ends += now.ends;
        sum.hits += now.hits;
    }
    return sum;
}

constexpr ShapeDef kReporting{.contact_events = true, .hit_events = true};

}  // namespace

TEST_CASE("a ball that comes to lie begins to touch once, and ends when it is lifted") {
    World world;
    const BodyId ground = add_ground(world);
    const BodyId ball = add(world, {.position_m = {0, 0.6}}, Circle{}, kReporting);
    ContactBegin begin;
    int begins = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(kStep_s).value();
        CHECK(world.contact_ends().empty());
        for (const ContactBegin& event : world.contact_begins()) {
            begin = event;
            ++begins;
        }
    }
    REQUIRE(begins == 1);
    CHECK(begin.body_a == ground);
    CHECK(begin.body_b == ball);
    CHECK(begin.shape_a == world.body(ground)->shapes()[0]);
    CHECK(begin.shape_b == world.body(ball)->shapes()[0]);
    CHECK(begin.point_m.x == Approx(0).margin(1e-3));
    CHECK(begin.point_m.y == Approx(0).margin(0.02));
    CHECK(begin.normal == Vec2{0, 1});

    world.body(ball)->set_transform({0, 3}, 0).value();
    world.step(kStep_s).value();
    REQUIRE(world.contact_ends().size() == 1);
    CHECK(world.contact_ends()[0].shape_b == begin.shape_b);
    world.step(kStep_s).value();
    CHECK(world.contact_ends().empty());
}

TEST_CASE("without the flags nothing is told, and one of the two shapes is enough") {
    for (const bool ground_reports : {false, true}) {
        World world;
        add_ground(world, ground_reports ? kReporting : ShapeDef{});
        add(world, {.position_m = {0, 2}}, Circle{});
        const Told told = run_and_count(world, 2);
        CHECK(told.begins == (ground_reports ? 1 : 0));
        CHECK(told.hits == (ground_reports ? 1 : 0));
    }
}

TEST_CASE("a hit tells the speed of approach and the impulse m v (1 + e)") {
    for (const double e : {0.0, 0.5, 1.0}) {
        for (const double height : {0.5, 2.0, 5.0}) {
            World world;
            add_ground(world);
            const BodyId ball = add(world, {.position_m = {0, 0.5 + height}}, Circle{},
                                    {.material = {.restitution = static_cast<float>(e)}, .hit_events = true});
            const double mass = static_cast<double>(world.body(ball)->mass());
            const double speed = std::sqrt(20 * height);
            while (world.contact_hits().empty()) world.step(kStep_s).value();
            const ContactHit hit = world.contact_hits()[0];
            INFO("e = " << e << ", from " << height << " m");
            // The speed is that of the start of the step in which they meet: up to g dt = 0.17 m/s less.
            CHECK(static_cast<double>(hit.approach_speed_m_s) == Approx(speed).margin(0.17));
            // In that step the weight adds up to m g dt, and the fall goes on to the end of a substep.
            CHECK(static_cast<double>(hit.impulse_ns) ==
                  Approx(mass * speed * (1 + e)).epsilon(0.01).margin(mass * 10 * (1.0 / 60 + 1.0 / 240)));
            CHECK(hit.normal == Vec2{0, 1});
            CHECK(hit.point_m.y == Approx(0).margin(0.02));
        }
    }
}

TEST_CASE("without gravity the impulse of a hit is m v (1 + e) to a part in a thousand") {
    for (const float e : {0.0f, 0.6f, 1.0f}) {
        World world({.gravity_m_s2 = {}});
        add_ground(world);
        const BodyId ball = add(world, {.position_m = {0, 2}, .linear_velocity_m_s = {0, -7}}, Circle{},
                                {.material = {.restitution = e}, .hit_events = true});
        while (world.contact_hits().empty()) world.step(kStep_s).value();
        INFO("e = " << e);
        CHECK(world.contact_hits()[0].approach_speed_m_s == Approx(7).epsilon(1e-5));
        CHECK(static_cast<double>(world.contact_hits()[0].impulse_ns) ==
              Approx(static_cast<double>(world.body(ball)->mass() * 7 * (1 + e))).epsilon(1e-3));
    }
}

TEST_CASE("hits slower than the hit speed are not told, and lying is no hit") {
    World world({.hit_speed_m_s = 3});
    add_ground(world, kReporting);
    add(world, {.position_m = {0, 0.8}}, Circle{});  // arrives with 2.4 m/s
    add(world, {.position_m = {5, 1.2}}, Circle{});  // arrives with 3.7 m/s
    const Told told = run_and_count(world, 3);
    CHECK(told.hits == 1);
    CHECK(told.begins == 2);
    CHECK(run_and_count(world, 3).hits == 0);
}

TEST_CASE("each bounce is one hit, one begin and one end") {
    World world;
    add_ground(world, kReporting);
    add(world, {.position_m = {0, 3.5}}, Circle{}, {.material = {.restitution = 1}});
    // Falls for sqrt(6 / 10) = 0.77 s, then bounces every 1.55 s: at 0.77, 2.32, 3.87, 5.42.
    const Told told = run_and_count(world, 6);
    CHECK(told.hits == 4);
    CHECK(told.begins == 4);
    CHECK(told.ends == 4);
}

TEST_CASE("the end of touching a destroyed thing is told with the next step, once") {
    World world;
    const BodyId ground = add_ground(world);
    const BodyId ball = add(world, {.position_m = {0, 0.5}}, Circle{}, kReporting);
    const ShapeId ball_shape = world.body(ball)->shapes()[0];
    run_for(world, 0.2);
    REQUIRE(world.counts().touching == 1);
    SECTION("the body") {
        world.destroy_body(ball).value();
    }
    SECTION("the shape") {
        world.destroy_shape(ball_shape).value();
    }
    SECTION("the other body") {
        world.destroy_body(ground).value();
    }
    CHECK(world.counts().contacts == 0);
    world.step(kStep_s).value();
    REQUIRE(world.contact_ends().size() == 1);
    CHECK(world.contact_ends()[0].body_a == ground);
    CHECK(world.contact_ends()[0].body_b == ball);
    CHECK(world.contact_ends()[0].shape_b == ball_shape);
    CHECK(run_and_count(world, 0.5).ends == 0);
}

TEST_CASE("touching does not end while the pair sleeps, nor begin again when it wakes") {
    World world;
    add_ground(world);
    const BodyId box = add(world, {.position_m = {0, 0.5}}, Box{0.5f, 0.5f}, kReporting);
    run_for(world, 3);
    REQUIRE_FALSE(world.body(box)->is_awake());
    CHECK(world.counts().touching == 1);
    world.body(box)->set_awake(true);
    const Told told = run_and_count(world, 3);
    CHECK(told.begins == 0);
    CHECK(told.ends == 0);
}

TEST_CASE("a body resting on the ground does not flicker between touching and not") {
    World world({.enable_sleep = false});
    add_ground(world);
    for (int i = 0; i < 5; ++i) add(world, {.position_m = {0, 0.5 + i}}, Box{0.5f, 0.5f}, kReporting);
    const Told told = run_and_count(world, 10);
    CHECK(told.begins == 5);
    CHECK(told.ends == 0);
    CHECK(told.hits == 0);
}

TEST_CASE("events of one step are gone after the next") {
    World world;
    add_ground(world, kReporting);
    add(world, {.position_m = {0, 2}}, Circle{});
    while (world.contact_hits().empty()) world.step(kStep_s).value();
    world.step(kStep_s).value();
    CHECK(world.contact_hits().empty());
    CHECK(world.contact_begins().empty());
}

}  // namespace cairn::physics
