// One-way shapes: what comes from the front is caught at any speed, all else flies as if nothing were there.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr ShapeDef kUpward{.contact_events = true, .one_way_normal = {0, 1}};

// Its top is y = 0.
BodyId add_platform(World& world, const ShapeDef& def = kUpward) {
    return add(world, {.type = BodyType::Static}, Box{10, 0.1f, {0, -0.1f}}, def);
}

std::vector<Geometry> visitors() {
    return {Circle{{}, 0.3f}, Box{0.3f, 0.3f}, Capsule{{0, -0.2f}, {0, 0.2f}, 0.1f}, Box{0.02f, 0.02f}};
}

double height_of(const Geometry& geometry) {
    World world({.gravity_m_s2 = {}});
    const BodyId body = add(world, {}, geometry);
    double lowest = 0;
    const Outline& outline = world.shape(world.body(body)->shapes()[0])->outline();
    for (int i = 0; i < outline.count; ++i) {
        lowest = std::min(lowest, static_cast<double>(outline.points_m[static_cast<std::size_t>(i)].y));
    }
    return static_cast<double>(outline.radius_m) - lowest;
}

}  // namespace

TEST_CASE("what is thrown up from below flies as if nothing were there, and lands on top") {
    for (const Geometry& geometry : visitors()) {
        for (const float speed : {7.0f, 9.0f, 15.0f, 40.0f}) {
            World world;
            World empty;
            const BodyId platform = add_platform(world);
            const BodyDef thrown{.position_m = {0, -2}, .linear_velocity_m_s = {0, speed}};
            empty.create_body({.type = BodyType::Static}).value();
            const BodyId body = add(world, thrown, geometry);
            const BodyId free = add(empty, thrown, geometry);
            INFO("speed " << speed << ", kind " << geometry.index());
            while (empty.body(free)->linear_velocity().y > 0) {
                world.step(kStep_s).value();
                empty.step(kStep_s).value();
                // Above the top it is in reach of a contact, and integrated by substeps.
                const bool below = world.body(body)->position().y + height_of(geometry) < 0;
                const double margin = below ? 0 : 1e-3;
                REQUIRE(world.body(body)->position().y ==
                        Approx(empty.body(free)->position().y).epsilon(0).margin(margin));
                REQUIRE(world.contact_begins().empty());
            }
            run_for(world, 2 + static_cast<double>(speed) / 10);
            CHECK(world.body(body)->position().y == Approx(height_of(geometry)).margin(0.005));
            CHECK(world.body(platform)->position() == Position{});
        }
    }
}

TEST_CASE("what falls on it is caught at any speed") {
    for (const Geometry& geometry : visitors()) {
        for (const float speed : {0.0f, 3.0f, 12.0f, 30.0f, 100.0f, 1000.0f}) {
            World world;
            add_platform(world);
            const BodyId body =
                add(world, {.position_m = {0, 3.3}, .linear_velocity_m_s = {0, -speed}}, geometry);
            run_for(world, 3);
            INFO("speed " << speed << ", kind " << geometry.index());
            CHECK(world.body(body)->position().y == Approx(height_of(geometry)).margin(0.005));
        }
    }
}

TEST_CASE("from below it is passed at any speed too") {
    for (const Geometry& geometry : visitors()) {
        for (const float speed : {3.0f, 30.0f, 100.0f, 1000.0f}) {
            World world({.gravity_m_s2 = {}});
            add_platform(world);
            const BodyId body =
                add(world, {.position_m = {0, -3.3}, .linear_velocity_m_s = {0, speed}}, geometry);
            run_for(world, 2);
            INFO("speed " << speed << ", kind " << geometry.index());
            CHECK(world.body(body)->position().y ==
                  Approx(-3.3 + 2 * static_cast<double>(speed)).epsilon(1e-5));
        }
    }
}

