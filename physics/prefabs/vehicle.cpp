// Driving, braking and coasting are three settings of the motors on the axles.
#include <cairn/physics/prefabs/vehicle.h>

#include "prefabs/builder.h"

namespace cairn::physics {

Result<Vehicle> create_vehicle(World& world, const VehicleDef& def) {
    Builder builder(world);
    builder.require({
        check::finite("vehicle.position_m", def.position_m),
        check::positive("vehicle.length_m", as_double(def.length_m)),
        check::positive("vehicle.height_m", as_double(def.height_m)),
        check::positive("vehicle.suspension_hz", as_double(def.suspension_hz)),
        check::not_negative("vehicle.suspension_damping", as_double(def.suspension_damping)),
        check::positive("vehicle.suspension_travel_m", as_double(def.suspension_travel_m)),
        check::not_negative("vehicle.drive_torque_nm", as_double(def.drive_torque_nm)),
        check::not_negative("vehicle.brake_torque_nm", as_double(def.brake_torque_nm)),
    });
    for (const VehicleWheelDef& wheel : def.wheels) {
        const check::Fault place = check::finite("vehicle.wheel.place_m", wheel.place_m);
        const check::Fault radius = check::positive("vehicle.wheel.radius_m", as_double(wheel.radius_m));
        builder.require({place, radius});
        if (place || radius) break;
    }
    Vehicle vehicle{.drive_torque_nm = def.drive_torque_nm, .brake_torque_nm = def.brake_torque_nm};
    vehicle.chassis = builder.body({.position_m = def.position_m});
    builder.shape(vehicle.chassis, Box{def.length_m / 2, def.height_m / 2}, def.chassis);
    for (const VehicleWheelDef& wheel : def.wheels) {
        const Position hub = def.position_m + wheel.place_m;
        const BodyId body = builder.body({.position_m = hub});
        builder.shape(body, Circle{.radius_m = wheel.radius_m}, def.tyre);
        WheelJointDef axle;
        builder.place(axle, vehicle.chassis, body, hub);
        axle.local_angle_a_rad = kPi / 2;
        axle.frequency_hz = def.suspension_hz;
        axle.damping_ratio = def.suspension_damping;
        axle.enable_limit = true;
        axle.lower_m = -def.suspension_travel_m;
        axle.upper_m = def.suspension_travel_m;
        vehicle.wheels.push_back({body, builder.joint(axle), wheel.radius_m, wheel.driven, wheel.braked});
    }
    return builder.finish(std::move(vehicle));
}

namespace {

/// Sets the motor of every wheel by what `torque_of` gives for it; 0 is off.
template <class TorqueOf>
Result<void> set_motors(World& world, const Vehicle& vehicle, float speed_m_s, TorqueOf&& torque_of) {
    if (auto fault = check::finite("vehicle.speed_m_s", as_double(speed_m_s))) return *fault;
    for (const Vehicle::Wheel& wheel : vehicle.wheels) {
        auto axle = world.joint(wheel.axle);
        if (!axle) return axle.error();
        const float torque = torque_of(wheel);
        // Rolling to the right is turning clockwise.
        if (auto set = axle->set_motor(torque > 0, -speed_m_s / wheel.radius_m, torque); !set) return set;
    }
    return {};
}

}  // namespace

Result<void> drive_vehicle(World& world, const Vehicle& vehicle, float speed_m_s) {
    return set_motors(world, vehicle, speed_m_s, [&](const Vehicle::Wheel& wheel) {
        return wheel.driven ? vehicle.drive_torque_nm : 0;
    });
}

Result<void> brake_vehicle(World& world, const Vehicle& vehicle) {
    return set_motors(world, vehicle, 0, [&](const Vehicle::Wheel& wheel) {
        return wheel.braked ? vehicle.brake_torque_nm : 0;
    });
}

Result<void> coast_vehicle(World& world, const Vehicle& vehicle) {
    return set_motors(world, vehicle, 0, [](const Vehicle::Wheel&) { return 0.0f; });
}

}  // namespace cairn::physics
