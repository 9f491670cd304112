// Structures that stand, awake, in worlds in which rest is looked for within a step; beside worlds in which
// it is not, since most of their bodies fly about elsewhere.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/scenes.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr int kBase = 12;
constexpr int kBoxes = kBase * (kBase + 1) / 2;

// Discs far above that drift, without weight, and meet nothing.
void add_drifters(World& world, int count) {
    for (int i = 0; i < count; ++i) {
        add(world,
            {.position_m = {10.0 * i, 1'000},
             .linear_velocity_m_s = {0, 1},
             .gravity_scale = 0,
             .allow_sleep = false},
            Circle{{}, 0.5f});
    }
}

// The boxes of a pyramid, and a ball that comes to it along the ground half a second after the first steps.
struct Pyramid {
    World world{WorldDef{.enable_sleep = false}};
    std::vector<BodyId> bodies;

    explicit Pyramid(bool leaves_out, float ball_speed_m_s = 0, int steps_before = 0) {
        add_ground(world);
        for (int row = 0; row < kBase; ++row) {
            for (int i = 0; i < kBase - row; ++i) {
                const Position at{i + 0.5 * row, 0.5 + row};
                bodies.push_back(add(world, {.position_m = at}, Box{0.5f, 0.5f}));
            }
        }
        if (!leaves_out) add_drifters(world, 2 * kBoxes);
        step_times(world, steps_before);
        if (ball_speed_m_s > 0) {
            const double x = -1 - 0.5 * static_cast<double>(ball_speed_m_s);
            bodies.push_back(add(world, {.position_m = {x, 0.5}, .linear_velocity_m_s = {ball_speed_m_s, 0}},
                                 Circle{{}, 0.5f}, {.density_kg_m2 = 3, .material = {.friction = 0}}));
        }
    }

    [[nodiscard]] std::vector<Position> positions() const {
        std::vector<Position> all;
        for (const BodyId id : bodies) all.push_back(world.body(id)->position());
        return all;
    }
};

double farthest_apart(const Pyramid& a, const Pyramid& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        const Vec2 apart = a.world.body(a.bodies[i])->position() - b.world.body(b.bodies[i])->position();
        most = std::max(most, static_cast<double>(length(apart)));
    }
    return most;
}

double greatest_difference_of_speed(const Pyramid& a, const Pyramid& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        const Vec2 apart =
            a.world.body(a.bodies[i])->linear_velocity() - b.world.body(b.bodies[i])->linear_velocity();
        most = std::max(most, static_cast<double>(length(apart)));
    }
    return most;
}

}  // namespace

TEST_CASE("a pyramid that stands does not move by a bit, and stands where one does that is solved in full") {
    Pyramid pyramid(true);
    Pyramid in_full(false);
    run_for(pyramid.world, 2);
    run_for(in_full.world, 2);
    const std::vector<Position> before = pyramid.positions();
    run_for(pyramid.world, 20);
    run_for(in_full.world, 20);
    CHECK(pyramid.positions() == before);
    CHECK(pyramid.world.counts().awake_bodies == kBoxes);
    CHECK(farthest_apart(pyramid, in_full) < 1e-6);
}

TEST_CASE("a platform that hardly moves takes what stands on it along, upwards and aside") {
    for (const Vec2 velocity_m_s : {Vec2{0, 1e-6f}, Vec2{1e-6f, 0}, Vec2{4e-7f, 4e-7f}}) {
        World world(WorldDef{.enable_sleep = false});
        const BodyId platform =
            add(world,
                {.type = BodyType::Kinematic, .position_m = {0, -0.5}, .linear_velocity_m_s = velocity_m_s},
                Box{5, 0.5f});
        std::vector<BodyId> boxes;
        for (int i = 0; i < 4; ++i)
            boxes.push_back(add(world, {.position_m = {0, 0.5 + i}}, Box{0.5f, 0.5f}));
        const double time_s = 600;
        run_for(world, time_s);
        const double right = time_s * static_cast<double>(velocity_m_s.x);
        const double up = time_s * static_cast<double>(velocity_m_s.y);
        CHECK(world.body(platform)->position().x == Approx(right).margin(1e-6));
        CHECK(world.body(platform)->position().y == Approx(-0.5 + up).margin(1e-6));
        for (int i = 0; i < 4; ++i) {
            CHECK(world.body(boxes[i])->position().x == Approx(right).margin(1e-5));
            CHECK(world.body(boxes[i])->position().y == Approx(0.5 + i + up).margin(1e-5));
        }
    }
}

