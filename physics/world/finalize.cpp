// New places of bodies and boxes.
#include "world/finalize.h"

#include <algorithm>

#include <cairn/physics/tuning.h>

namespace cairn::physics {
namespace {

float next_rest_time(const BodyRecord& record, Vec2 v, float w, float rest_time, float dt_s) {
    if (!record.allow_sleep) return 0;
    if (record.type == BodyType::Kinematic) return v == Vec2{} && w == 0 ? rest_time + dt_s : 0;
    const float fastest_point = std::max(length(v), std::fabs(w) * record.extent_m);
    return fastest_point < record.sleep_speed_m_s ? rest_time + dt_s : 0;
}

bool is_finite(const Motions& motions, int row) {
    const PoseRow& pose = motions.pose[row];
    const VelocityRow& velocity = motions.velocity[row];
    // A sum is finite only if its terms are (or are too large to be anything but a fault).
    return std::isfinite(pose.d.x + pose.d.y + pose.theta + velocity.v.x + velocity.v.y + velocity.w);
}

// A body whose motion is no number any more is put back to where the step found it, and stopped. Its box
// would be found by nobody otherwise, and what it touches would follow it.
void halt(Motions& motions, int row) {
    motions.pose[row].d = {};
    motions.pose[row].theta = 0;
    motions.velocity[row].v = {};
    motions.velocity[row].w = 0;
}

}  // namespace

void update_boxes(Stores& stores, int body) {
    const Transform xf = stores.bodies.transform(body);
    for (int shape = stores.bodies.slots[body].first_shape; shape != kNone;
         shape = stores.shapes[shape].next_of_body) {
        ShapeRecord& record = stores.shapes[shape];
        const Aabb box = bounds(record.convex, xf);
        if (contains(record.fat_box, grown(box, tuning::kAabbReach_m))) continue;
        record.fat_box = grown(box, record.margin_m);
        stores.broad.move(shape, record.fat_box);
    }
}

void finalize_bodies(Stores& stores, StepScratch& scratch, float dt_s, bool sleep_enabled,
                     std::vector<BodyId>& quarantined) {
    BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    for (int row = 0; row < awake.size(); ++row) {
        if (!is_finite(scratch.motions, row + 1)) {
            halt(scratch.motions, row + 1);
            quarantined.push_back(stores.bodies.slots.id(awake.body[row]));
        }
        const PoseRow& pose = scratch.motions.pose[row + 1];
        const Vec2 velocity = scratch.motions.velocity[row + 1].v;
        const float spin = scratch.motions.spin(row + 1);
        const int body = awake.body[row];
        awake.rotation_before[row] = awake.rotation[row];
        awake.center[row] = awake.center[row] + pose.d;
        awake.rotation[row] =
            normalized(Rotation::from_small_angle(scratch.motions.angle(row + 1)) * awake.rotation[row]);
        awake.moved[row] = pose.d;
        awake.velocity[row] = velocity;
        awake.spin[row] = spin;
        awake.force[row] = {};
        awake.torque[row] = 0;
        awake.rest_time[row] = sleep_enabled ? next_rest_time(stores.bodies.slots[body], velocity, spin,
                                                              awake.rest_time[row], dt_s)
                                             : 0;
        update_boxes(stores, body);
    }
}

}  // namespace cairn::physics
