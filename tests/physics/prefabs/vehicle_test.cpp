// A vehicle: driving, braking, standing.
#include <catch2/catch.hpp>

#include <cairn/physics/prefabs/vehicle.h>

#include "physics/support/resting.h"

namespace cairn::physics {
namespace {

using namespace test;

double speed(World& world, const Vehicle& vehicle) {
    return static_cast<double>(world.body(vehicle.chassis)->linear_velocity().x);
}

TEST_CASE("a vehicle reaches the speed that it is driven at, without slip, either way") {
    World world;
    add_ground(world);
    const Vehicle vehicle = create_vehicle(world, {.position_m = {0, 1}}).value();
    run_for(world, 1);
    for (const float driven : {5.0f, -8.0f}) {
        drive_vehicle(world, vehicle, driven).value();
        run_for(world, 5);
        CHECK(speed(world, vehicle) == Approx(driven).epsilon(0.01));
        for (const Vehicle::Wheel& wheel : vehicle.wheels) {
            const auto turn = static_cast<double>(world.body(wheel.body)->angular_velocity());
            CHECK(-turn * static_cast<double>(wheel.radius_m) == Approx(speed(world, vehicle)).epsilon(0.01));
        }
    }
}

TEST_CASE("a vehicle that coasts rolls on, and one that brakes stops and sleeps") {
    World world;
    add_ground(world);
    const Vehicle vehicle = create_vehicle(world, {.position_m = {0, 1}}).value();
    drive_vehicle(world, vehicle, 5).value();
    run_for(world, 4);
    coast_vehicle(world, vehicle).value();
    run_for(world, 2);
    CHECK(speed(world, vehicle) == Approx(5).epsilon(0.02));
    brake_vehicle(world, vehicle).value();
    CHECK(sleeps_within(world, 10));
}

TEST_CASE("a vehicle with its brakes on stands on a slope of 15 degrees, and rolls down without") {
    World world;
    const double slope = 15.0 / 180 * static_cast<double>(kPi);
    add(world, {.type = BodyType::Static, .angle_rad = slope}, Box{100, 1});
    const Vehicle vehicle = create_vehicle(world, {.position_m = {0, 2.2}}).value();
    brake_vehicle(world, vehicle).value();
    run_for(world, 3);
    const Position there = world.body(vehicle.chassis)->position();
    CHECK(sleeps_within(world, 10));
    CHECK(length(world.body(vehicle.chassis)->position() - there) < 0.01f);
    coast_vehicle(world, vehicle).value();
    run_for(world, 3);
    // Wheels are solid discs: a = g sin / (1 + the wheels' share of the mass / 2).
    double wheels = 0;
    for (const Vehicle::Wheel& wheel : vehicle.wheels) {
        wheels += static_cast<double>(world.body(wheel.body)->mass());
    }
    const double mass = wheels + static_cast<double>(world.body(vehicle.chassis)->mass());
    const double a = 10 * std::sin(slope) / (1 + wheels / mass / 2);
    CHECK(static_cast<double>(length(world.body(vehicle.chassis)->linear_velocity())) ==
          Approx(3 * a).epsilon(0.05));
}

}  // namespace
}  // namespace cairn::physics
