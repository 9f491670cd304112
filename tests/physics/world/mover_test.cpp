// A walking character: slopes, steps, platforms, corners and crates.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <cairn/physics/mover.h>

#include "physics/support/making.h"
#include "physics/support/random_shapes.h"
#include "physics/support/rounded_hull.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr float kDegree = kPi / 180;

Mover make_mover(Position position, MoverDef def = {}) {
    return Mover::create(def, position).value();
}

// As a game would: gravity in the air and on the ground, a stick that sets the speed.
void update(Mover& mover, World& world, float stick_m_s, float jump_m_s = 0) {
    const Vec2 up = mover.def().up;
    Vec2 v = dot(mover.velocity() + kStep_s * world.gravity(), up) * up + stick_m_s * right_perp(up);
    if (jump_m_s > 0 && mover.is_grounded()) v = stick_m_s * right_perp(up) + jump_m_s * up;
    mover.move(world, v, kStep_s).value();
    world.step(kStep_s).value();
}

void walk_for(Mover& mover, World& world, double time_s, float stick_m_s) {
    const long updates = std::lround(time_s / static_cast<double>(kStep_s));
    for (long i = 0; i < updates; ++i) update(mover, world, stick_m_s);
}

// Rises to the right from (0, 0), 20 m long.
void add_ramp(World& world, float angle_rad) {
    const Rotation q = Rotation::from_angle(static_cast<double>(angle_rad));
    const std::array<Vec2, 3> points{Vec2{0, 0}, Vec2{20 * q.c, 0}, Vec2{20 * q.c, 20 * q.s}};
    add(world, {.type = BodyType::Static}, Polygon{.points_m = points});
}

// Ten steps from x = 0 on; returns the height of the top.
double add_stairs(World& world, double height_m, double depth_m) {
    for (int i = 0; i < 10; ++i) {
        const double top = height_m * (i + 1);
        const double length = i < 9 ? depth_m : 20;
        add(world, {.type = BodyType::Static, .position_m = {depth_m * i + length / 2, top / 2}},
            Box{static_cast<float>(length / 2), static_cast<float>(top / 2)});
    }
    return height_m * 10;
}

}  // namespace

TEST_CASE("a mover falls, lands, stands and does not drift") {
    World world;
    add_ground(world);
    Mover mover = make_mover({1, 3});
    int updates = 0;
    while (!mover.is_grounded() && updates < 200) {
        update(mover, world, 0);
        ++updates;
    }
    // sqrt(2 * 3 / 10) s, and steps of the symplectic Euler kind.
    CHECK(updates * static_cast<double>(kStep_s) == Approx(0.775).margin(0.04));
    CHECK(mover.ground_normal() == Vec2{0, 1});
    CHECK(mover.velocity() == Vec2{});
    CHECK(world.body(mover.ground_body())->type() == BodyType::Static);
    const Position landed = mover.position();
    CHECK(landed.y == Approx(0.005).margin(1e-4));
    walk_for(mover, world, 10, 0);
    CHECK(mover.position().x == landed.x);
    CHECK(mover.position().y == Approx(landed.y).margin(1e-5));
}

TEST_CASE("a mover jumps as high as its speed carries it") {
    World world;
    add_ground(world);
    Mover mover = make_mover({0, 0.005});
    update(mover, world, 0);
    REQUIRE(mover.is_grounded());
    update(mover, world, 0, 6);
    CHECK_FALSE(mover.is_grounded());
    double highest = 0;
    for (int i = 0; i < 100 && !mover.is_grounded(); ++i) {
        highest = std::max(highest, mover.position().y);
        update(mover, world, 0);
    }
    // v^2 / 2 g, and half a step of the start speed.
    CHECK(highest == Approx(1.8 + 0.05).margin(0.02));
    CHECK(mover.is_grounded());
}

