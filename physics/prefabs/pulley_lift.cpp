// Both platforms slide on upright guides, whose limits keep them from the wheels; the pulley does the rest.
#include <cairn/physics/prefabs/pulley_lift.h>

#include "prefabs/builder.h"

namespace cairn::physics {

Result<PulleyLift> create_pulley_lift(World& world, const PulleyLiftDef& def) {
    Builder builder(world);
    builder.require({
        check::finite("pulley_lift.position_m", def.position_m),
        check::positive("pulley_lift.width_m", as_double(def.width_m)),
        check::positive("pulley_lift.thickness_m", as_double(def.thickness_m)),
        check::positive("pulley_lift.travel_m", as_double(def.travel_m)),
        check::positive("pulley_lift.ratio", as_double(def.ratio)),
    });
    if (builder.good()) {
        builder.require({
            check::require(std::isfinite(def.distance_m) && def.distance_m > def.width_m,
                           "pulley_lift.distance_m", as_double(def.distance_m),
                           "finite and greater than width_m"),
            check::require(std::isfinite(def.rope_m) && def.rope_m > def.travel_m, "pulley_lift.rope_m",
                           as_double(def.rope_m), "finite and greater than travel_m"),
        });
    }
    PulleyLift lift;
    const BodyId frame = builder.holder({}, def.position_m);
    const auto add_platform = [&](float x_m, const ShapeDef& shape) {
        const Position place = def.position_m + Vec2{x_m, 0};
        const BodyId platform = builder.body({.position_m = place});
        builder.shape(platform, Box{def.width_m / 2, def.thickness_m / 2}, shape);
        PrismaticJointDef guide;
        builder.place(guide, frame, platform, place);
        guide.local_angle_a_rad = guide.local_angle_b_rad = kPi / 2;
        guide.enable_limit = true;
        guide.lower_m = -def.travel_m;
        guide.upper_m = def.travel_m;
        builder.joint(guide);
        return platform;
    };
    const float side = def.distance_m / 2;
    lift.left = add_platform(-side, def.left);
    lift.right = add_platform(side, def.right);
    lift.pulley = builder.joint(PulleyJointDef{.body_a = lift.left,
                                               .body_b = lift.right,
                                               .wheel_a_m = def.position_m + Vec2{-side, def.rope_m},
                                               .wheel_b_m = def.position_m + Vec2{side, def.rope_m},
                                               .ratio = def.ratio});
    return builder.finish(std::move(lift));
}

}  // namespace cairn::physics
