// Bodies whose motion becomes infinite: they are halted and named, and nobody else notices.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr Position kPlace_m{20, 0.5};

// What holds the victim: the ground under it, and a joint to the ground, of most kinds.
struct Hold {
    const char* name;
    Material material{};
    JointDef joint = FilterJointDef{};
};

const std::vector<Hold>& holds() {
    constexpr Vec2 kOnGround_m{20, 1.5f};  // in the frame of the ground, which is 1 m lower
    static const std::vector<Hold> all{
        {"nothing but a filter"},
        {"a bounce", {.restitution = 0.5f}},
        {"a smooth bounce", {.friction = 0, .restitution = 1}},
        {"rolling resistance", {.rolling_resistance = 0.1f}},
        {"a distance", {}, DistanceJointDef{.local_anchor_a_m = {20, 5}, .length_m = 3}},
        {"a spring", {}, DistanceJointDef{.local_anchor_a_m = {20, 5}, .length_m = 3, .enable_spring = true}},
        {"a pin", {}, RevoluteJointDef{.local_anchor_a_m = kOnGround_m, .collide_connected = true}},
        {"a drive",
         {},
         RevoluteJointDef{.local_anchor_a_m = kOnGround_m,
                          .enable_limit = true,
                          .lower_rad = -1,
                          .upper_rad = 1,
                          .enable_motor = true,
                          .max_motor_torque_nm = 1,
                          .enable_spring = true,
                          .collide_connected = true}},
        {"a rail", {}, PrismaticJointDef{.local_anchor_a_m = kOnGround_m, .collide_connected = true}},
        {"a weld", {}, WeldJointDef{.local_anchor_a_m = kOnGround_m, .collide_connected = true}},
        {"a wheel", {}, WheelJointDef{.local_anchor_a_m = kOnGround_m, .collide_connected = true}},
        {"a motor", {}, MotorJointDef{.local_anchor_a_m = kOnGround_m, .collide_connected = true}},
        {"a drag", {}, MouseJointDef{.local_target_m = kOnGround_m, .max_force_n = 10}},
        {"friction", {}, FrictionJointDef{.local_anchor_a_m = kOnGround_m, .max_force_n = 10}},
    };
    return all;
}

struct Scene {
    World world;
    BodyId victim;
    std::vector<BodyId> others;  // a stack and a pendulum, far away, on the same ground
};

Scene make(const Hold& hold, JointSolver solver) {
    Scene scene{.world = World({.joint_solver = solver}), .victim = {}, .others = {}};
    World& world = scene.world;
    const BodyId ground = add_ground(world);
    const ShapeDef reporting{.material = hold.material, .contact_events = true, .hit_events = true};
    scene.victim = add(world, {.position_m = kPlace_m}, Circle{.radius_m = 0.5f}, reporting);
    JointDef joint = hold.joint;
    std::visit(
        [&](auto& def) {
            if constexpr (requires { def.body_a; }) {
                def.body_a = ground;
                def.body_b = scene.victim;
            }
        },
        joint);
    world.create_joint(joint).value();
    for (int i = 0; i < 4; ++i) {
        scene.others.push_back(add(world, {.position_m = {0, 0.5 + i}}, Box{0.5f, 0.5f}));
    }
    scene.others.push_back(add(world, {.position_m = {-9, 5}}, Box{0.5f, 0.1f}));
    world
        .create_joint(RevoluteJointDef{.body_a = ground,
                                       .body_b = scene.others.back(),
                                       .local_anchor_a_m = {-10, 6},
                                       .local_anchor_b_m = {-1, 0}})
        .value();
    return scene;
}

std::vector<double> numbers_of(const World& world, const std::vector<BodyId>& bodies) {
    std::vector<double> all;
    for (const BodyId id : bodies) {
        const Body body = *world.body(id);
        const Position p = body.position();
        const Vec2 v = body.linear_velocity();
        all.insert(all.end(), {p.x, p.y, static_cast<double>(body.angle()), static_cast<double>(v.x),
                               static_cast<double>(v.y), static_cast<double>(body.angular_velocity())});
    }
    return all;
}

}  // namespace

TEST_CASE("what is pushed to infinity stands where it was, and the rest goes on to the bit") {
    const Hold& hold = GENERATE(from_range(holds()));
    const JointSolver solver = GENERATE(JointSolver::Sweeping, JointSolver::Direct);
    const Vec2 push_n = GENERATE(Vec2{3e38f, 0}, Vec2{0, -3e38f}, Vec2{1e38f, 2e38f}, Vec2{-1e30f, -1e37f});
    CAPTURE(hold.name, push_n.x, push_n.y);
    Scene pushed = make(hold, solver);
    Scene calm = make(hold, solver);
    for (int step = 0; step < 30; ++step) {
        CAPTURE(step);
        const Position before = pushed.world.body(pushed.victim)->position();
        pushed.world.body(pushed.victim)->apply_force_to_center(push_n).value();
        pushed.world.step(kStep_s).value();
        calm.world.step(kStep_s).value();
        const auto halted = pushed.world.quarantined();
        for (const BodyId id : halted) {
            REQUIRE(id == pushed.victim);
            REQUIRE(pushed.world.body(id)->position() == before);
            REQUIRE(pushed.world.body(id)->linear_velocity() == Vec2{});
        }
        for (const ContactBegin& begin : pushed.world.contact_begins()) {
            REQUIRE(std::isfinite(begin.point_m.x + begin.point_m.y));
        }
        REQUIRE(numbers_of(pushed.world, pushed.others) == numbers_of(calm.world, calm.others));
    }
}

