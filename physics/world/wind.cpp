// Drag and lift over the outline that faces the flow.
// An explicit force that grows with the square of the speed throws light bodies to and fro once it could turn
// their velocity round within a step. So it is divided by 1 + (the change of velocity that it would make) /
// (the velocity against the air): for a disc that is the exact solution of m dw/dt = -k |w| w over the step,
// w0 / (1 + k w0 dt / m).
#include "collide/outline_pieces.h"
#include "world/filtering.h"
#include "world/query_traversal.h"
#include "world/surface_forces.h"

namespace cairn::physics {
namespace {

struct Flow {
    Vec2 velocity;  // of the air against the centre of mass, in the body's frame
    float spin;     // of the body
    Vec2 center;    // of mass, in the body's frame

    [[nodiscard]] Vec2 at(Vec2 point) const { return velocity - cross(spin, point - center); }
};

void add_shape(SurfaceForce& sum, const Convex& shape, const Flow& flow, const WindDef& def) {
    // Round parts are met as if they did not turn with the body: a disc that spins is not pushed sideways.
    const bool is_disc = shape.count() == 1;
    const auto flow_at = [&](Vec2 point) { return is_disc ? flow.velocity : flow.at(point); };
    visit_facing_pieces(shape, flow_at, [&](const OutlinePiece& piece) {
        const Vec2 w = flow_at(piece.point);
        const float speed = length(w);
        if (speed <= 0) return;
        const Vec2 along = (1 / speed) * w;
        const float across_m = -dot(piece.area, along);
        if (across_m <= 0) return;
        const float pressure = 0.5f * def.density_kg_m2 * speed * speed;
        const Vec2 inward = -normalized(piece.area);
        const Vec2 sideways = inward - dot(inward, along) * along;
        const Vec2 force = pressure * across_m * (def.drag * along + def.lift * sideways);
        sum.linear += force;
        sum.angular += cross(piece.point - flow.center, force);
    });
}

float damped_share(float change, float most) {
    return change > 0 ? (most > 0 ? 1 / (1 + change / most) : 0) : 1;
}

}  // namespace

check::Fault validate(const WindDef& def) {
    const float fastest = std::max(std::fabs(def.velocity_m_s.x), std::fabs(def.velocity_m_s.y));
    return check::first_of({check::finite("wind.velocity_m_s", def.velocity_m_s),
                            check::require(fastest <= 1e6f, "wind.velocity_m_s", static_cast<double>(fastest),
                                           "at most 1e6 m/s along each axis"),
                            check::not_negative("wind.density_kg_m2", static_cast<double>(def.density_kg_m2)),
                            check::not_negative("wind.drag", static_cast<double>(def.drag)),
                            check::not_negative("wind.lift", static_cast<double>(def.lift))});
}

SurfaceForce wind_force(const Stores& stores, int body, const WindDef& def, float dt_s) {
    const BodyRecord& record = stores.bodies.slots[body];
    const BodyRows& rows = stores.bodies.rows_of(body);
    const Rotation q = stores.bodies.places[body].rotation;
    const Flow flow{inverse_rotate(q, def.velocity_m_s - rows.velocity[record.row]), rows.spin[record.row],
                    record.mass.center_m};
    SurfaceForce sum{stores.bodies.slots.id(body)};
    for (int shape = record.first_shape; shape != kNone; shape = stores.shapes[shape].next_of_body) {
        if (sees(stores, def.filter, shape)) add_shape(sum, stores.shapes[shape].convex(), flow, def);
    }
    const float rim = record.extent_m > 0 ? 1 / record.extent_m : 0;
    const float speed = length(flow.velocity) + std::fabs(flow.spin) * record.extent_m;
    sum.linear *= damped_share(dt_s * record.inverse_mass * length(sum.linear), speed);
    sum.angular *= damped_share(dt_s * record.inverse_inertia * std::fabs(sum.angular), speed * rim);
    sum.linear = rotate(q, sum.linear);
    return sum;
}

}  // namespace cairn::physics
