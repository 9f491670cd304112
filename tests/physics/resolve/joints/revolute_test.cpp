// The pin joint against the mechanics of pendulums and motors.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/precise.h"

namespace cairn::physics {
namespace {

using namespace test;

// The complete elliptic integral of the first kind, by the arithmetic-geometric mean (Gauss).
double elliptic_k(double modulus) {
    double a = 1;
    double b = std::sqrt(1 - modulus * modulus);
    for (int i = 0; i < 20; ++i) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return kPiD / (2 * a);
}

// A disc hung from the world's origin on a weightless arm.
struct Pendulum {
    World world{{.enable_sleep = false}};
    BodyId pivot;
    BodyId bob;
    JointId joint;

    Pendulum(double length_m, float radius_m, double angle_rad) {
        pivot = world.create_body({.type = BodyType::Static}).value();
        bob = add(world,
                  {.position_m = {length_m * std::sin(angle_rad), -length_m * std::cos(angle_rad)},
                   .angle_rad = angle_rad},
                  Circle{{}, radius_m});
        joint =
            world
                .create_joint(RevoluteJointDef{
                    .body_a = pivot, .body_b = bob, .local_anchor_b_m = {0, static_cast<float>(length_m)}})
                .value();
    }
    [[nodiscard]] double angle() const {
        const Position p = world.body(bob)->position();
        return std::atan2(p.x, -p.y);
    }
    double energy() {
        return kinetic_energy(*world.body(bob)) +
               d(world.body(bob)->mass()) * 10 * world.body(bob)->position().y;
    }
};

// A wheel pinned at its centre, without gravity.
struct Wheel {
    World world{{.gravity_m_s2 = {}}};
    BodyId hub;
    BodyId wheel;
    JointId joint;

