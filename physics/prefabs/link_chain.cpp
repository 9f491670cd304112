// Links are capsules whose round ends meet at the pins.
#include <cairn/physics/prefabs/link_chain.h>

#include "prefabs/linked_bodies.h"

namespace cairn::physics {

Result<LinkChain> create_link_chain(World& world, const LinkChainDef& def) {
    Builder builder(world);
    builder.require({
        check::finite("link_chain.start_m", def.start_m),
        check::finite("link_chain.direction", def.direction),
        check_count("link_chain.links", def.links, 1, 10000),
        check::require(std::isfinite(def.link_length_m) && def.link_length_m > 0.01f,
                       "link_chain.link_length_m", as_double(def.link_length_m),
                       "finite and greater than 0.01 m"),
        check::positive("link_chain.thickness_m", as_double(def.thickness_m)),
        check::not_negative("link_chain.friction_torque_nm", as_double(def.friction_torque_nm)),
        check::not_negative("link_chain.damping_1_s", as_double(def.damping_1_s)),
    });
    if (builder.good())
        builder.require({check::positive("link_chain.direction", as_double(length(def.direction)))});
    std::vector<Position> points;
    if (builder.good()) {
        const Vec2 link = def.link_length_m * normalized(def.direction);
        for (int i = 0; i <= def.links; ++i) points.push_back(def.start_m + static_cast<float>(i) * link);
    }
    LinkedBodies linked = link_bodies(builder, points,
                                      {.from = def.start,
                                       .to = def.end,
                                       .damping_1_s = def.damping_1_s,
                                       .friction_torque_nm = def.friction_torque_nm,
                                       .shape = &def.shape},
                                      [&](float length_m) {
                                          return Capsule{.a_m = {-length_m / 2, 0},
                                                         .b_m = {length_m / 2, 0},
                                                         .radius_m = def.thickness_m / 2};
                                      });
    return builder.finish(LinkChain{.links = std::move(linked.links)});
}

}  // namespace cairn::physics