TEST_CASE("a mover walks up a slope of 40 degrees, and not one of 60, when the limit is 50") {
    const MoverDef def{.max_slope_rad = 50 * kDegree};
    {
        World world;
        add_ground(world);
        add_ramp(world, 40 * kDegree);
        Mover mover = make_mover({-2, 0.01}, def);
        walk_for(mover, world, 3, 3);
        CHECK(mover.is_grounded());
        CHECK(dot(mover.ground_normal(), {0, 1}) == Approx(std::cos(40 * kDegree)));
        // 2 m of floor and the rest along the slope, at the speed that was asked for.
        CHECK(mover.position().x == Approx(7 * std::cos(40 * kDegree)).margin(0.3));
        CHECK(static_cast<double>(mover.velocity().x) == Approx(3));
    }
    {
        World world;
        add_ground(world);
        add_ramp(world, 60 * kDegree);
        Mover mover = make_mover({-2, 0.01}, def);
        double highest = 0;
        for (int i = 0; i < 600; ++i) {
            update(mover, world, 3, i % 40 == 0 && i > 300 ? 4.0f : 0.0f);  // jumping does not help
            if (i < 300) highest = std::max(highest, mover.position().y);
        }
        CHECK(highest < 0.02);
        CHECK(mover.position().x < 0.5);
    }
}

TEST_CASE("a mover that is put on too steep a slope slides down") {
    World world;
    add_ground(world);
    add_ramp(world, 60 * kDegree);
    Mover mover = make_mover({4, 9}, {.max_slope_rad = 50 * kDegree});
    walk_for(mover, world, 4, 0);
    CHECK(mover.is_grounded());
    CHECK(mover.position().y < 0.02);
}

TEST_CASE("a mover stands in a notch of two slopes that are too steep, and jumps out of it") {
    for (const float degrees : {55.0f, 60.0f, 80.0f}) {
        CAPTURE(degrees);
        World world;
        const Rotation q = Rotation::from_angle(static_cast<double>(degrees * kDegree));
        for (const float side : {-1.0f, 1.0f}) {
            const std::array<Vec2, 3> slope{Vec2{0, 0}, Vec2{side * 2 * q.c, 2 * q.s}, Vec2{side * 2, -1}};
            add(world, {.type = BodyType::Static}, Polygon{.points_m = slope});
        }
        Mover mover = make_mover({0.1, 4});
        walk_for(mover, world, 5, 0);
        CHECK(mover.is_grounded());
        CHECK(length(mover.velocity()) < 0.01f);
        const Position before = mover.position();
        CHECK(std::fabs(before.x) < 0.01);
        walk_for(mover, world, 1, 5);
        CHECK(length(mover.position() - before) < 0.05f);
        update(mover, world, 0, 7);
        for (int i = 0; i < 120; ++i) update(mover, world, 5);
        CHECK(mover.position().x > 2);
    }
}

TEST_CASE("a mover climbs stairs of 20 cm at any speed, and comes down without leaving the ground") {
    for (const float speed : {0.3f, 2.0f, 6.0f}) {
        INFO("speed " << speed);
        World world;
        add_ground(world);
        const double top = add_stairs(world, 0.2, 0.3);
        Mover mover = make_mover({-0.5, 0.01});
        const double time = 4.5 / static_cast<double>(speed);
        walk_for(mover, world, time, speed);
        CHECK(mover.position().y == Approx(top + 0.005).margin(1e-3));
        CHECK(mover.position().x == Approx(4.0).margin(0.2));
        // And back down.
        bool stayed = true;
        for (int i = 0; i < static_cast<int>(time * 60) + 20; ++i) {
            update(mover, world, -speed);
            stayed = stayed && mover.is_grounded();
        }
        CHECK(mover.position().y == Approx(0.005).margin(1e-3));
        if (speed <= 2) CHECK(stayed);
    }
}

