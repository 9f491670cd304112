// Planks are boxes a little shorter than the way from pin to pin, so that neighbours can turn.
#include <cairn/physics/prefabs/bridge.h>

#include "prefabs/hanging_line.h"
#include "prefabs/linked_bodies.h"

namespace cairn::physics {

Result<Bridge> create_bridge(World& world, const BridgeDef& def) {
    Builder builder(world);
    const float distance = length(def.to_m - def.from_m);
    builder.require({
        check::finite("bridge.from_m", def.from_m),
        check::finite("bridge.to_m", def.to_m),
        check_count("bridge.planks", def.planks, 2, 10000),
        check::within("bridge.slack", as_double(def.slack), 0, 1),
        check::positive("bridge.thickness_m", as_double(def.thickness_m)),
        check::not_negative("bridge.friction_torque_nm", as_double(def.friction_torque_nm)),
        check::not_negative("bridge.damping_1_s", as_double(def.damping_1_s)),
    });
    if (builder.good())
        builder.require(
            {check::require(distance > 0.01f * static_cast<float>(def.planks), "bridge.to_m - bridge.from_m",
                            as_double(distance), "longer than 0.01 m for each plank")});
    std::vector<Position> points;
    if (builder.good()) {
        points = hanging_line(def.from_m, def.to_m, as_double(distance * (1 + def.slack)), def.planks);
    }
    LinkedBodies linked =
        link_bodies(builder, points,
                    {.from = def.from,
                     .to = def.to,
                     .damping_1_s = def.damping_1_s,
                     .friction_torque_nm = def.friction_torque_nm,
                     .strength = def.strength,
                     .shape = &def.shape},
                    [&](float length_m) {
                        return Box{.half_width_m = 0.49f * length_m, .half_height_m = def.thickness_m / 2};
                    });
    return builder.finish(Bridge{.planks = std::move(linked.links), .pins = std::move(linked.pins)});
}

}  // namespace cairn::physics
