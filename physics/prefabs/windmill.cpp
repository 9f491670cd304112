// A wheel in its own plane is not turned by wind along that plane: whatever its shape, the torque of the
// pressure that World::apply_wind has is 0 as the mean over a turn. A real windmill faces the wind and its
// sails are pitched, so that they are carried as by air that runs round the axle: at the tip with the tip
// speed ratio times the speed of the wind. The sails feel that air as drag, at 2/3 of the tip's way from the
// axle.
#include <cairn/physics/prefabs/windmill.h>

#include "prefabs/builder.h"

namespace cairn::physics {
namespace {

constexpr float kPressed = 2.0f / 3;

}  // namespace

Result<Windmill> create_windmill(World& world, const WindmillDef& def) {
    Builder builder(world);
    builder.require({
        check::finite("windmill.position_m", def.position_m),
        check_count("windmill.sails", def.sails, 2, 24),
        check::positive("windmill.hub_radius_m", as_double(def.hub_radius_m)),
        check::positive("windmill.sail_length_m", as_double(def.sail_length_m)),
        check::positive("windmill.sail_width_m", as_double(def.sail_width_m)),
        check::positive("windmill.tip_speed_ratio", as_double(def.tip_speed_ratio)),
        check::not_negative("windmill.friction_torque_nm", as_double(def.friction_torque_nm)),
    });
    Windmill windmill;
    windmill.tip_m = def.hub_radius_m + def.sail_length_m;
    windmill.sail_area_m2 = static_cast<float>(def.sails) * def.sail_length_m * def.sail_width_m;
    windmill.tip_speed_ratio = def.clockwise ? -def.tip_speed_ratio : def.tip_speed_ratio;
    windmill.rotor = builder.body({.position_m = def.position_m});
    builder.shape(windmill.rotor, Circle{.radius_m = def.hub_radius_m}, def.shape);
    for (int i = 0; builder.good() && i < def.sails; ++i) {
        const double angle = 2 * as_double(kPi) * i / def.sails;
        const Vec2 middle =
            rotate(Rotation::from_angle(angle), {def.hub_radius_m + def.sail_length_m / 2, 0});
        builder.shape(windmill.rotor,
                      Box{.half_width_m = def.sail_length_m / 2,
                          .half_height_m = def.sail_width_m / 2,
                          .center_m = middle,
                          .angle_rad = static_cast<float>(angle)},
                      def.shape);
    }
    if (def.hub.held) {
        windmill.axle = builder.pin(builder.holder(def.hub, def.position_m), windmill.rotor, def.position_m,
                                    def.friction_torque_nm);
    }
    return builder.finish(std::move(windmill));
}

Result<void> blow_windmill(World& world, const Windmill& windmill, const WindDef& wind, float dt_s) {
    if (auto fault =
            check::first_of({check::finite("wind.velocity_m_s", wind.velocity_m_s),
                             check::not_negative("wind.density_kg_m2", as_double(wind.density_kg_m2)),
                             check::not_negative("wind.drag", as_double(wind.drag)),
                             check::positive("dt_s", as_double(dt_s))})) {
        return *fault;
    }
    auto rotor = world.body(windmill.rotor);
    if (!rotor) return rotor.error();
    const float arm_m = kPressed * windmill.tip_m;
    const float air_m_s = kPressed * windmill.tip_speed_ratio * length(wind.velocity_m_s);
    const float against_m_s = air_m_s - rotor->angular_velocity() * arm_m;
    const float inertia = rotor->mass_data().inertia_kg_m2;
    if (against_m_s == 0 || inertia <= 0) return {};
    // Divided so that a strong wind never turns the wheel faster than itself, as in World::apply_wind.
    const float pressure_per_speed = 0.5f * wind.density_kg_m2 * wind.drag * std::fabs(against_m_s);
    const float torque_per_speed = pressure_per_speed * windmill.sail_area_m2 * arm_m;
    return rotor->apply_torque(torque_per_speed * against_m_s /
                               (1 + dt_s * torque_per_speed * arm_m / inertia));
}

}  // namespace cairn::physics