TEST_CASE("a step higher than the limit is a wall") {
    World world;
    add_ground(world);
    add_stairs(world, 0.4, 1);
    Mover mover = make_mover({-1, 0.01}, {.step_height_m = 0.25f});
    walk_for(mover, world, 3, 2);
    CHECK(mover.position().y < 0.02);
    CHECK(mover.position().x == Approx(-0.305).margin(1e-3));
    CHECK(mover.velocity() == Vec2{});
}

TEST_CASE("a mover that is idle on the edge of a ledge falls off when only its side is on it") {
    World world;
    add_ground(world);
    add(world, {.type = BodyType::Static, .position_m = {5, 1}}, Box{5, 1});
    Mover mover = make_mover({-0.28, 2.2});
    walk_for(mover, world, 2, 0);
    CHECK(mover.position().y == Approx(0.005).margin(1e-3));
}

TEST_CASE("a mover rides on platforms that move, rise and turn") {
    World world;
    const BodyId platform =
        add(world, {.type = BodyType::Kinematic, .linear_velocity_m_s = {2, 0.5f}}, Box{2, 0.25f});
    Mover mover = make_mover({0.5, 0.26});
    walk_for(mover, world, 0.1, 0);
    REQUIRE(mover.is_grounded());
    const Vec2 place = mover.position() - world.body(platform)->position();
    walk_for(mover, world, 5, 0);
    CHECK(mover.ground_body() == platform);
    const Vec2 later = mover.position() - world.body(platform)->position();
    CHECK(length(later - place) < 1e-3f);
    CHECK(mover.velocity() == Vec2{});

    // It goes down, and to the other side.
    world.body(platform)->set_linear_velocity({-3, -2}).value();
    walk_for(mover, world, 2, 0);
    CHECK(mover.is_grounded());
    // What the platform does in a step, the mover does in the update after it: the change of velocity, for a
    // step.
    CHECK(length(mover.position() - world.body(platform)->position() - place) < 0.1f);

    // It turns: the mover walks in place relative to it, so it goes round with it.
    world.body(platform)->set_linear_velocity({0, 0}).value();
    update(mover, world, 0);
    world.body(platform)->set_angular_velocity(0.5f).value();
    walk_for(mover, world, 1, 0);
    CHECK(mover.is_grounded());
    const double from_center = static_cast<double>(
        length(mover.position() - transform_point(world.body(platform)->transform(), {0, 0.25f})));
    CHECK(from_center == Approx(0.5).margin(0.05));
    CHECK(dot(mover.ground_normal(), {0, 1}) == Approx(std::cos(0.5)).margin(0.02));
}

TEST_CASE("a mover that jumps off a platform takes its velocity along") {
    World world;
    add(world, {.type = BodyType::Kinematic, .linear_velocity_m_s = {4, 0}}, Box{3, 0.25f});
    Mover mover = make_mover({0, 0.26});
    walk_for(mover, world, 0.2, 0);
    REQUIRE(mover.is_grounded());
    mover.move(world, {1, 5}, kStep_s).value();
    CHECK_FALSE(mover.is_grounded());
    CHECK(static_cast<double>(mover.velocity().x) == Approx(5).epsilon(1e-4));
    CHECK(static_cast<double>(mover.velocity().y) == Approx(5).epsilon(1e-4));
}

TEST_CASE("a mover stops in a corner of two walls, and under a wedge, without trembling") {
    World world;
    add_ground(world);
    add(world, {.type = BodyType::Static, .position_m = {3, 5}}, Box{0.5f, 5});
    // A ceiling that comes down to the left.
    add(world, {.type = BodyType::Static, .position_m = {-4, 2}, .angle_rad = 0.4}, Box{3, 0.2f});
    for (const float stick : {5.0f, -5.0f}) {
        Mover mover = make_mover({0, 0.01});
        walk_for(mover, world, 2, stick);
        const Position there = mover.position();
        CHECK(std::fabs(there.x) > 1);
        for (int i = 0; i < 100; ++i) {
            update(mover, world, stick);
            REQUIRE(std::fabs(mover.position().x - there.x) < 1e-3);
            REQUIRE(std::fabs(mover.position().y - there.y) < 1e-3);
        }
        if (stick > 0) CHECK(there.x == Approx(3 - 0.5 - 0.3 - 0.005).margin(1e-4));
    }
}