TEST_CASE("a jump that barely clears it lands on it, and one that does not falls back") {
    for (const bool clears : {true, false}) {
        World world;
        add_platform(world);
        // The way up to rest is v^2 / (2 g): the soles come to 1 cm above the top, or stay 5 cm below it.
        const double rise = clears ? 0.01 : -0.05;
        const double speed = std::sqrt(20 * (2 + rise));
        const BodyId body =
            add(world, {.position_m = {0, -1.5}, .linear_velocity_m_s = {0, static_cast<float>(speed)}},
                Box{0.3f, 0.5f});
        run_for(world, 2);
        if (clears) {
            CHECK(world.body(body)->position().y == Approx(0.5).margin(0.005));
        } else {
            CHECK(world.body(body)->position().y < -2);
        }
    }
}

TEST_CASE("what comes from the side, or stands in it, goes through") {
    World world({.gravity_m_s2 = {}});
    add_platform(world);
    const BodyId sideways =
        add(world, {.position_m = {-12, -0.1}, .linear_velocity_m_s = {5, 0}}, Box{0.3f, 0.3f});
    run_for(world, 6);
    CHECK(world.body(sideways)->position().x == Approx(18).epsilon(1e-5));

    World falling;
    add_platform(falling);
    const BodyId inside = add(falling, {.position_m = {0, 0.2}}, Box{0.5f, 0.5f});
    run_for(falling, 1);
    CHECK(falling.body(inside)->position().y == Approx(0.2 - 5).epsilon(0.01));
}

TEST_CASE("what is placed on it stays, exactly on it or deeper by less than the slop") {
    for (const double depth : {-0.01, 0.0, 0.001, 0.004}) {
        World world({.enable_sleep = false});
        add_platform(world);
        std::vector<BodyId> tower;
        for (int i = 0; i < 10; ++i)
            tower.push_back(add(world, {.position_m = {0, 0.5 + i - depth}}, Box{0.5f, 0.5f}));
        run_for(world, 10);
        INFO("depth " << depth);
        for (int i = 0; i < 10; ++i) {
            CHECK(world.body(tower[static_cast<std::size_t>(i)])->position().y ==
                  Approx(0.5 + i).margin(0.01));
        }
    }
}

TEST_CASE("a box that slides over a row of platforms, and a ball that rolls, do as on solid ones") {
    for (const bool rolls : {false, true}) {
        const auto ride = [&](Vec2 normal) {
            World world({.enable_sleep = false});
            const Material material{.friction = rolls ? 1.0f : 0.0f};
            for (int i = 0; i < 30; ++i) {
                add(world, {.type = BodyType::Static, .position_m = {2.0 * i, 0}}, Box{1, 0.1f, {0, -0.1f}},
                    {.material = material, .one_way_normal = normal});
            }
            const Geometry shape = rolls ? Geometry{Circle{{}, 0.3f}} : Geometry{Box{0.3f, 0.3f}};
            const BodyId body = add(world,
                                    {.position_m = {0, 0.3},
                                     .linear_velocity_m_s = {5, 0},
                                     .angular_velocity_rad_s = rolls ? -5 / 0.3f : 0},
                                    shape, {.material = material});
            std::vector<Position> way;
            for (int i = 0; i < 10 * 60; ++i) {
                world.step(kStep_s).value();
                way.push_back(world.body(body)->position());
            }
            return way;
        };
        const std::vector<Position> one_way = ride({0, 1});
        CHECK(one_way == ride({}));
        CHECK(one_way.back().x > 20);
        CHECK(one_way.back().y > 0.29);
    }
}

// With another material the contact is listed anew and remembers that it touched; as it is apart then, it is
// undecided until the two meet again.
TEST_CASE("what is lifted off it lands on it again as on a solid one") {
    for (const Geometry& geometry : visitors()) {
        for (int lift_mm = 20; lift_mm < 60; ++lift_mm) {
            World world;
            World solid;
            add_platform(world);
            add_platform(solid, {});
            const auto lift = [&](World& in) {
                const BodyId body = add(in, {.position_m = {0, height_of(geometry)}}, geometry);
                for (int i = 0; i < 3; ++i) in.step(kStep_s).value();
                in.shape(in.body(body)->shapes()[0])->set_material({.friction = 0.5f}).value();
                in.body(body)->set_transform({0, height_of(geometry) + 0.001 * lift_mm}, 0).value();
                in.step(kStep_s).value();
                in.body(body)->set_linear_velocity({0, -1}).value();
                return body;
            };
            const BodyId body = lift(world);
            const BodyId other = lift(solid);
            INFO("lifted by " << lift_mm << " mm, kind " << geometry.index());
            for (int i = 0; i < 10; ++i) {
                world.step(kStep_s).value();
                solid.step(kStep_s).value();
                REQUIRE(world.body(body)->position().y ==
                        Approx(solid.body(other)->position().y).epsilon(0).margin(1e-4));
            }
        }
    }
}

