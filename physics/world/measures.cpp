// Counts, errors, energy and momentum, found by walking over everything.
#include "world/measures.h"

#include <algorithm>

#include "base/union_find.h"
#include "collide/manifold.h"
#include "world/contact_events.h"
#include "world/joint_measures.h"

namespace cairn::physics {
namespace {

struct ContactErrors {
    float penetration_m = 0;
    float approach_m_s = 0;  // at points that overlap
};

Vec2 velocity_at(const BodyStore& bodies, int body, Position point) {
    const BodyRows& rows = bodies.rows_of(body);
    const int row = bodies.slots[body].row;
    return rows.velocity[row] + cross(rows.spin[row], point - bodies.places[body].center);
}

// Where the shapes are now: the points that a contact remembers are of the start of the last step.
void measure(const Stores& stores, const ContactRecord& c, ContactErrors& most) {
    const Transform xf_a = stores.bodies.transform(c.body_a);
    const Transform xf_b = stores.bodies.transform(c.body_b);
    const RelativePose b_in_a{inverse_rotate(xf_a.q, xf_b.p - xf_a.p), inverse(xf_a.q) * xf_b.q};
    const Manifold m =
        collide(stores.shapes[c.shape_a].convex(), stores.shapes[c.shape_b].convex(), b_in_a, 0);
    for (int i = 0; i < m.count; ++i) {
        const ManifoldPoint& p = m.points[static_cast<std::size_t>(i)];
        const Position at = transform_point(xf_a, p.point);
        const Vec2 apart =
            velocity_at(stores.bodies, c.body_b, at) - velocity_at(stores.bodies, c.body_a, at);
        most.penetration_m = std::max(most.penetration_m, -p.separation);
        most.approach_m_s = std::max(most.approach_m_s, -dot(apart, rotate(xf_a.q, m.normal)));
    }
}

ContactErrors measure_contacts(const Stores& stores) {
    ContactErrors most;
    for (int i = 0; i < stores.contacts.slots.end_index(); ++i) {
        if (!stores.contacts.slots.alive(i) || !is_touching(stores.contacts, i)) continue;
        measure(stores, stores.contacts.slots[i], most);
    }
    return most;
}

bool is_awake_dynamic(const BodyStore& bodies, int body) {
    return bodies.slots[body].type == BodyType::Dynamic && bodies.is_awake(body);
}

// As sleep_islands links them.
int count_islands(const Stores& stores) {
    const BodyStore& bodies = stores.bodies;
    const BodyRows& awake = bodies.rows(RowSet::Awake);
    UnionFind sets;
    sets.reset(awake.size());
    const auto link = [&](int a, int b) {
        if (is_awake_dynamic(bodies, a) && is_awake_dynamic(bodies, b))
            sets.unite(bodies.slots[a].row, bodies.slots[b].row);
    };
    for (int i = 0; i < stores.contacts.slots.end_index(); ++i) {
        if (!stores.contacts.slots.alive(i)) continue;
        const ContactRecord& c = stores.contacts.slots[i];
        if (c.has_points) link(c.body_a, c.body_b);
    }
    for (const int joint : stores.joints.active) {
        const JointRecord& j = stores.joints.slots[joint];
        link(j.body_a, j.body_b);
    }
    int islands = 0;
    for (int row = 0; row < awake.size(); ++row) {
        if (sets.find(row) == row && is_awake_dynamic(bodies, awake.body[row])) ++islands;
    }
    return islands;
}

int count_awake_touching(const Stores& stores) {
    int count = 0;
    for (int i = 0; i < stores.contacts.slots.end_index(); ++i) {
        if (!stores.contacts.slots.alive(i) || !is_touching(stores.contacts, i)) continue;
        const ContactRecord& c = stores.contacts.slots[i];
        if (stores.bodies.is_awake(c.body_a) || stores.bodies.is_awake(c.body_b)) ++count;
    }
    return count;
}

void add_motion(const BodyStore& bodies, int body, Vec2 gravity_m_s2, WorldReport& report) {
    const BodyRecord& record = bodies.slots[body];
    const BodyRows& rows = bodies.rows(record.set);
    const Position at = bodies.places[body].center;
    const auto m = static_cast<double>(record.mass.mass_kg);
    const auto inertia = static_cast<double>(record.mass.inertia_kg_m2);
    const auto vx = static_cast<double>(rows.velocity[record.row].x);
    const auto vy = static_cast<double>(rows.velocity[record.row].y);
    const auto w = static_cast<double>(rows.spin[record.row]);
    const double weight = m * static_cast<double>(record.gravity_scale);
    report.kinetic_energy_j += 0.5 * (m * (vx * vx + vy * vy) + inertia * w * w);
    report.potential_energy_j -=
        weight * (static_cast<double>(gravity_m_s2.x) * at.x + static_cast<double>(gravity_m_s2.y) * at.y);
    report.momentum_x_kg_m_s += m * vx;
    report.momentum_y_kg_m_s += m * vy;
    report.angular_momentum_kg_m2_s += inertia * w + m * (at.x * vy - at.y * vx);
}

}  // namespace

Counts count_objects(const Stores& stores) {
    Counts counts;
    counts.bodies = stores.bodies.slots.size();
    counts.awake_bodies = stores.bodies.rows(RowSet::Awake).size();
    counts.shapes = stores.shapes.size();
    counts.joints = stores.joints.slots.size();
    counts.contacts = stores.contacts.slots.size();
    for (int i = 0; i < stores.contacts.slots.end_index(); ++i) {
        if (stores.contacts.slots.alive(i) && is_touching(stores.contacts, i)) ++counts.touching;
    }
    return counts;
}

float max_penetration_m(const Stores& stores) {
    return measure_contacts(stores).penetration_m;
}

WorldReport make_report(WorldState& world) {
    Stores& stores = world.stores;
    settle_masses(stores);
    WorldReport report;
    report.counts = count_objects(stores);
    report.awake_touching = count_awake_touching(stores);
    report.awake_joints = stores.joints.active.size();
    report.islands = count_islands(stores);

    const ContactErrors contacts = measure_contacts(stores);
    const JointErrors joints = measure_joints(stores);
    report.max_penetration_m = contacts.penetration_m;
    report.max_joint_error_m = joints.error_m;
    report.max_joint_error_rad = joints.error_rad;
    report.residual_m_s = std::max(contacts.approach_m_s, joints.residual_m_s);
    report.residual_rad_s = joints.residual_rad_s;

    for (int body = 0; body < stores.bodies.slots.end_index(); ++body) {
        const bool counts =
            stores.bodies.slots.alive(body) && stores.bodies.slots[body].type == BodyType::Dynamic;
        if (counts) add_motion(stores.bodies, body, world.def.gravity_m_s2, report);
    }
    report.elastic_energy_j = joints.elastic_energy_j;
    report.stages = world.profile;
    return report;
}

}  // namespace cairn::physics