TEST_CASE("a mover never enters anything in worlds of random shapes") {
    double deepest = 0;
    double travelled = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        Random random(seed);
        const double origin = seed % 3 == 0 ? 1e7 : 0;
        World world;
        std::vector<std::pair<Convex, Transform>> shapes;
        const MoverDef def{};
        const Convex capsule = make_convex(def.capsule).value();
        for (int i = 0; i < 60; ++i) {
            const Convex shape = random_convex(random, kForms[random.below(6)]);
            const Transform xf{{origin + random.real(-6, 6), random.real(-4, 6)},
                               Rotation::from_angle(random.real(-3, 3))};
            const double gap =
                separation(rounded_hull(shape, {xf.p - Position{origin, 8}, xf.q}), rounded_hull(capsule))
                    .distance;
            if (gap < 0.1) continue;
            const BodyId body = world
                                    .create_body({.type = BodyType::Static,
                                                  .position_m = xf.p,
                                                  .angle_rad = static_cast<double>(xf.q.angle_rad())})
                                    .value();
            const auto points = std::span(shape.outline.points_m).first(shape.count());
            if (shape.count() == 1) {
                world.create_shape(body, Circle{points[0], shape.radius()}).value();
            } else if (shape.count() == 2) {
                world.create_shape(body, Capsule{points[0], points[1], shape.radius()}).value();
            } else {
                world.create_shape(body, Polygon{points, shape.radius()}).value();
            }
            shapes.push_back({shape, world.body(body)->transform()});
        }
        add(world, {.type = BodyType::Static, .position_m = {origin, -5}}, Box{20, 1});
        add(world, {.type = BodyType::Static, .position_m = {origin - 8, 0}}, Box{1, 20});
        add(world, {.type = BodyType::Static, .position_m = {origin + 8, 0}}, Box{1, 20});
        Mover mover = make_mover({origin, 8}, def);
        float stick = 0;
        for (int i = 0; i < 900; ++i) {
            if (i % 30 == 0) stick = random.real_f(-12, 12);
            const Position before = mover.position();
            update(mover, world, stick, random.chance(0.05) ? 9.0f : 0.0f);
            travelled += static_cast<double>(length(mover.position() - before));
            for (const auto& [shape, xf] : shapes) {
                const double gap =
                    separation(rounded_hull(shape, {xf.p - mover.position(), xf.q}), rounded_hull(capsule))
                        .distance;
                deepest = std::max(deepest, -gap);
                REQUIRE(gap > -0.001);
            }
        }
    }
    CHECK(deepest < 0.001);
    CHECK(travelled > 500);
}

TEST_CASE("a mover pushes a crate with its force, until the crate is as fast as it") {
    World world;
    const ShapeDef smooth{.density_kg_m2 = 100, .material = {.friction = 0}};
    add_ground(world, smooth);
    const BodyId crate = add(world, {.position_m = {1.3, 0.5}}, Box{0.5f, 0.5f}, smooth);
    run_for(world, 0.2);
    const double mass = static_cast<double>(world.body(crate)->mass());
    Mover mover = make_mover({0.4, 0.005}, {.push_force_n = 100});
    double time = 0;
    double fastest = 0;
    while (time < 1) {
        update(mover, world, 2);
        time += static_cast<double>(kStep_s);
        fastest = std::max(fastest, static_cast<double>(world.body(crate)->linear_velocity().x));
    }
    // F t / m, less the time to get there.
    CHECK(fastest == Approx(100 / mass * time).epsilon(0.15));
    walk_for(mover, world, 3, 2);
    CHECK(static_cast<double>(world.body(crate)->linear_velocity().x) == Approx(2).margin(0.05));
    CHECK(world.body(crate)->position().x - mover.position().x > 0.79);
}