TEST_CASE("worlds in which much stands go on from a snapshot to the bit, whatever batches were cut before") {
    constexpr int kStacks = 900;  // contacts enough for batches
    const WorldDef def{.enable_sleep = false};
    World world(def);
    add(world, {.type = BodyType::Static, .position_m = {0, -1}}, Box{5'000, 1});
    for (int stack = 0; stack < kStacks; ++stack) {
        for (int i = 0; i < 10; ++i) add(world, {.position_m = {4.0 * stack, 0.5 + i}}, Box{0.5f, 0.5f});
    }
    // It comes to a stack and leaves it, again and again.
    const BodyId walker =
        add(world, {.position_m = {-1.2, 0.5}}, Box{0.5f, 0.5f}, {.material = {.friction = 0.2f}});
    World restored(def);
    for (int step = 0; step < 120; ++step) {
        if (step % 15 == 0) {
            const Snapshot state = world.snapshot().value();
            restored.restore(state.bytes()).value();
        }
        const Vec2 go{step % 40 < 20 ? 1.0f : -1.0f, 0};
        for (World* const w : {&world, &restored}) {
            w->body(w->own(walker))->set_linear_velocity(go).value();
            step_times(*w, 1);
        }
        REQUIRE(world.state_hash() == restored.state_hash());
    }
}

TEST_CASE("a blow goes through a pyramid that stands as through one that is solved in full") {
    for (const float speed_m_s : {0.1f, 1.0f}) {
        INFO("a ball of " << speed_m_s << " m/s");
        Pyramid pyramid(true, speed_m_s);
        Pyramid in_full(false, speed_m_s);
        const BodyId ball = pyramid.bodies.back();
        bool is_hit = false;
        int steps_after = 0;
        for (int step = 0; step < 60 && steps_after < 8; ++step) {
            step_times(pyramid.world, 1);
            step_times(in_full.world, 1);
            is_hit = is_hit || pyramid.world.body(ball)->linear_velocity().x < 0.9f * speed_m_s;
            steps_after += is_hit ? 1 : 0;
        }
        CHECK(steps_after == 8);
        // Kicks below kStillSpeed_m_s are what may be left out.
        CHECK(greatest_difference_of_speed(pyramid, in_full) < 1e-4 * static_cast<double>(speed_m_s));
    }
}

// Such a blow multiplies last digits by ten thousand in its first step.
TEST_CASE("a hard blow through a pyramid that stands is one of those through pyramids solved in full") {
    std::vector<Pyramid> in_full;
    for (const int steps_before : {0, 1, 2, 3, 7, 20}) in_full.emplace_back(false, 10.0f, steps_before);
    Pyramid pyramid(true, 10.0f);
    for (int step = 0; step < 38; ++step) {
        step_times(pyramid.world, 1);
        for (Pyramid& other : in_full) step_times(other.world, 1);
        if (step < 30) continue;  // the ball is on its way
        double among_full = 0;
        double to_nearest = 1e9;
        for (const Pyramid& a : in_full) {
            for (const Pyramid& b : in_full)
                among_full = std::max(among_full, greatest_difference_of_speed(a, b));
            to_nearest = std::min(to_nearest, greatest_difference_of_speed(pyramid, a));
        }
        INFO("step " << step);
        CHECK(among_full > 0.01);
        CHECK(to_nearest < among_full);
    }
}

TEST_CASE("what rests is left to the bit as it was, and its velocity is none") {
    Pyramid pyramid(true);
    step_times(pyramid.world, 5);
    const auto impulses = [&] {
        std::vector<float> all;
        for (const DebugContact& contact : pyramid.world.debug_contacts()) {
            for (const auto& point : contact.points) all.push_back(point.impulse_ns);
            all.push_back(contact.friction_impulse_ns);
        }
        return all;
    };
    const std::vector<float> before = impulses();
    CHECK(before.size() > 2 * kBoxes);
    run_for(pyramid.world, 10);
    CHECK(impulses() == before);
    for (const BodyId body : pyramid.bodies) {
        CHECK(pyramid.world.body(body)->linear_velocity() == Vec2{});
        CHECK(pyramid.world.body(body)->angular_velocity() == 0);
    }
}

TEST_CASE(
    "what weight alone moves by five millionths of it slides as it should, on ice and beside what rests") {
    const double tilt_rad = 5e-6;
    World world(WorldDef{.enable_sleep = false});
    add(world, {.type = BodyType::Static, .angle_rad = -tilt_rad}, Box{100, 1});
    const BodyId box = add(world, {.position_m = {0, 1.5}, .angle_rad = -tilt_rad}, Box{0.5f, 0.5f},
                           {.material = {.friction = 0}});
    std::vector<BodyId> resting;
    for (int i = 0; i < 5; ++i) {
        const double x = -10 + 1.2 * i;
        resting.push_back(
            add(world, {.position_m = {x, 1.5 - tilt_rad * x}, .angle_rad = -tilt_rad}, Box{0.5f, 0.5f}));
    }
    const double time_s = 60;
    run_for(world, time_s);
    for (const BodyId body : resting) CHECK(world.body(body)->linear_velocity() == Vec2{});
    const double expected_m = 0.5 * 10 * tilt_rad * time_s * time_s;
    CHECK(world.body(box)->position().x == Approx(expected_m).epsilon(0.05));
}

TEST_CASE("a force of a millionth of the weight moves what lies on ice") {
    World world(WorldDef{.enable_sleep = false});
    add_ground(world, {.material = {.friction = 0}});
    const BodyId box = add(world, {.position_m = {0, 0.5}}, Box{0.5f, 0.5f}, {.material = {.friction = 0}});
    const double time_s = 60;
    const float force_n = 1e-5f * world.body(box)->mass_data().mass_kg;
    for (int step = 0; step < 60 * 60; ++step) {
        world.body(box)->apply_force_to_center({force_n, 0}).value();
        step_times(world, 1);
    }
    CHECK(world.body(box)->position().x == Approx(0.5 * 1e-5 * time_s * time_s).epsilon(0.1));
}

}  // namespace cairn::physics