TEST_CASE("what was pushed to infinity once goes on as it should, and can be written down") {
    const Hold& hold = GENERATE(from_range(holds()));
    const JointSolver solver = GENERATE(JointSolver::Sweeping, JointSolver::Direct);
    CAPTURE(hold.name, solver);
    Scene scene = make(hold, solver);
    World& world = scene.world;
    world.body(scene.victim)->apply_force_to_center({3e38f, 0}).value();
    world.body(scene.victim)->apply_torque(3e38f).value();
    World restored;
    for (int step = 0; step < 60; ++step) {
        CAPTURE(step);
        world.step(kStep_s).value();
        REQUIRE(world.quarantined().empty() == (step > 0));
        const auto bytes = world.snapshot().value();
        const auto result = restored.restore(bytes.bytes());
        INFO((result ? "" : result.error().message));
        REQUIRE(result);
        REQUIRE(restored.state_hash() == world.state_hash());
    }
    CHECK(length(world.body(scene.victim)->position() - kPlace_m) < 10);
}

TEST_CASE("what would leave the world stands before its end") {
    World world({.gravity_m_s2 = {}});
    const BodyId hurled = add(world, {.position_m = {3, 4}}, Circle{.radius_m = 0.5f});
    const BodyId fast =
        add(world, {.position_m = {0, 100}, .linear_velocity_m_s = {-8e12f, 8e12f}}, Circle{});
    const BodyId slow = add(world, {.position_m = {0, -100}, .linear_velocity_m_s = {7e4f, 0}}, Circle{});
    world.body(hurled)->apply_impulse_to_center({3e38f, 0}).value();
    int halts_of_fast = 0;
    for (int step = 0; step < 20; ++step) {
        CAPTURE(step);
        const Position before = world.body(fast)->position();
        world.step(kStep_s).value();
        const std::span<const BodyId> halted = world.quarantined();
        const auto is_halted = [&](BodyId id) {
            return std::find(halted.begin(), halted.end(), id) != halted.end();
        };
        CHECK(is_halted(hurled) == (step == 0));
        CHECK_FALSE(is_halted(slow));
        if (is_halted(fast)) {
            ++halts_of_fast;
            CHECK(world.body(fast)->position() == before);
            CHECK(before.x - 8e12 / 60 < -kFarthest_m);
        }
        CHECK(world.body(fast)->position().x >= -kFarthest_m);
    }
    CHECK(halts_of_fast == 1);
    CHECK(world.body(hurled)->position() == Position{3, 4});
    CHECK(world.body(slow)->position().x == Approx(7e4 * 20 / 60));
    CHECK(world.body(fast)->linear_velocity() == Vec2{});
}

TEST_CASE("what is spun beyond all measure stands") {
    // Of so little inertia that its spin is infinite in rad/s before it is so in the solver's units.
    World world({.gravity_m_s2 = {}});
    const BodyId top = add(world, {}, Circle{.radius_m = 1e-6f});
    for (const float torque_nm : {1e-10f, 1.0f, 1e10f, 1e20f, 1e30f, 3e38f}) {
        CAPTURE(torque_nm);
        world.body(top)->apply_torque(torque_nm).value();
        world.step(kStep_s).value();
        const Body body = *world.body(top);
        CHECK(std::isfinite(body.angular_velocity()));
        CHECK(world.quarantined().empty() == (body.angular_velocity() != 0));
    }
}

TEST_CASE("what is halted as it comes to touch tells where it does") {
    const auto [of_a_m_s, of_b_m_s, spin_a_rad_s, spin_b_rad_s] =
        GENERATE(table<Vec2, Vec2, float, float>({{{7.3e37f, 0.1f}, {0.3f, -1.5e18f}, 1.7e27f, 9.3e14f},
                                                  {{1.4f, -0.9f}, {-6.7e37f, -1.7f}, 1.5e37f, -2.6e11f},
                                                  {{-0.9f, 1.2f}, {-7e37f, -2.2f}, -400.0f, -1.2e8f},
                                                  {{8.9e37f, 1.1f}, {1.5e33f, 1.9f}, -5.8f, 4.6e33f}}));
    for (int phase = 0; phase < 50; ++phase) {
        World world({.gravity_m_s2 = {}});
        const ShapeDef reporting{.contact_events = true};
        add(world, {.linear_velocity_m_s = of_a_m_s, .angular_velocity_rad_s = spin_a_rad_s}, Box{0.5f, 0.5f},
            reporting);
        add(world,
            {.position_m = {1.001 + 0.001 * phase, 0.1},
             .linear_velocity_m_s = of_b_m_s,
             .angular_velocity_rad_s = spin_b_rad_s},
            Box{0.5f, 0.5f}, reporting);
        world.step(kStep_s).value();
        CAPTURE(of_a_m_s.x, phase);
        for (const ContactBegin& begin : world.contact_begins()) {
            REQUIRE(std::isfinite(begin.point_m.x));
            REQUIRE(std::isfinite(begin.point_m.y));
        }
    }
}

TEST_CASE("what has less mass than float can divide by is pushed by nothing") {
    World world;
    const BodyId mote = add(world, {.linear_velocity_m_s = {1, 0}}, Circle{}, {.density_kg_m2 = 1e-40f});
    world.body(mote)->apply_torque(1).value();
    step_times(world, 60);
    CHECK(world.quarantined().empty());
    CHECK(world.body(mote)->linear_velocity() == Vec2{1, 0});
    CHECK(world.body(mote)->angular_velocity() == 0);
}

}  // namespace cairn::physics
