// Where two wheels meet, their rims run at one speed: r1 w1 = -r2 w2, so angle 1 + (r2 / r1) angle 2 stays.
#include <cairn/physics/prefabs/gear_train.h>

#include "prefabs/builder.h"

namespace cairn::physics {

Result<GearTrain> create_gear_train(World& world, const GearTrainDef& def) {
    Builder builder(world);
    builder.require({
        check::finite("gear_train.position_m", def.position_m),
        check::finite("gear_train.direction", def.direction),
        check_count("gear_train.radii_m.size()", static_cast<int>(def.radii_m.size()), 1, 1000),
        check::finite("gear_train.motor_speed_rad_s", as_double(def.motor_speed_rad_s)),
        check::not_negative("gear_train.max_motor_torque_nm", as_double(def.max_motor_torque_nm)),
    });
    if (builder.good())
        builder.require({check::positive("gear_train.direction", as_double(length(def.direction)))});
    for (const float radius : def.radii_m) {
        const check::Fault fault = check::positive("gear_train.radii_m", as_double(radius));
        builder.require({fault});
        if (fault) break;
    }
    GearTrain train;
    const Vec2 along = builder.good() ? normalized(def.direction) : Vec2{};
    const BodyId frame = builder.holder({}, def.position_m);
    Position center = def.position_m;
    for (std::size_t i = 0; builder.good() && i < def.radii_m.size(); ++i) {
        if (i > 0) center = center + (def.radii_m[i - 1] + def.radii_m[i]) * along;
        const BodyId wheel = builder.body({.position_m = center});
        builder.shape(wheel, Circle{.radius_m = def.radii_m[i]}, def.shape);
        RevoluteJointDef axle;
        builder.place(axle, frame, wheel, center);
        if (i == 0) {
            axle.enable_motor = def.max_motor_torque_nm > 0;
            axle.motor_speed_rad_s = def.motor_speed_rad_s;
            axle.max_motor_torque_nm = def.max_motor_torque_nm;
        }
        train.wheels.push_back(wheel);
        train.axles.push_back(builder.joint(axle));
    }
    for (std::size_t i = 1; i < train.axles.size(); ++i) {
        builder.joint(GearJointDef{.joint_1 = train.axles[i - 1],
                                   .joint_2 = train.axles[i],
                                   .ratio = def.radii_m[i] / def.radii_m[i - 1],
                                   .collide_connected = false});
    }
    return builder.finish(std::move(train));
}

}  // namespace cairn::physics