TEST_CASE("a mover with no push leaves a crate where it is") {
    World world;
    add_ground(world);
    const BodyId crate = add(world, {.position_m = {1.3, 0.5}}, Box{0.5f, 0.5f});
    run_for(world, 1);
    const Position before = world.body(crate)->position();
    Mover mover = make_mover({0, 0.005}, {.push_force_n = 0});
    walk_for(mover, world, 2, 3);
    CHECK(world.body(crate)->position() == before);
    CHECK(mover.position().x == Approx(0.8 - 0.3 - 0.005).margin(0.01));
}

TEST_CASE("a wall that comes along shoves a mover ahead of it") {
    World world;
    add_ground(world);
    add(world, {.type = BodyType::Kinematic, .position_m = {-3, 2}, .linear_velocity_m_s = {1.5f, 0}},
        Box{0.5f, 1.9f});
    Mover mover = make_mover({0, 0.005});
    for (int i = 0; i < 240; ++i) {
        world.step(kStep_s).value();
        mover.move(world, {0, -0.1f}, kStep_s).value();
    }
    // The wall's face has gone from -2.5 to 3.5.
    CHECK(mover.position().x == Approx(3.5 + 0.3 + 0.005).margin(1e-3));
    CHECK(mover.is_grounded());
}

TEST_CASE("a mover walks through what its filter hides") {
    World world;
    add_ground(world);
    const BodyId door = add(world, {.type = BodyType::Static, .position_m = {2, 1}}, Box{0.2f, 1});
    Mover mover = make_mover({0, 0.005});
    for (int i = 0; i < 120; ++i) mover.move(world, {3, 0}, kStep_s, {.ignored_body = door}).value();
    CHECK(mover.position().x == Approx(6).margin(0.01));
}

TEST_CASE("a mover jumps through a one-way platform from below, stands on it, and rides it upward") {
    World world;
    add_ground(world);
    const BodyId platform = add(world, {.type = BodyType::Kinematic, .position_m = {0, 1.5}}, Box{2, 0.1f},
                                {.one_way_normal = {0, 1}});
    Mover mover = make_mover({0, 0.005});
    walk_for(mover, world, 0.1, 0);
    REQUIRE(mover.is_grounded());
    update(mover, world, 0, 7);
    walk_for(mover, world, 1.2, 0);
    CHECK(mover.ground_body() == platform);
    CHECK(mover.position().y == Approx(1.605).margin(1e-3));
    world.body(platform)->set_linear_velocity({0, 3}).value();
    walk_for(mover, world, 1, 0);
    CHECK(mover.ground_body() == platform);
    CHECK(mover.position().y == Approx(1.605 + 3).margin(0.06));
}

TEST_CASE("a mover walks on any wall that its up points away from") {
    // The same course twice: as it is, and turned by a quarter.
    std::array<std::vector<Position>, 2> ways;
    for (int turned = 0; turned < 2; ++turned) {
        const auto place = [&](double x, double y) { return turned ? Position{-y, x} : Position{x, y}; };
        const double angle = turned ? static_cast<double>(kPi) / 2 : 0;
        const auto put = [&](World& world, double x, double y, float w, float h, double extra) {
            add(world, {.type = BodyType::Static, .position_m = place(x, y), .angle_rad = angle + extra},
                Box{w, h});
        };
        World world({.gravity_m_s2 = turned ? Vec2{10, 0} : Vec2{0, -10}});
        put(world, 0, -1, 20, 1, 0);
        put(world, 3, 0, 1, 0.2f, 0);
        put(world, 6, 0, 1, 0.5f, 0.5);
        MoverDef def;
        if (turned) def = {.capsule = {{-0.3f, 0}, {-1.5f, 0}, 0.3f}, .up = {-1, 0}};
        Mover mover = make_mover(place(0, 0.01), def);
        for (int i = 0; i < 180; ++i) {
            update(mover, world, 3);
            const Position p = mover.position();
            ways[turned].push_back(turned ? Position{p.y, -p.x} : p);
        }
    }
    CHECK(ways[0].back().x > 6);
    for (std::size_t i = 0; i < ways[0].size(); ++i) {
        REQUIRE(ways[0][i].x == Approx(ways[1][i].x).margin(0.02));
        REQUIRE(ways[0][i].y == Approx(ways[1][i].y).margin(0.02));
    }
}