TEST_CASE("the normal turns with its body") {
    for (const double angle : {0.5, 2.0, -1.2}) {
        World world({.gravity_m_s2 = {}});
        add(world, {.type = BodyType::Static, .angle_rad = angle}, Box{10, 0.1f},
            {.material = {.restitution = 1}, .one_way_normal = {0, 3}});
        const Vec2 normal = rotate(Rotation::from_angle(angle), {0, 1});
        const BodyId front =
            add(world, {.position_m = Position{} + 2.0f * normal, .linear_velocity_m_s = -4 * normal},
                Circle{{}, 0.2f}, {.filter = {.group = -1}});
        const BodyId back =
            add(world, {.position_m = Position{} + -2.0f * normal, .linear_velocity_m_s = 4 * normal},
                Circle{{}, 0.2f}, {.filter = {.group = -1}});
        run_for(world, 2);
        CHECK(dot(world.body(front)->linear_velocity(), normal) == Approx(4).epsilon(1e-3));
        CHECK(dot(world.body(back)->linear_velocity(), normal) == Approx(4).epsilon(1e-6));
    }
}

TEST_CASE("a lift that is one-way picks up what is above and passes what is below") {
    World world;
    const BodyId lift =
        add(world, {.type = BodyType::Kinematic, .position_m = {0, -0.1}, .linear_velocity_m_s = {0, 2}},
            Box{3, 0.1f}, kUpward);
    const BodyId rider = add(world, {.position_m = {0, 0.3}}, Box{0.3f, 0.3f});
    run_for(world, 1);
    CHECK(world.body(rider)->position().y == Approx(world.body(lift)->position().y + 0.4).margin(0.01));
    // Down it goes, faster than the rider falls, and through what stands below.
    const BodyId floor = add(world, {.type = BodyType::Static, .position_m = {0, -3}}, Box{20, 0.5f});
    const BodyId bystander = add(world, {.position_m = {2, -2.1}}, Box{0.4f, 0.4f});
    run_for(world, 1);
    const Position before = world.body(bystander)->position();
    world.body(lift)->set_linear_velocity({0, -15}).value();
    run_for(world, 1);
    // Once the lift is below it is in front of it, and touches it for a moment.
    CHECK(world.body(bystander)->position().y == Approx(before.y).epsilon(0).margin(1e-4));
    CHECK(world.body(bystander)->position().x == Approx(before.x).epsilon(0).margin(1e-4));
    CHECK(world.body(lift)->position().y < world.body(floor)->position().y);
}

TEST_CASE("what passes is not woken, and does not wake") {
    World world;
    add_ground(world);
    const BodyId crate = add(world, {.position_m = {0, 0.5}}, Box{0.5f, 0.5f});
    run_for(world, 2);
    REQUIRE_FALSE(world.body(crate)->is_awake());
    const BodyId shelf =
        add(world, {.type = BodyType::Kinematic, .position_m = {-5, 0.5}, .linear_velocity_m_s = {5, 0}},
            Box{1, 0.1f}, kUpward);
    run_for(world, 2);
    CHECK_FALSE(world.body(crate)->is_awake());
    CHECK(world.body(shelf)->position().x > 4);
}

