// Bodies first, so that they are the first of the prefab; then what holds the ends, then the pins in order.
#include "prefabs/linked_bodies.h"

namespace cairn::physics {

LinkedBodies link_bodies(Builder& builder, const std::vector<Position>& points, const LinkingDef& def,
                         const std::function<Geometry(float length_m)>& outline) {
    LinkedBodies made;
    if (!builder.good()) return made;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec2 way = points[i + 1] - points[i];
        const BodyId link = builder.body(
            {.position_m = points[i] + 0.5f * way,
             .angle_rad = deterministic::atan2(static_cast<double>(way.y), static_cast<double>(way.x)),
             .linear_damping_1_s = def.damping_1_s,
             .angular_damping_1_s = def.damping_1_s});
        builder.shape(link, outline(length(way)), *def.shape);
        made.links.push_back(link);
    }
    const auto pin = [&](BodyId a, BodyId b, Position point) {
        made.pins.push_back(builder.pin(a, b, point, def.friction_torque_nm, def.strength));
    };
    if (def.from.held) pin(builder.holder(def.from, points.front()), made.links.front(), points.front());
    for (std::size_t i = 1; i < made.links.size(); ++i) pin(made.links[i - 1], made.links[i], points[i]);
    if (def.to.held) pin(builder.holder(def.to, points.back()), made.links.back(), points.back());
    return made;
}

}  // namespace cairn::physics
