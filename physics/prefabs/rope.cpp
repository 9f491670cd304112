// The pins of many light links stretch under a heavy load, because what hangs below is felt link by link. One
// more joint from end to end, which only pulls when the rope is as long as it can be, bears that at once.
#include <cairn/physics/prefabs/rope.h>

#include "prefabs/hanging_line.h"
#include "prefabs/linked_bodies.h"

namespace cairn::physics {

Result<Rope> create_rope(World& world, const RopeDef& def) {
    Builder builder(world);
    const float distance = length(def.to_m - def.from_m);
    const float rope_m = def.length_m == 0 ? distance : def.length_m;
    builder.require({
        check::finite("rope.from_m", def.from_m),
        check::finite("rope.to_m", def.to_m),
        check_count("rope.links", def.links, 2, 10000),
        check::positive("rope.radius_m", as_double(def.radius_m)),
        check::not_negative("rope.friction_torque_nm", as_double(def.friction_torque_nm)),
        check::not_negative("rope.damping_1_s", as_double(def.damping_1_s)),
    });
    if (builder.good())
        builder.require({check::require(distance > 0.01f, "rope.to_m - rope.from_m", as_double(distance),
                                        "longer than 0.01 m")});
    if (builder.good())
        builder.require({
            check::require(rope_m >= distance && rope_m <= 100 * distance, "rope.length_m", as_double(rope_m),
                           "from the distance of the ends to 100 times that"),
            check::require(rope_m > 0.01f * static_cast<float>(def.links), "rope.length_m", as_double(rope_m),
                           "more than 0.01 m for each link"),
        });
    std::vector<Position> points;
    if (builder.good()) points = hanging_line(def.from_m, def.to_m, as_double(rope_m), def.links);
    LinkedBodies linked = link_bodies(
        builder, points,
        {.from = def.from,
         .to = def.to,
         .damping_1_s = def.damping_1_s,
         .friction_torque_nm = def.friction_torque_nm,
         .shape = &def.shape},
        [&](float length_m) {
            return Capsule{.a_m = {-length_m / 2, 0}, .b_m = {length_m / 2, 0}, .radius_m = def.radius_m};
        });
    if (builder.good()) {
        // Anchors at the very ends of the rope. What ends there without being held is the last link itself.
        const auto end_of = [&](const PrefabEnd& end, JointId pin, BodyId link) {
            return end.held ? world.joint(pin)->body_a() : link;
        };
        DistanceJointDef whole;
        whole.body_a = end_of(def.from, linked.pins.front(), linked.links.front());
        whole.body_b = end_of(def.to, linked.pins.back(), linked.links.back());
        whole.local_anchor_a_m = builder.local(whole.body_a, def.from_m);
        whole.local_anchor_b_m = builder.local(whole.body_b, def.to_m);
        whole.enable_spring = true;
        whole.frequency_hz = 0;
        whole.length_m = distance;
        whole.max_length_m = rope_m;
        whole.collide_connected = true;
        const bool moves = world.body(whole.body_a)->type() == BodyType::Dynamic ||
                           world.body(whole.body_b)->type() == BodyType::Dynamic;
        if (moves && whole.body_a != whole.body_b) builder.joint(whole);
    }
    return builder.finish(Rope{.links = std::move(linked.links), .length_m = rope_m});
}

}  // namespace cairn::physics
