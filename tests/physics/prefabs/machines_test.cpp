// Pendulum, windmill, elevator, gear train and pulley lift, each against its formula.
#include <catch2/catch.hpp>

#include <cairn/physics/prefabs/all.h>

#include "physics/support/resting.h"

namespace cairn::physics {
namespace {

using namespace test;

TEST_CASE("a pendulum swings with the period of its length") {
    World world;
    const Pendulum pendulum =
        create_pendulum(world, {.rod_m = 2, .radius_m = 0.2f, .angle_rad = 0.1f}).value();
    int crossings = 0;
    double first_s = 0;
    double last_s = 0;
    double x = world.body(pendulum.bobs[0])->position().x;
    for (int i = 1; i <= 1800; ++i) {
        world.step(kStep_s).value();
        const double next = world.body(pendulum.bobs[0])->position().x;
        if ((next > 0) != (x > 0)) {
            last_s = (i - 1 + x / (x - next)) / 60.0;
            if (crossings++ == 0) first_s = last_s;
        }
        x = next;
    }
    REQUIRE(crossings > 10);
    // A disc on a rod: T = 2 pi sqrt((l^2 + r^2 / 2) / (g l)), and (1 + angle^2 / 16) for its swing.
    const double expected = 2 * 3.14159265 * std::sqrt((4 + 0.02) / 20) * (1 + 0.01 / 16);
    CHECK(2 * (last_s - first_s) / (crossings - 1) == Approx(expected).epsilon(0.003));
}

TEST_CASE("a double pendulum keeps its rods' lengths, and a damped one hangs still and sleeps") {
    World world;
    const Pendulum pendulum =
        create_pendulum(world, {.bobs = 2, .angle_rad = 2.5f, .damping_1_s = 1}).value();
    for (int i = 0; i < 300; ++i) {
        world.step(kStep_s).value();
        const Position upper = world.body(pendulum.bobs[0])->position();
        const Position lower = world.body(pendulum.bobs[1])->position();
        CHECK(length(upper - Position{}) == Approx(1).epsilon(0.01));
        CHECK(length(lower - upper) == Approx(1).epsilon(0.01));
    }
    CHECK(sleeps_within(world, 20));
    CHECK(world.body(pendulum.bobs[1])->position().y == Approx(-2).margin(0.02));
}

TEST_CASE(
    "a windmill turns as fast as wind and friction let it, the way that it is built, and stops without") {
    for (const bool clockwise : {false, true}) {
        World world;
        const Windmill mill =
            create_windmill(world, {.clockwise = clockwise, .friction_torque_nm = 2}).value();
        for (int i = 0; i < 1800; ++i) {
            blow_windmill(world, mill, {.velocity_m_s = {-6, 0}}, kStep_s).value();
            world.step(kStep_s).value();
        }
        // 4 sails of 0.8 m2 at r = 2/3 of 2.3 m: friction = 1/2 rho A r (v - w r)^2, with v = 2/3 of 12 m/s.
        const double r = 2.3 * 2 / 3;
        const double expected = (8 - std::sqrt(2 * 2 / (1.2 * 3.2 * r))) / r;
        const double turning = static_cast<double>(world.body(mill.rotor)->angular_velocity());
        CHECK(turning == Approx(clockwise ? -expected : expected).epsilon(0.01));
        CHECK(length(world.body(mill.rotor)->position() - Position{}) < 0.01f);
        CHECK(sleeps_within(world, 60));
    }
}

TEST_CASE("an elevator goes to each floor with its load, in the time of its speed, and sleeps there") {
    World world;
    const Elevator elevator = create_elevator(world, {.floors_m = {0, 3, 7}, .speed_m_s = 2}).value();
    const BodyId crate = add(world, {.position_m = {0, 0.5}}, Box{}, {.density_kg_m2 = 50});
    run_for(world, 1);
    const float floors[] = {7, 3, 0, 3};
    int floor_numbers[] = {2, 1, 0, 1};
    float at = 0;
    for (int i = 0; i < 4; ++i) {
        send_elevator(world, elevator, floor_numbers[i]).value();
        const double time = static_cast<double>(std::fabs(floors[i] - at) / 2);
        run_for(world, 0.8 * time);
        CHECK(!is_elevator_at(world, elevator, floor_numbers[i]).value());
        run_for(world, 0.2 * time + 1.5);  // the crate hops when it stops
        CHECK(is_elevator_at(world, elevator, floor_numbers[i]).value());
        at = floors[i];
        CHECK(world.body(crate)->position().y == Approx(at + 0.5f).margin(0.02));
    }
    CHECK(sleeps_within(world, 10));
    CHECK(send_elevator(world, elevator, 3).error().message ==
          "elevator.floor is 3, but must be from 0 to 2");
}

TEST_CASE("the wheels of a gear train turn by the ratio of their radii") {
    World world;
    const GearTrain train = create_gear_train(world, {.radii_m = {0.5f, 1.25f, 0.25f, 0.8f},
                                                      .motor_speed_rad_s = 3,
                                                      .max_motor_torque_nm = 1000})
                                .value();
    run_for(world, 20);
    const auto angle = [&](std::size_t i) {
        return static_cast<double>(world.joint(train.axles[i])->joint_angle());
    };
    CHECK(angle(0) == Approx(60).epsilon(0.01));
    CHECK(angle(1) / angle(0) == Approx(-0.5 / 1.25).epsilon(0.001));
    CHECK(angle(2) / angle(0) == Approx(0.5 / 0.25).epsilon(0.001));
    CHECK(angle(3) / angle(0) == Approx(-0.5 / 0.8).epsilon(0.001));
}

TEST_CASE("a gear train without a motor sleeps") {
    World world;
    create_gear_train(world, {}).value();
    CHECK(sleeps_within(world, 2));
}

TEST_CASE("a balanced lift stands and sleeps, with a tackle too") {
    for (const float ratio : {1.0f, 3.0f}) {
        World world;
        const PulleyLift lift =
            create_pulley_lift(world, {.ratio = ratio, .right = {.density_kg_m2 = ratio}}).value();
        CHECK(sleeps_within(world, 10));
        CHECK(world.body(lift.left)->position().y == Approx(0).margin(0.01));
        CHECK(world.body(lift.right)->position().y == Approx(0).margin(0.01));
    }
}

TEST_CASE("a lift moves as Atwood's machine, until its stop") {
    World world;
    const PulleyLift lift =
        create_pulley_lift(world, {.left = {.density_kg_m2 = 2}, .right = {.density_kg_m2 = 3}}).value();
    run_for(world, 1);
    // a = g (m2 - m1) / (m1 + m2) = 2 m/s^2: 1 m in the first second.
    CHECK(world.body(lift.left)->position().y == Approx(1).epsilon(0.03));
    CHECK(world.body(lift.right)->position().y == Approx(-1).epsilon(0.03));
    CHECK(sleeps_within(world, 10));
    CHECK(world.body(lift.right)->position().y == Approx(-2).margin(0.02));
}

}  // namespace
}  // namespace cairn::physics
