// Packing of constraints, and unpacking of impulses.
#include "world/prepare.h"

#include <algorithm>

#include <cairn/physics/tuning.h>

#include "world/contact_events.h"
#include "world/special_contacts.h"

namespace cairn::physics {
namespace {

// Bodies that are not awake in the hot rows act as the world itself: what sleeps and is touched was woken
// before.
int row_of(const BodyStore& bodies, int body) {
    const BodyRecord& record = bodies.slots[body];
    return record.set == RowSet::Awake ? record.row + 1 : kWorldRow;
}

void mark_mover(Motions& motions, int row, Mover mover) {
    if (motions.mover[row] < mover) motions.mover[row] = mover;
}

JointAnchors make_anchors(const BodyStore& bodies, const JointRecord& j, Vec2 local_a, Vec2 local_b) {
    const auto arm = [&](int body, Vec2 local) {
        const BodyRecord& record = bodies.slots[body];
        return rotate(bodies.rows_of(body).rotation[record.row], local - record.mass.center_m);
    };
    return {row_of(bodies, j.body_a), row_of(bodies, j.body_b), arm(j.body_a, local_a),
            arm(j.body_b, local_b), bodies.center_offset(j.body_a, j.body_b)};
}

Softness joint_softness(const StepTime& time) {
    const float frequency = std::min(tuning::kJointFrequency_hz, tuning::kMaxFrequencyShare / time.h_s);
    return make_soft(frequency, tuning::kJointDampingRatio, time.h_s);
}

float angle_between(const BodyStore& bodies, int a, int b, double reference_rad) {
    const Rotation qa = bodies.rows_of(a).rotation[bodies.slots[a].row];
    const Rotation qb = bodies.rows_of(b).rotation[bodies.slots[b].row];
    return (inverse(Rotation::from_angle(reference_rad)) * (inverse(qa) * qb)).angle_rad();
}

RevoluteConstraint pack(const Stores& stores, const JointRecord& j, const RevoluteJointDef& def,
                        const StepTime& time) {
    RevoluteConstraint c;
    c.anchors = make_anchors(stores.bodies, j, def.local_anchor_a_m, def.local_anchor_b_m);
    c.softness = joint_softness(time);
    c.limit = def.enable_limit;
    c.lower_rad = def.lower_rad;
    c.upper_rad = def.upper_rad;
    if (c.limit) c.angle_rad = angle_between(stores.bodies, j.body_a, j.body_b, def.reference_angle_rad);
    c.motor = def.enable_motor;
    c.motor_speed_rad_s = def.motor_speed_rad_s;
    c.max_motor_impulse = def.max_motor_torque_nm * time.h_s;
    c.impulse = time.impulse_ratio * j.impulse;
    c.motor_impulse = time.impulse_ratio * j.motor_impulse;
    c.lower_impulse = time.impulse_ratio * j.lower_impulse;
    c.upper_impulse = time.impulse_ratio * j.upper_impulse;
    return c;
}

DistanceConstraint pack(const Stores& stores, const JointRecord& j, const DistanceJointDef& def,
                        const StepTime& time) {
    DistanceConstraint c;
    c.anchors = make_anchors(stores.bodies, j, def.local_anchor_a_m, def.local_anchor_b_m);
    c.softness = joint_softness(time);
    c.spring = def.enable_spring;
    c.limit = def.enable_spring && (def.min_length_m > 0 || std::isfinite(def.max_length_m));
    if (c.spring) c.spring_softness = make_soft(def.frequency_hz, def.damping_ratio, time.h_s);
    c.length_m = def.length_m;
    c.min_length_m = def.min_length_m;
    c.max_length_m = def.max_length_m;
    c.impulse = time.impulse_ratio * j.impulse.x;
    c.lower_impulse = time.impulse_ratio * j.lower_impulse;
    c.upper_impulse = time.impulse_ratio * j.upper_impulse;
    return c;
}

// Whether a new point may take its static estimate for a first guess: it is closed and hardly moves.
bool starts_at_rest(const Stores& stores, const ContactRecord& c, int point) {
    const ContactPoint& p = c.points[point];
    if (p.separation > 0.1f * tuning::kLinearSlop_m) return false;
    const auto velocity = [&](int body, Vec2 r) {
        const BodyRows& rows = stores.bodies.rows_of(body);
        const int row = stores.bodies.slots[body].row;
        return rows.velocity[row] + cross(rows.spin[row], r);
    };
    return std::fabs(dot(velocity(c.body_b, p.r_b) - velocity(c.body_a, p.r_a), c.normal)) < 0.5f;
}

// Impulses grow with the substep, but not beyond what the contact would bear at rest: their noise would grow
// too.
float first_guess(const ContactPoint& p, const StepTime& time) {
    const float scaled = time.step_ratio * p.normal_impulse;
    return std::min(scaled, std::max(p.normal_impulse, p.static_impulse));
}

ContactInput unpack(const Stores& stores, const ContactRecord& record, int contact, const StepTime& time) {
    ContactInput input;
    input.a = row_of(stores.bodies, record.body_a);
    input.b = row_of(stores.bodies, record.body_b);
    input.contact = contact;
    input.normal = record.normal;
    input.count = record.count;
    for (int i = 0; i < record.count; ++i) {
        input.points[i] = {record.points[i].r_a, record.points[i].r_b, record.points[i].separation,
                           first_guess(record.points[i], time), record.points[i].static_impulse};
    }
    for (int i = 0; i < record.count; ++i) {
        if (record.points[i].is_new && starts_at_rest(stores, record, i)) {
            input.points[i].impulse = record.points[i].static_impulse;
        }
    }
    input.friction = record.friction;
    input.restitution = record.restitution;
    input.friction_impulse = time.impulse_ratio * record.friction_impulse;
    input.radius_a = record.radius_a;
    input.radius_b = record.radius_b;
    if (special::has(record, special::kSurface)) {
        const SurfaceEffects effects = surface_effects(stores, record);
        input.rolling_m = effects.rolling_m;
        input.surface_speed_m_s = effects.speed_m_s;
    }
    input.reports = record.reports_touch || record.reports_hit || record.restitution > 0;
    return input;
}

}  // namespace

StepTime make_step_time(float dt_s, int substeps, float previous_h_s) {
    const float h_s = dt_s / static_cast<float>(substeps);
    const float ratio = previous_h_s > 0 ? h_s / previous_h_s : 1;
    return {dt_s, h_s, substeps, ratio, std::min(ratio, 1.0f)};
}

void prepare_motions(const BodyStore& bodies, Vec2 gravity_m_s2, StepScratch& scratch) {
    const BodyRows& awake = bodies.rows(RowSet::Awake);
    scratch.motions.clear();
    scratch.motions.add({}, 0, 0, 0);  // the world
    scratch.drives.assign(1, Drive{});
    for (int row = 0; row < awake.size(); ++row) {
        const BodyRecord& record = bodies.slots[awake.body[row]];
        scratch.motions.add(awake.velocity[row], awake.spin[row], record.inverse_mass,
                            record.inverse_inertia);
        scratch.motions.lock(locked_axes(record));
        Drive drive;
        if (record.inverse_mass > 0) {  // a body without mass keeps its velocity
            drive.acceleration =
                without_locked(record.gravity_scale * gravity_m_s2 + record.inverse_mass * awake.force[row],
                               locked_axes(record));
            drive.angular_acceleration = record.inverse_inertia * awake.torque[row];
            drive.linear_damping = record.linear_damping_1_s;
            drive.angular_damping = record.angular_damping_1_s;
        }
        scratch.drives.push_back(drive);
    }
}

void prepare_contacts(const Stores& stores, const StepTime& time, const ContactRules& rules,
                      StepScratch& scratch) {
    scratch.contacts.clear();
    scratch.scalar_contacts.clear();
    scratch.reports.clear();
    scratch.blocks.start(scratch.motions.size());
    for (const int contact : stores.contacts.active) {
        const ContactRecord& record = stores.contacts.slots[contact];
        if (record.count == 0) continue;
        const ContactInput input = unpack(stores, record, contact, time);
        mark_mover(scratch.motions, input.a, Mover::Substeps);
        mark_mover(scratch.motions, input.b, Mover::Substeps);
        const ContactLane lane = scratch.blocks.add(input, scratch.motions, time.dt_s);
        if (!lane) {
            scratch.scalar_contacts.push_back(static_cast<int>(scratch.contacts.size()));
            mark_mover(scratch.motions, input.a, Mover::Turning);
            mark_mover(scratch.motions, input.b, Mover::Turning);
        }
        // What impacts, and what must be told, is kept in plain form beside its lane.
        if (!lane || input.reports) {
            scratch.contacts.push_back(make_contact(input, scratch.motions, rules));
            scratch.reports.push_back(lane);
        }
    }
}

void prepare_joints(const Stores& stores, const StepTime& time, StepScratch& scratch) {
    scratch.revolutes.clear();
    scratch.distances.clear();
    for (const int joint : stores.joints.active) {
        const JointRecord& record = stores.joints.slots[joint];
        if (const auto* revolute = std::get_if<RevoluteJointDef>(&record.def)) {
            RevoluteConstraint c = pack(stores, record, *revolute, time);
            c.joint = joint;
            prepare_revolute(c, scratch.motions);
            mark_mover(scratch.motions, c.anchors.a, Mover::Turning);
            mark_mover(scratch.motions, c.anchors.b, Mover::Turning);
            scratch.revolutes.push_back(c);
        } else if (const auto* distance = std::get_if<DistanceJointDef>(&record.def)) {
            DistanceConstraint c = pack(stores, record, *distance, time);
            c.joint = joint;
            prepare_distance(c);
            mark_mover(scratch.motions, c.anchors.a, Mover::Turning);
            mark_mover(scratch.motions, c.anchors.b, Mover::Turning);
            scratch.distances.push_back(c);
        }
    }
}

void collect_outcomes(StepScratch& scratch) {
    for (std::size_t i = 0; i < scratch.contacts.size(); ++i) {
        if (!scratch.reports[i]) continue;
        ContactConstraint& c = scratch.contacts[i];
        const ContactOutcome outcome = scratch.blocks.outcome(scratch.reports[i]);
        for (int k = 0; k < c.count; ++k) {
            c.points[k].normal_impulse = outcome.impulse[k];
            c.points[k].total_normal_impulse = outcome.total_impulse[k];
            c.points[k].end_separation = outcome.separation[k];
        }
        c.friction_impulse = outcome.friction_impulse;
    }
}

void store_contact_impulses(ContactStore& contacts, const StepScratch& scratch) {
    scratch.blocks.for_each_outcome([&](int contact, const ContactOutcome& outcome) {
        ContactRecord& record = contacts.slots[contact];
        record.points[0].normal_impulse = outcome.impulse[0];
        record.points[1].normal_impulse = outcome.impulse[1];
        record.friction_impulse = outcome.friction_impulse;
        if (!record.reports_touch)
            record.touching = touches(record.count, outcome.impulse, outcome.separation, record.touching);
    });
    for (const ContactConstraint& c : scratch.contacts) {
        ContactRecord& record = contacts.slots[c.contact];
        for (int i = 0; i < c.count; ++i) {
            record.points[i].normal_impulse = c.points[i].normal_impulse;
        }
        record.friction_impulse = c.friction_impulse;
    }
}

void store_joint_impulses(JointStore& joints, const StepTime& time, const StepScratch& scratch) {
    for (const RevoluteConstraint& c : scratch.revolutes) {
        JointRecord& record = joints.slots[c.joint];
        record.impulse = c.impulse;
        record.motor_impulse = c.motor_impulse;
        record.lower_impulse = c.lower_impulse;
        record.upper_impulse = c.upper_impulse;
        record.reaction_force = (1 / time.h_s) * c.impulse;
        record.reaction_torque = (c.motor_impulse + c.lower_impulse - c.upper_impulse) / time.h_s;
    }
    for (const DistanceConstraint& c : scratch.distances) {
        JointRecord& record = joints.slots[c.joint];
        record.impulse = {c.impulse, 0};
        record.lower_impulse = c.lower_impulse;
        record.upper_impulse = c.upper_impulse;
        record.reaction_force = ((c.impulse + c.lower_impulse - c.upper_impulse) / time.h_s) * c.axis;
    }
}

}  // namespace cairn::physics