TEST_CASE("refiltering for a moment drops a body through, and the normal can be changed") {
    World world;
    const BodyId platform = add_platform(world);
    const BodyId body = add(world, {.position_m = {0, 0.3}}, Box{0.3f, 0.3f});
    run_for(world, 2);
    REQUIRE_FALSE(world.body(body)->is_awake());
    Shape top = *world.shape(world.body(platform)->shapes()[0]);
    SECTION("refiltered") {
        Shape shape = *world.shape(world.body(body)->shapes()[0]);
        shape.set_filter({.mask = 0});
        run_for(world, 0.15);
        shape.set_filter({});
        run_for(world, 1);
        CHECK(world.body(body)->position().y < -3);
    }
    SECTION("turned round") {
        top.set_one_way_normal({0, -2}).value();
        CHECK(top.one_way_normal() == Vec2{0, -1});
        run_for(world, 1);
        CHECK(world.body(body)->position().y < -3);
    }
    SECTION("made solid from all sides") {
        top.set_one_way_normal({}).value();
        run_for(world, 1);
        CHECK(world.body(body)->position().y == Approx(0.3).margin(0.005));
        world.body(body)->set_transform({0, -2}, 0).value();
        world.body(body)->set_linear_velocity({0, 10}).value();
        run_for(world, 1);
        CHECK(world.body(body)->position().y < -2);
    }
}

TEST_CASE("directions of any length, down to the smallest and up to the largest, are taken as directions") {
    World world;
    const BodyId platform = add_platform(world);
    Shape top = *world.shape(world.body(platform)->shapes()[0]);
    for (const float length : {1e-44f, 1e-20f, 1.0f, 3e38f}) {
        top.set_one_way_normal({length, length}).value();
        CHECK(top.one_way_normal().x == Approx(std::sqrt(0.5)).epsilon(1e-5));
        CHECK(top.one_way_normal().y == Approx(std::sqrt(0.5)).epsilon(1e-5));
    }
}

TEST_CASE("a line is a platform as well") {
    World world;
    add(world, {.type = BodyType::Static}, Segment{{-5, 0}, {5, 0}}, kUpward);
    const BodyId jumper = add(world, {.position_m = {0, -1}, .linear_velocity_m_s = {0, 8}}, Box{0.3f, 0.3f});
    const BodyId faller =
        add(world, {.position_m = {2, 4}, .linear_velocity_m_s = {0, -50}}, Circle{{}, 0.3f});
    run_for(world, 3);
    CHECK(world.body(jumper)->position().y == Approx(0.3).margin(0.005));
    CHECK(world.body(faller)->position().y == Approx(0.3).margin(0.005));
}

TEST_CASE("a crowd thrown at random: who has been above stays above, and no one is stopped from below") {
    Random random(3);
    World world;
    World empty;
    add(world, {.type = BodyType::Static}, Box{500, 0.1f, {0, -0.1f}}, kUpward);
    empty.create_body({.type = BodyType::Static}).value();
    struct Thrown {
        BodyId body;
        BodyId free;
        double size;
        bool above;           // has been wholly above
        double highest = -9;  // in free flight
    };
    std::vector<Thrown> crowd;
    for (int i = 0; i < 150; ++i) {
        const float size = random.real_f(0.05, 0.4);
        const Geometry geometry = i % 2 == 0 ? Geometry{Circle{{}, size}} : Geometry{Box{size, 0.6f * size}};
        const bool below = random.chance(0.7);
        const BodyDef def{.position_m = {6.0 * i - 450, below ? random.real(-4, -0.5) : random.real(0.5, 3)},
                          .angle_rad = random.real(-3, 3),
                          .linear_velocity_m_s = {0, below ? random.real_f(5, 30) : random.real_f(-30, 0)},
                          .angular_velocity_rad_s = random.real_f(-10, 10)};
        const double extent = static_cast<double>(i % 2 == 0 ? size : size * std::sqrt(1.36f));
        crowd.push_back({add(world, def, geometry), add(empty, def, geometry), extent, !below});
    }
    int risen = 0;
    for (int step = 0; step < 60 * 8; ++step) {
        world.step(kStep_s).value();
        empty.step(kStep_s).value();
        for (Thrown& t : crowd) {
            const double y = world.body(t.body)->position().y;
            const double free_y = empty.body(t.free)->position().y;
            t.highest = std::max(t.highest, free_y);
            INFO("step " << step << ", size " << t.size);
            if (!t.above && y > t.size) {
                t.above = true;
                ++risen;
            }
            if (t.above) {
                REQUIRE(y > 0);
            } else {
                REQUIRE(t.highest < t.size + 1e-3);
                if (y < -t.size - 0.2) REQUIRE(y == Approx(free_y).epsilon(0).margin(2e-3));
            }
        }
    }
    CHECK(risen > 80);
}

}  // namespace cairn::physics