    explicit Wheel(RevoluteJointDef def) {
        hub = world.create_body({.type = BodyType::Static}).value();
        wheel = add(world, {}, Circle{{}, 0.5f}, {.density_kg_m2 = 2});
        def.body_a = hub;
        def.body_b = wheel;
        joint = world.create_joint(def).value();
    }
    [[nodiscard]] double inertia() const { return d(world.body(wheel)->mass_data().inertia_kg_m2); }
    [[nodiscard]] double speed() const { return d(world.body(wheel)->angular_velocity()); }
};

}  // namespace

TEST_CASE("a pendulum swings with the period of the physical pendulum, for small and large angles") {
    for (const double start : {0.1, 0.7853981634, 1.5707963268}) {
        const double length = 2;
        const double radius = 0.25;
        Pendulum pendulum(length, static_cast<float>(radius), start);
        std::vector<double> crossings;
        double before = pendulum.angle();
        for (int i = 1; crossings.size() < 11; ++i) {
            REQUIRE(i < 3000);
            pendulum.world.step(kStep_s).value();
            const double now = pendulum.angle();
            if (before > 0 && now <= 0) crossings.push_back((i - 1 + before / (before - now)) / 60);
            before = now;
        }
        const double period = (crossings.back() - crossings.front()) / 10;
        // m L^2 + m r^2 / 2 about the pivot, against the weight m g at L.
        const double effective_length = length + radius * radius / (2 * length);
        const double expected = 4 * std::sqrt(effective_length / 10) * elliptic_k(std::sin(start / 2));
        INFO("from " << start << " rad");
        // Semi-implicit Euler keeps the frequency of an oscillator to (w h)^2 / 24.
        CHECK(period == Approx(expected).epsilon(5e-4));
    }
}

TEST_CASE("a pendulum gains no energy, loses little of it, and keeps its length") {
    Pendulum pendulum(2, 0.25f, 1.5);
    const double lowest = d(pendulum.world.body(pendulum.bob)->mass()) * 10 * -2;
    const double start = pendulum.energy() - lowest;
    double most = 0;
    double stretched = 0;
    for (int i = 0; i < 1200; ++i) {
        pendulum.world.step(kStep_s).value();
        most = std::max(most, pendulum.energy() - lowest);
        const Position p = pendulum.world.body(pendulum.bob)->position();
        stretched = std::max(stretched, std::fabs(std::sqrt(p.x * p.x + p.y * p.y) - 2));
    }
    CHECK(most <= start * 1.01);
    CHECK(pendulum.energy() - lowest > start * 0.95);
    CHECK(stretched < 0.001);
}

TEST_CASE("a hanging joint carries the weight, and says so") {
    Pendulum pendulum(2, 0.25f, 0);
    run_for(pendulum.world, 1);
    const double weight = 10 * d(pendulum.world.body(pendulum.bob)->mass());
    const Vec2 force = pendulum.world.joint(pendulum.joint)->reaction_force();
    CHECK(d(force.x) == Approx(0).margin(1e-3 * weight));
    CHECK(d(force.y) == Approx(weight).epsilon(1e-3));
    CHECK(length(pendulum.world.joint(pendulum.joint)->anchor_b() -
                 pendulum.world.joint(pendulum.joint)->anchor_a()) < 1e-3f);
}

TEST_CASE("a joint to which the hanging body is body a reports the force on body b, the support") {
    World world;
    const BodyId support = world.create_body({.type = BodyType::Static}).value();
    const BodyId weight = add(world, {.position_m = {0, -1}}, Circle{{}, 0.25f});
    const JointId joint =
        world.create_joint(RevoluteJointDef{.body_a = weight, .body_b = support, .local_anchor_a_m = {0, 1}})
            .value();
    run_for(world, 0.25);
    CHECK(d(world.joint(joint)->reaction_force().y) ==
          Approx(-10 * d(world.body(weight)->mass())).epsilon(1e-3));
}

TEST_CASE("a motor accelerates by torque over inertia until it has its speed") {
    Wheel wheel({.enable_motor = true, .motor_speed_rad_s = 6, .max_motor_torque_nm = 0.5f});
    const double acceleration = 0.5 / wheel.inertia();
    for (int i = 1; i <= 180; ++i) {
        wheel.world.step(kStep_s).value();
        INFO("step " << i);
        CHECK(wheel.speed() == Approx(std::min(acceleration * i / 60, 6.0)).epsilon(1e-4));
        const double torque = d(wheel.world.joint(wheel.joint)->reaction_torque());
        if (acceleration * i / 60 < 5.9) CHECK(torque == Approx(0.5).epsilon(1e-4));
        if (acceleration * (i - 1) / 60 > 6.1) CHECK(torque == Approx(0).margin(1e-4));
    }
    CHECK(wheel.speed() == Approx(6).epsilon(1e-5));
}

TEST_CASE("a motor turns backward, stops again, and lets go when it is switched off") {
    Wheel wheel({.enable_motor = true, .motor_speed_rad_s = -3, .max_motor_torque_nm = 100});
    run_for(wheel.world, 0.5);
    CHECK(wheel.speed() == Approx(-3));
    wheel.world.joint(wheel.joint)->set_motor(true, 0, 100).value();
    run_for(wheel.world, 0.5);
    CHECK(wheel.speed() == Approx(0).margin(1e-5));
    wheel.world.body(wheel.wheel)->set_angular_velocity(5).value();
    wheel.world.joint(wheel.joint)->set_motor(false, 0, 100).value();
    run_for(wheel.world, 0.5);
    CHECK(wheel.speed() == Approx(5));
}

TEST_CASE("a motor too weak for the weight does not lift it, a stronger one does") {
    for (const bool strong : {false, true}) {
        World world({.enable_sleep = false});
        const BodyId pivot = world.create_body({.type = BodyType::Static}).value();
        const BodyId arm = add(world, {}, Box{1, 0.1f, {1, 0}});  // 0.4 kg, its weight at 1 m: 4 N m
        const JointId joint = world
                                  .create_joint(RevoluteJointDef{.body_a = pivot,
                                                                 .body_b = arm,
                                                                 .enable_motor = true,
                                                                 .motor_speed_rad_s = 1,
                                                                 .max_motor_torque_nm = strong ? 4.4f : 3.6f})
                                  .value();
        run_for(world, 0.5);
        INFO("strong: " << strong);
        CHECK((world.joint(joint)->joint_angle() > 0) == strong);
    }
}

TEST_CASE("limits stop a joint at both ends and hold a load there") {
    World world({.enable_sleep = false});
    const BodyId pivot = world.create_body({.type = BodyType::Static}).value();
    const BodyId arm = add(world, {}, Box{1, 0.1f, {1, 0}});
    const JointId joint =
        world
            .create_joint(RevoluteJointDef{
                .body_a = pivot, .body_b = arm, .enable_limit = true, .lower_rad = -0.4f, .upper_rad = 0.3f})
            .value();
    for (int i = 0; i < 180; ++i) {
        world.step(kStep_s).value();
        REQUIRE(world.joint(joint)->joint_angle() > -0.4f - 0.02f);
    }
    // The weight of 4 N m, times the cosine of the slope, and no motion.
    CHECK(d(world.joint(joint)->joint_angle()) == Approx(-0.4).margin(5e-3));
    CHECK(d(world.joint(joint)->reaction_torque()) == Approx(4 * std::cos(0.4)).epsilon(5e-3));
    world.set_gravity({0, 10}).value();
    for (int i = 0; i < 180; ++i) {
        world.step(kStep_s).value();
        REQUIRE(world.joint(joint)->joint_angle() < 0.3f + 0.02f);
    }
    CHECK(d(world.joint(joint)->joint_angle()) == Approx(0.3).margin(5e-3));
    CHECK(d(world.joint(joint)->reaction_torque()) == Approx(-4 * std::cos(0.3)).epsilon(5e-3));
}

TEST_CASE("a motor of any strength stops at a limit, in a lane and as a scalar") {
    const float torque_nm = GENERATE(1e2f, 1e4f, 1e6f);
    const bool as_slide = GENERATE(false, true);
    World world({.gravity_m_s2 = {}, .enable_sleep = false});
    const BodyId wall = world.create_body({.type = BodyType::Static}).value();
    const BodyId arm = add(world, {}, Box{0.5f, 0.1f});
    const JointId id = as_slide ? world
                                      .create_joint(PrismaticJointDef{.body_a = wall,
                                                                      .body_b = arm,
                                                                      .enable_limit = true,
                                                                      .lower_m = -1,
                                                                      .upper_m = 0.5f,
                                                                      .enable_motor = true,
                                                                      .motor_speed_m_s = 3,
                                                                      .max_motor_force_n = torque_nm})
                                      .value()
                                : world
                                      .create_joint(RevoluteJointDef{.body_a = wall,
                                                                     .body_b = arm,
                                                                     .enable_limit = true,
                                                                     .lower_rad = -1,
                                                                     .upper_rad = 0.5f,
                                                                     .enable_motor = true,
                                                                     .motor_speed_rad_s = 3,
                                                                     .max_motor_torque_nm = torque_nm})
                                      .value();
    CAPTURE(torque_nm, as_slide);
    const auto gone = [&] {
        return static_cast<double>(as_slide ? world.joint(id)->translation()
                                            : world.joint(id)->joint_angle());
    };
    for (int i = 0; i < 120; ++i) {
        world.step(kStep_s).value();
        REQUIRE(gone() < 0.5 + 1e-3);
    }
    CHECK(gone() == Approx(0.5).margin(1e-3));
}

TEST_CASE("limits that are equal hold the angle, and changed limits take effect") {
    World world({.enable_sleep = false});
    const BodyId pivot = world.create_body({.type = BodyType::Static}).value();
    const BodyId arm = add(world, {}, Box{1, 0.1f, {1, 0}});
    const JointId joint =
        world.create_joint(RevoluteJointDef{.body_a = pivot, .body_b = arm, .enable_limit = true}).value();
    run_for(world, 1);
    CHECK(d(world.joint(joint)->joint_angle()) == Approx(0).margin(5e-3));
    world.joint(joint)->set_limits(true, -1, 1).value();
    run_for(world, 3);
    CHECK(d(world.joint(joint)->joint_angle()) == Approx(-1).margin(5e-3));
    world.joint(joint)->set_limits(false, -1, 1).value();
    run_for(world, 0.5);
    CHECK(world.joint(joint)->joint_angle() < -1.2f);
}

TEST_CASE("the joint angle counts from where the frames agree") {
    World world({.gravity_m_s2 = {}});
    const BodyId a = add(world, {.angle_rad = 0.5}, Circle{});
    const BodyId b = add(world, {.position_m = {5, 0}, .angle_rad = 1.2}, Circle{});
    const JointId joint =
        world
            .create_joint(RevoluteJointDef{
                .body_a = a, .body_b = b, .local_anchor_a_m = {3, 0}, .local_angle_a_rad = 0.2f})
            .value();
    CHECK(d(world.joint(joint)->joint_angle()) == Approx(0.5));
    CHECK(world.joint(joint)->kind() == JointKind::Revolute);
    CHECK(world.joint(joint)->body_a() == a);
    CHECK(world.joint(joint)->body_b() == b);
}

TEST_CASE("two free bodies pinned together keep their momentum and their pin") {
    World world({.gravity_m_s2 = {}, .enable_sleep = false});
    const BodyId a = add(world, {.position_m = {-1, 0}, .linear_velocity_m_s = {0, 1}}, Box{1, 0.2f});
    const BodyId b = add(world, {.position_m = {1, 0}, .linear_velocity_m_s = {2, -1}}, Box{1, 0.2f},
                         {.density_kg_m2 = 3});
    const JointId joint =
        world
            .create_joint(RevoluteJointDef{
                .body_a = a, .body_b = b, .local_anchor_a_m = {1, 0}, .local_anchor_b_m = {-1, 0}})
            .value();
    const auto momentum = [&] {
        return world.body(a)->mass() * world.body(a)->linear_velocity() +
               world.body(b)->mass() * world.body(b)->linear_velocity();
    };
    const Vec2 before = momentum();
    double apart = 0;
    for (int i = 0; i < 300; ++i) {
        world.step(kStep_s).value();
        if (i > 30)
            apart =
                std::max(apart, d(length(world.joint(joint)->anchor_b() - world.joint(joint)->anchor_a())));
    }
    // 1200 substeps of opposite impulses, rounded to 2^-24 of velocities of 2 m/s.
    CHECK(length(momentum() - before) < 1e-3f);
    CHECK(apart < 0.005);
}

TEST_CASE("a chain of twenty links with a heavy ball holds together") {
    World world;
    BodyId previous = world.create_body({.type = BodyType::Static}).value();
    Vec2 anchor{0, 0};
    std::vector<JointId> joints;
    for (int i = 0; i < 20; ++i) {
        const BodyId link =
            add(world, {.position_m = {0.25 + 0.5 * i, 0}}, Capsule{{-0.2f, 0}, {0.2f, 0}, 0.05f});
        joints.push_back(world
                             .create_joint(RevoluteJointDef{.body_a = previous,
                                                            .body_b = link,
                                                            .local_anchor_a_m = anchor,
                                                            .local_anchor_b_m = {-0.25f, 0}})
                             .value());
        previous = link;
        anchor = {0.25f, 0};
    }
    const BodyId ball = add(world, {.position_m = {10.5, 0}}, Circle{}, {.density_kg_m2 = 0.5f});
    joints.push_back(world
                         .create_joint(RevoluteJointDef{.body_a = previous,
                                                        .body_b = ball,
                                                        .local_anchor_a_m = anchor,
                                                        .local_anchor_b_m = {-0.5f, 0}})
                         .value());
    double apart = 0;
    for (int i = 0; i < 600; ++i) {
        world.step(kStep_s).value();
        for (const JointId id : joints)
            apart = std::max(apart, d(length(world.joint(id)->anchor_b() - world.joint(id)->anchor_a())));
    }
    CHECK(apart < 0.05);  // a tenth of a link, in the worst jerk
}

// Joints that are few among many bodies are told apart from contacts at their own bodies only, others at all.
TEST_CASE("a joint between bodies on the ground does the same among few bodies and among many") {
    const auto way = [](int others) {
        World world({.joint_solver = JointSolver::Sweeping, .enable_sleep = false});
        add(world, {.type = BodyType::Static}, Box{1'500, 0.5f, {0, -0.5f}});
        for (int i = 0; i < others; ++i) add(world, {.position_m = {50.0 + i, 0.3}}, Box{0.3f, 0.3f});
        const BodyId left = add(world, {.position_m = {0, 0.5}}, Box{0.5f, 0.3f});
        const BodyId right =
            add(world, {.position_m = {1, 0.5}, .linear_velocity_m_s = {3, 0}}, Box{0.5f, 0.3f});
        world
            .create_joint(RevoluteJointDef{.body_a = left,
                                           .body_b = right,
                                           .local_anchor_a_m = {0.5f, 0},
                                           .local_anchor_b_m = {-0.5f, 0}})
            .value();
        std::vector<Position> positions;
        for (int step = 0; step < 60; ++step) {
            world.step(kStep_s).value();
            for (const BodyId body : {left, right}) positions.push_back(world.body(body)->position());
        }
        return positions;
    };
    const std::vector<Position> among_few = way(0);
    const std::vector<Position> among_many = way(1'100);
    for (std::size_t i = 0; i < among_few.size(); ++i) {
        INFO("after step " << i / 2);
        CHECK(length(among_many[i] - among_few[i]) < 1e-4f);
    }
    CHECK(among_few.back().x > 1.1);  // it slid, by .3 m
}

}  // namespace cairn::physics
