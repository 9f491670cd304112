// Each kind of joint against the mechanics of the thing that it stands for.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/precise.h"

namespace cairn::physics {
namespace {

using namespace test;

struct Bench {
    JointSolver solver;
    World world;
    BodyId ground;

    // Every test runs with either solver: what a joint does must not depend on which solves it.
    explicit Bench(Vec2 gravity = {0, -10})
        : solver(GENERATE(JointSolver::Sweeping, JointSolver::Direct)),
          world({.gravity_m_s2 = gravity, .joint_solver = solver, .enable_sleep = false}) {
        ground = world.create_body({.type = BodyType::Static}).value();
    }
    BodyId box(Position at, float half_m = 0.5f, double angle_rad = 0) {
        return add(world, {.position_m = at, .angle_rad = angle_rad}, Box{half_m, half_m});
    }
    JointId join(const JointDef& def) { return world.create_joint(def).value(); }
    std::vector<JointBreak> breaks_of_2_s() {
        std::vector<JointBreak> breaks;
        for (int i = 0; i < 120; ++i) {
            world.step(kStep_s).value();
            for (const JointBreak& event : world.joint_breaks()) breaks.push_back(event);
        }
        return breaks;
    }
    [[nodiscard]] double mass(BodyId body) const { return d(world.body(body)->mass()); }
    [[nodiscard]] double inertia(BodyId body) const { return d(world.body(body)->mass_data().inertia_kg_m2); }
};

}  // namespace

TEST_CASE("a prismatic joint slides down its axis with g sin, holds all else, and stops at its limits") {
    Bench bench;
    const double slope = -0.5;
    const BodyId sled = bench.box({0, 0}, 0.5f, slope);
    const JointId joint = bench.join(PrismaticJointDef{.body_a = bench.ground,
                                                       .body_b = sled,
                                                       .local_angle_a_rad = static_cast<float>(slope),
                                                       .enable_limit = true,
                                                       .lower_m = -1,
                                                       .upper_m = 3});
    const double a = 10 * std::sin(-slope);
    double askew = 0;
    for (int i = 1; i <= 240; ++i) {
        bench.world.step(kStep_s).value();
        const Position p = bench.world.body(sled)->position();
        askew = std::max(askew, std::fabs(p.x * std::sin(-slope) + p.y * std::cos(-slope)));
        askew = std::max(askew, std::fabs(bench.world.body(sled)->angle() - slope));
        const double t = i / 60.0;
        // Semi-implicit steps of 1/240 s are ahead by a t h / 2; the direct solver's are exact.
        const double ahead = bench.solver == JointSolver::Direct ? 0 : a * t / 480;
        if (a * t * t / 2 < 2.9) {
            CHECK(d(bench.world.joint(joint)->translation()) == Approx(a * t * t / 2 + ahead).epsilon(1e-3));
        }
    }
    CHECK(askew < 1e-4);
    CHECK(d(bench.world.joint(joint)->translation()) == Approx(3).margin(5e-3));
    const Vec2 force = bench.world.joint(joint)->reaction_force();
    CHECK(d(force.y) == Approx(10 * bench.mass(sled)).epsilon(2e-3));
    CHECK(d(force.x) == Approx(0).margin(0.02 * bench.mass(sled)));
}

TEST_CASE("the motor of a prismatic joint lifts what its force can lift") {
    for (const double share : {0.9, 1.1}) {
        Bench bench;
        const BodyId lift = bench.box({0, 0});
        const double weight = 10 * bench.mass(lift);
        const JointId joint =
            bench.join(PrismaticJointDef{.body_a = bench.ground,
                                         .body_b = lift,
                                         .local_angle_a_rad = static_cast<float>(kPiD / 2),
                                         .local_angle_b_rad = static_cast<float>(kPiD / 2),
                                         .enable_motor = true,
                                         .motor_speed_m_s = 2,
                                         .max_motor_force_n = static_cast<float>(share * weight)});
        run_for(bench.world, 0.5);
        const double expected = 10 * (share - 1) * 0.5;
        CHECK(d(bench.world.body(lift)->linear_velocity().y) == Approx(expected).epsilon(1e-3));
        CHECK(d(bench.world.joint(joint)->reaction_force().y) == Approx(share * weight).epsilon(1e-3));
        run_for(bench.world, 3);
        if (share > 1) CHECK(d(bench.world.body(lift)->linear_velocity().y) == Approx(2).epsilon(1e-4));
    }
}

TEST_CASE("a rigid weld carries weight and moment, and a spring weld bends by moment over stiffness") {
    for (const float frequency : {0.0f, 4.0f}) {
        Bench bench;
        const BodyId arm = add(bench.world, {.position_m = {1, 0}}, Box{1, 0.1f});
        const JointId joint = bench.join(WeldJointDef{.body_a = bench.ground,
                                                      .body_b = arm,
                                                      .local_anchor_b_m = {-1, 0},
                                                      .angular_frequency_hz = frequency,
                                                      .angular_damping_ratio = 1});
        run_for(bench.world, 4);
        const double moment = 10 * bench.mass(arm);
        INFO(frequency << " Hz");
        CHECK(d(bench.world.joint(joint)->reaction_force().y) == Approx(10 * bench.mass(arm)).epsilon(2e-3));
        const double angle = d(bench.world.joint(joint)->joint_angle());
        CHECK(d(bench.world.joint(joint)->reaction_torque()) ==
              Approx(moment * std::cos(angle)).epsilon(5e-3));
        if (frequency == 0) {
            CHECK(angle == Approx(0).margin(2e-3));
        } else {
            // The stiffness is that of the inertia about the centre of mass, which the spring turns.
            const double w = 2 * kPiD * d(frequency);
            CHECK(angle == Approx(-moment * std::cos(angle) / (bench.inertia(arm) * w * w)).epsilon(0.02));
        }
    }
}

TEST_CASE("a wheel's suspension sags by g / w^2, and its motor drives") {
    Bench bench;
    const BodyId chassis = bench.world.create_body({.type = BodyType::Static}).value();
    const BodyId wheel = add(bench.world, {}, Circle{{}, 0.4f});
    const JointId joint = bench.join(WheelJointDef{.body_a = chassis,
                                                   .body_b = wheel,
                                                   .local_angle_a_rad = static_cast<float>(kPiD / 2),
                                                   .frequency_hz = 3,
                                                   .enable_motor = true,
                                                   .motor_speed_rad_s = -20,
                                                   .max_motor_torque_nm = 2});
    step_times(bench.world, 30);
    CHECK(d(bench.world.body(wheel)->angular_velocity()) ==
          Approx(std::max(-20.0, -2 / bench.inertia(wheel) * 0.5)).epsilon(1e-3));
    run_for(bench.world, 6);
    const double w = 2 * kPiD * 3;
    CHECK(d(bench.world.joint(joint)->translation()) == Approx(-10 / (w * w)).epsilon(1e-3));
    CHECK(std::fabs(bench.world.body(wheel)->position().x) < 1e-4);
    CHECK(d(bench.world.body(wheel)->angular_velocity()) == Approx(-20).epsilon(1e-4));
    CHECK(d(bench.world.joint(joint)->joint_angle()) < -20 * 5);
}

TEST_CASE("a motor joint goes to its pose and holds there what its force can hold") {
    for (const double share : {0.9, 2.0}) {
        Bench bench;
        const BodyId drone = bench.box({0, 0});
        const double weight = 10 * bench.mass(drone);
        const JointId joint = bench.join(MotorJointDef{.body_a = bench.ground,
                                                       .body_b = drone,
                                                       .target_offset_m = {1, 2},
                                                       .target_angle_rad = 0.5f,
                                                       .linear_frequency_hz = 2,
                                                       .angular_frequency_hz = 2,
                                                       .max_force_n = static_cast<float>(share * weight),
                                                       .max_torque_nm = 100});
        run_for(bench.world, 5);
        CHECK(d(bench.world.joint(joint)->joint_angle()) == Approx(0.5).margin(1e-3));
        const Position p = bench.world.body(drone)->position();
        if (share > 1) {
            const double w = 2 * kPiD * 2;
            CHECK(p.x == Approx(1).margin(1e-3));
            CHECK(p.y == Approx(2 - 10 / (w * w)).margin(1e-3));
        } else {
            CHECK(p.y < -1);
            CHECK(d(length(bench.world.joint(joint)->reaction_force())) ==
                  Approx(share * weight).epsilon(1e-3));
        }
    }
}

TEST_CASE("a motor joint without a spring drives at its velocities") {
    Bench bench({0, 0});
    const BodyId cart = bench.box({0, 0});
    bench.join(MotorJointDef{.body_a = bench.ground,
                             .body_b = cart,
                             .linear_velocity_m_s = {3, 1},
                             .angular_velocity_rad_s = 0.5f,
                             .max_force_n = kUnlimited,
                             .max_torque_nm = kUnlimited});
    run_for(bench.world, 1);
    CHECK(d(bench.world.body(cart)->linear_velocity().x) == Approx(3).epsilon(1e-4));
    CHECK(d(bench.world.body(cart)->linear_velocity().y) == Approx(1).epsilon(1e-4));
    CHECK(d(bench.world.body(cart)->angular_velocity()) == Approx(0.5).epsilon(1e-4));
}

TEST_CASE("a mouse joint draws a point to its target, with no more than its force") {
    Bench bench;
    const BodyId box = bench.box({0, 0});
    const double weight = 10 * bench.mass(box);
    const JointId joint = bench.join(MouseJointDef{.body_a = bench.ground,
                                                   .body_b = box,
                                                   .local_anchor_b_m = {0.5f, 0.5f},
                                                   .frequency_hz = 5,
                                                   .damping_ratio = 1,
                                                   .max_force_n = static_cast<float>(10 * weight)});
    bench.world.joint(joint)->set_target(Position{2, 3}).value();
    bench.world.body(box)->set_angular_damping(3).value();
    run_for(bench.world, 40);
    const Position held = bench.world.joint(joint)->anchor_b();
    CHECK(held.x == Approx(2).margin(5e-3));
    CHECK(held.y == Approx(3).margin(0.05));
    CHECK(d(bench.world.joint(joint)->reaction_force().y) == Approx(weight).epsilon(5e-3));
    // The corner hangs above the centre.
    CHECK(bench.world.body(box)->position().x == Approx(2).margin(2e-2));
}

TEST_CASE("a pulley accelerates as Atwood's machine, with a block and tackle too, and goes slack") {
    for (const float ratio : {1.0f, 2.0f}) {
        Bench bench;
        const BodyId a = bench.box({-1, 0}, 0.5f);
        const BodyId b = bench.box({1, 0}, 1.0f);
        const JointId joint = bench.join(PulleyJointDef{
            .body_a = a, .body_b = b, .wheel_a_m = {-1, 50}, .wheel_b_m = {1, 50}, .ratio = ratio});
        const double ma = bench.mass(a);
        const double mb = bench.mass(b);
        const double k = d(ratio);
        // T = ma (g + aa), k T = mb (g - ab), aa = k ab
        const double ab = 10 * (mb - k * ma) / (mb + k * k * ma);
        run_for(bench.world, 1);
        INFO("ratio " << ratio);
        CHECK(d(bench.world.body(b)->linear_velocity().y) == Approx(-ab).epsilon(2e-3));
        CHECK(d(bench.world.body(a)->linear_velocity().y) == Approx(k * ab).epsilon(2e-3));
        CHECK(d(length(bench.world.joint(joint)->reaction_force())) ==
              Approx(k * ma * (10 + k * ab)).epsilon(2e-3));
        // Thrown up, b falls freely.
        bench.world.body(b)->set_linear_velocity({0, 5}).value();
        bench.world.body(a)->set_linear_velocity({0, 5}).value();
        run_for(bench.world, 0.25);
        CHECK(d(bench.world.body(b)->linear_velocity().y) == Approx(2.5).margin(1e-4));
    }
}

TEST_CASE("gears turn against each other by their ratio, and a rack slides with a pinion") {
    Bench bench({0, 0});
    const BodyId small = add(bench.world, {.position_m = {0, 0}}, Circle{{}, 0.5f});
    const BodyId large = add(bench.world, {.position_m = {1.5, 0}}, Circle{{}, 1});
    const BodyId rack = bench.box({3, 0});
    const JointId pin_1 = bench.join(RevoluteJointDef{.body_a = bench.ground, .body_b = small});
    const JointId pin_2 =
        bench.join(RevoluteJointDef{.body_a = bench.ground, .body_b = large, .local_anchor_a_m = {1.5f, 0}});
    const JointId slide =
        bench.join(PrismaticJointDef{.body_a = bench.ground, .body_b = rack, .local_anchor_a_m = {3, 0}});
    const JointId gear = bench.join(GearJointDef{.joint_1 = pin_1, .joint_2 = pin_2, .ratio = 2});
    bench.join(GearJointDef{.joint_1 = pin_2, .joint_2 = slide, .ratio = 1});
    bench.world.body(small)->apply_angular_impulse(1).value();
    // One degree of freedom: L = small's inertia w + ...; all three share the impulse by their speeds.
    const double w = 1 / (bench.inertia(small) + bench.inertia(large) / 4 + bench.mass(rack) / 4);
    for (int i = 0; i < 600; ++i) {
        bench.world.step(kStep_s).value();
        const auto angle = [&](JointId id) { return d(bench.world.joint(id)->joint_angle()); };
        REQUIRE(angle(pin_1) + 2 * angle(pin_2) == Approx(0).margin(2e-3));
        REQUIRE(angle(pin_2) + d(bench.world.joint(slide)->translation()) == Approx(0).margin(2e-3));
    }
    CHECK(d(bench.world.body(small)->angular_velocity()) == Approx(w).epsilon(1e-3));
    CHECK(d(bench.world.joint(pin_1)->joint_angle()) == Approx(10 * w).epsilon(2e-3));
    CHECK(10 * w > 4 * kPiD);  // whole turns are counted
    bench.world.destroy_joint(pin_1).value();
    CHECK_FALSE(bench.world.contains(gear));
    CHECK(bench.world.contains(pin_2));
}

TEST_CASE("two slides in gear accelerate by their ratio") {
    for (const float ratio : {3.0f, -0.5f}) {
        INFO("ratio " << ratio);
        Bench bench;
        const auto slide_up = [&](BodyId body, float x_m) {
            return bench.join(PrismaticJointDef{.body_a = bench.ground,
                                                .body_b = body,
                                                .local_anchor_a_m = {x_m, 0},
                                                .local_angle_a_rad = kPi / 2,
                                                .local_angle_b_rad = kPi / 2});
        };
        const BodyId a = bench.box({-2, 0}, 0.5f);
        const BodyId b = bench.box({2, 0}, 0.75f);
        const JointId slide_a = slide_up(a, -2);
        const JointId slide_b = slide_up(b, 2);
        bench.join(GearJointDef{.joint_1 = slide_a, .joint_2 = slide_b, .ratio = ratio});
        // The gear pushes with F and k F: a' = F / ma - g, b' = k F / mb - g, a' + k b' = 0.
        const double k = d(ratio);
        const double force = 10 * (1 + k) / (1 / bench.mass(a) + k * k / bench.mass(b));
        const double up_a = force / bench.mass(a) - 10;
        for (int i = 1; i <= 60; ++i) {
            bench.world.step(kStep_s).value();
            const double at_a = d(bench.world.joint(slide_a)->translation());
            const double at_b = d(bench.world.joint(slide_b)->translation());
            REQUIRE(at_a + k * at_b == Approx(0).margin(1e-3));
        }
        CHECK(d(bench.world.body(a)->linear_velocity().y) == Approx(up_a).epsilon(2e-3));
        CHECK(d(bench.world.body(b)->linear_velocity().y) == Approx(-up_a / k).epsilon(2e-3));
    }
}

TEST_CASE("a friction joint brakes with its force and its torque, and then holds") {
    Bench bench({0, 0});
    const BodyId puck = bench.box({0, 0});
    bench.world.body(puck)->set_linear_velocity({3, 4}).value();
    bench.world.body(puck)->set_angular_velocity(6).value();
    bench.join(FrictionJointDef{.body_a = bench.ground,
                                .body_b = puck,
                                .local_anchor_a_m = {},
                                .max_force_n = static_cast<float>(2 * bench.mass(puck)),
                                .max_torque_nm = static_cast<float>(3 * bench.inertia(puck))});
    run_for(bench.world, 1);
    CHECK(d(length(bench.world.body(puck)->linear_velocity())) == Approx(5 - 2).epsilon(1e-3));
    CHECK(d(bench.world.body(puck)->angular_velocity()) == Approx(6 - 3).epsilon(1e-3));
    run_for(bench.world, 3);
    CHECK(bench.world.body(puck)->linear_velocity() == Vec2{});
    CHECK(d(bench.world.body(puck)->angular_velocity()) == Approx(0).margin(1e-6));
}

TEST_CASE("a filter joint lets two bodies pass through each other, until it is destroyed") {
    Bench bench({0, 0});
    const BodyId a = bench.box({0, 0});
    const BodyId b = bench.box({0.5, 0});
    const JointId joint = bench.join(FilterJointDef{.body_a = a, .body_b = b});
    run_for(bench.world, 1);
    CHECK(bench.world.body(a)->position() == Position{0, 0});
    CHECK(bench.world.contact_begins().empty());
    bench.world.destroy_joint(joint).value();
    run_for(bench.world, 2);
    CHECK(bench.world.body(b)->position().x - bench.world.body(a)->position().x > 0.9);
}

TEST_CASE("a revolute limit may be turns away, and holds there") {
    Bench bench({0, 0});
    const BodyId wheel = add(bench.world, {}, Circle{});
    const JointId joint = bench.join(RevoluteJointDef{.body_a = bench.ground,
                                                      .body_b = wheel,
                                                      .enable_limit = true,
                                                      .lower_rad = -1,
                                                      .upper_rad = static_cast<float>(6 * kPiD + 1),
                                                      .enable_motor = true,
                                                      .motor_speed_rad_s = 8,
                                                      .max_motor_torque_nm = 50});
    double most = 0;
    for (int i = 0; i < 300; ++i) {
        bench.world.step(kStep_s).value();
        most = std::max(most, d(bench.world.joint(joint)->joint_angle()));
    }
    CHECK(most < 6 * kPiD + 1 + 0.02);
    CHECK(d(bench.world.joint(joint)->joint_angle()) == Approx(6 * kPiD + 1).margin(0.02));
}

TEST_CASE("the spring of a revolute joint swings with its frequency") {
    Bench bench({0, 0});
    const BodyId wheel = add(bench.world, {}, Circle{});
    const JointId joint = bench.join(RevoluteJointDef{.body_a = bench.ground,
                                                      .body_b = wheel,
                                                      .enable_spring = true,
                                                      .frequency_hz = 1.5f,
                                                      .target_rad = 0.5f});
    // From rest at -0.5 rad off: cos; after n whole periods it is back, after a half on the other side.
    run_for(bench.world, 2);
    CHECK(d(bench.world.joint(joint)->joint_angle()) == Approx(0).margin(5e-3));
    run_for(bench.world, 1.0 / 3);
    CHECK(d(bench.world.joint(joint)->joint_angle()) == Approx(1).margin(5e-3));
}

TEST_CASE("a joint breaks when it bears more than its strength, and says so") {
    for (const double share : {0.9, 1.1}) {
        Bench bench;
        const BodyId box = bench.box({0, -2});
        const double weight = 10 * bench.mass(box);
        const JointId joint =
            bench.join(DistanceJointDef{.body_a = bench.ground,
                                        .body_b = box,
                                        .length_m = 2,
                                        .strength = {.break_force_n = static_cast<float>(share * weight)},
                                        .user_data = 7});
        const std::vector<JointBreak> breaks = bench.breaks_of_2_s();
        REQUIRE(breaks.size() == (share < 1 ? 1 : 0));
        for (const JointBreak& event : breaks) {
            CHECK(event.joint == joint);
            CHECK(event.kind == JointKind::Distance);
            CHECK(event.body_b == box);
            CHECK(event.user_data == 7);
            CHECK(d(event.force_n.y) == Approx(weight).epsilon(0.01));
        }
        CHECK(bench.world.contains(joint) == (share > 1));
    }
}

TEST_CASE("a joint breaks when it bears more torque than its strength, and says so") {
    for (const double share : {0.9, 1.1}) {
        Bench bench;
        const BodyId arm = add(bench.world, {.position_m = {1, 0}}, Box{1, 0.1f});
        const double moment = 10 * bench.mass(arm);
        const JointId joint =
            bench.join(WeldJointDef{.body_a = bench.ground,
                                    .body_b = arm,
                                    .local_anchor_b_m = {-1, 0},
                                    .strength = {.break_torque_nm = static_cast<float>(share * moment)}});
        const std::vector<JointBreak> breaks = bench.breaks_of_2_s();
        REQUIRE(breaks.size() == (share < 1 ? 1 : 0));
        for (const JointBreak& event : breaks) {
            CHECK(event.joint == joint);
            CHECK(event.kind == JointKind::Weld);
            CHECK(d(length(event.point_m - Position{})) < 1e-3);
            CHECK(d(event.torque_nm) == Approx(moment).epsilon(0.1));
        }
        CHECK(bench.world.contains(joint) == (share > 1));
    }
}

TEST_CASE("frames that are turned step by step carry the angle of the joint along, over whole turns") {
    Bench bench({0, 0});
    const BodyId wheel = add(bench.world, {}, Circle{});
    const JointId joint = bench.join(RevoluteJointDef{.body_a = bench.ground, .body_b = wheel});
    auto def = std::get<RevoluteJointDef>(bench.world.joint(joint)->definition());
    for (int i = 0; i < 24; ++i) {
        def.local_angle_b_rad += 0.5f;
        bench.world.joint(joint)->redefine(def).value();
        step_times(bench.world, 2);
    }
    CHECK(d(bench.world.joint(joint)->joint_angle()) == Approx(12));
    // The same direction said otherwise is no turn.
    def.local_angle_b_rad = static_cast<float>(12 - 2 * kPiD);
    bench.world.joint(joint)->redefine(def).value();
    CHECK(d(bench.world.joint(joint)->joint_angle()) == Approx(12));
}

TEST_CASE("every parameter of a joint can be changed while it lives") {
    Bench bench;
    const BodyId box = bench.box({0, 0});
    const JointId joint = bench.join(WeldJointDef{.body_a = bench.ground, .body_b = box});
    run_for(bench.world, 0.5);
    auto def = std::get<WeldJointDef>(bench.world.joint(joint)->definition());
    def.linear_frequency_hz = 1;
    bench.world.joint(joint)->redefine(def).value();
    run_for(bench.world, 10);
    const double w = 2 * kPiD;
    CHECK(bench.world.body(box)->position().y == Approx(-10 / (w * w)).epsilon(1e-2));
    def.body_b = bench.box({5, 0});
    const auto refused = bench.world.joint(joint)->redefine(def);
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().message, Catch::Contains("weld_joint.body_a and .body_b cannot be changed"));
}

}  // namespace cairn::physics
