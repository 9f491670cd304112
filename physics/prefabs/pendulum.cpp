// A rod without mass is only where a pin sits: each bob is pinned a rod's length above its centre.
#include <cairn/physics/prefabs/pendulum.h>

#include "prefabs/builder.h"

namespace cairn::physics {

Result<Pendulum> create_pendulum(World& world, const PendulumDef& def) {
    Builder builder(world);
    builder.require({
        check::finite("pendulum.pivot_m", def.pivot_m),
        check_count("pendulum.bobs", def.bobs, 1, 100),
        check::positive("pendulum.rod_m", as_double(def.rod_m)),
        check::positive("pendulum.radius_m", as_double(def.radius_m)),
        check::finite("pendulum.angle_rad", as_double(def.angle_rad)),
        check::not_negative("pendulum.damping_1_s", as_double(def.damping_1_s)),
    });
    Pendulum pendulum;
    const Vec2 rod =
        builder.good() ? rotate(Rotation::from_angle(as_double(def.angle_rad)), {0, -def.rod_m}) : Vec2{};
    Position pivot = def.pivot_m;
    for (int i = 0; builder.good() && i < def.bobs; ++i) {
        const BodyId bob = builder.body({.position_m = pivot + rod,
                                         .angle_rad = as_double(def.angle_rad),
                                         .linear_damping_1_s = def.damping_1_s,
                                         .angular_damping_1_s = def.damping_1_s});
        builder.shape(bob, Circle{.radius_m = def.radius_m}, def.shape);
        pendulum.bobs.push_back(bob);
        pivot = pivot + rod;
    }
    pivot = def.pivot_m;
    BodyId above = def.pivot.held ? builder.holder(def.pivot, def.pivot_m) : BodyId{};
    for (const BodyId bob : pendulum.bobs) {
        if (above) builder.pin(above, bob, pivot, 0);
        above = bob;
        pivot = pivot + rod;
    }
    return builder.finish(std::move(pendulum));
}

}  // namespace cairn::physics