TEST_CASE("a mover stands in the air once its ground is destroyed, and can be put elsewhere") {
    World world;
    const BodyId shelf = add(world, {.type = BodyType::Static}, Box{2, 0.25f});
    Mover mover = make_mover({0, 0.26});
    walk_for(mover, world, 0.1, 0);
    REQUIRE(mover.is_grounded());
    CHECK(world.contains(mover.ground_shape()));
    world.destroy_body(shelf).value();
    update(mover, world, 0);
    CHECK_FALSE(mover.is_grounded());
    CHECK_FALSE(mover.ground_body());
    mover.teleport({100, 50}).value();
    CHECK(mover.position() == Position{100, 50});
}

TEST_CASE("bad movers and moves are refused") {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    const auto message = [](const auto& result) { return result ? "no error" : result.error().message; };
    using Catch::Matchers::Contains;
    CHECK_THAT(message(Mover::create({.capsule = {{}, {}, 1}}, {})), Contains("capsule.a_m"));
    CHECK_THAT(message(Mover::create({.capsule = {{}, {0, 1}, -1}}, {})), Contains("capsule.radius_m is -1"));
    CHECK_THAT(message(Mover::create({.up = {0, 0}}, {})), Contains("mover.up is 0, but must be 1"));
    CHECK_THAT(message(Mover::create({.up = {0, kNaN}}, {})), Contains("mover.up"));
    CHECK_THAT(message(Mover::create({.max_slope_rad = 2}, {})), Contains("mover.max_slope_rad is 2"));
    CHECK_THAT(message(Mover::create({.step_height_m = -1}, {})), Contains("mover.step_height_m is -1"));
    CHECK_THAT(message(Mover::create({.push_force_n = kNaN}, {})), Contains("mover.push_force_n is nan"));
    CHECK_THAT(message(Mover::create({}, {1e300, 0})), Contains("mover.position_m"));
    World world;
    Mover mover = make_mover({0, 0});
    CHECK_THAT(message(mover.move(world, {kNaN, 0}, kStep_s)), Contains("mover.velocity_m_s"));
    CHECK_THAT(message(mover.move(world, {1e30f, 0}, kStep_s)), Contains("mover.velocity_m_s"));
    CHECK_THAT(message(mover.move(world, {0, 0}, 0)), Contains("mover.dt_s is 0"));
    CHECK_THAT(message(mover.teleport({0, std::numeric_limits<double>::infinity()})),
               Contains("mover.position_m"));
    CHECK(mover.position() == Position{0, 0});
}

TEST_CASE("ground that shoots away faster than any mover can be leaves it where it is") {
    World world;
    const BodyId ground = add(world, {.type = BodyType::Kinematic, .position_m = {0, -0.5}}, Box{10, 0.5f});
    Mover mover = make_mover({0, 0.01});
    walk_for(mover, world, 0.1, 0);
    REQUIRE(mover.is_grounded());
    world.body(ground)->set_linear_velocity({1e20f, 0}).value();
    const Position before = mover.position();
    mover.move(world, {0, -0.1f}, kStep_s).value();
    CHECK(is_finite(mover.velocity()));
    world.step(kStep_s).value();
    mover.move(world, {0, -0.1f}, kStep_s).value();
    CHECK(is_finite(mover.velocity()));
    CHECK(length(mover.position() - before) < 0.1f);
}

}  // namespace cairn::physics
