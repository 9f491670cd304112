// Packing of constraints, and unpacking of impulses.
#include "world/prepare.h"

#include <algorithm>

#include <cairn/physics/tuning.h>

#include "world/contact_events.h"
#include "world/special_contacts.h"

namespace cairn::physics {
namespace {

// rad. Lanes take separations as linear in the angle, which is wrong by half its square times the arm.
constexpr float kMaxTurn_rad = 0.25f;

void mark_mover(Motions& motions, int row, Mover mover) {
    if (motions.mover[row] < mover) motions.mover[row] = mover;
}

JointAnchors make_anchors(const BodyStore& bodies, const JointRecord& j, Vec2 local_a, Vec2 local_b) {
    const auto arm = [&](int body, Vec2 local) {
        return rotate(bodies.places[body].rotation, local - bodies.slots[body].mass.center_m);
    };
    return {bodies.places[j.body_a].row, bodies.places[j.body_b].row, arm(j.body_a, local_a),
            arm(j.body_b, local_b), bodies.center_offset(j.body_a, j.body_b)};
}

Softness joint_softness(const StepTime& time) {
    const float frequency = std::min(tuning::kJointFrequency_hz, tuning::kMaxFrequencyShare / time.h_s);
    return make_soft(frequency, tuning::kJointDampingRatio, time.h_s);
}

float angle_between(const BodyStore& bodies, int a, int b, double reference_rad) {
    const Rotation turn = inverse(bodies.places[a].rotation) * bodies.places[b].rotation;
    return (inverse(Rotation::from_angle(reference_rad)) * turn).angle_rad();
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

}  // namespace

StepTime make_step_time(float dt_s, int substeps, float previous_h_s) {
    const float h_s = dt_s / static_cast<float>(substeps);
    const float ratio = previous_h_s > 0 ? h_s / previous_h_s : 1;
    return {dt_s, h_s, substeps, ratio, std::min(ratio, 1.0f)};
}

void prepare_motions(BodyStore& bodies, Vec2 gravity_m_s2, float dt_s, StepScratch& scratch) {
    scratch.motions.clear();
    scratch.motions.add({}, 0, 0, 0);  // the world
    scratch.drives.assign(1, Drive{});
    extend_motions(bodies, gravity_m_s2, dt_s, scratch);
}

void extend_motions(BodyStore& bodies, Vec2 gravity_m_s2, float dt_s, StepScratch& scratch) {
    const BodyRows& awake = bodies.rows(RowSet::Awake);
    for (int row = scratch.motions.size() - 1; row < awake.size(); ++row) {
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
            drive.gravity_scale = record.gravity_scale;
        }
        scratch.drives.push_back(drive);
        std::uint32_t& flags = bodies.places[awake.body[row]].flags;
        flags &= ~place_flag::kTurnsFar;
        if (std::fabs(awake.spin[row]) * dt_s > kMaxTurn_rad) flags |= place_flag::kTurnsFar;
    }
}

void choose_movers(const Stores& stores, StepScratch& scratch) {
    const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    const std::vector<std::uint32_t>& colors = stores.contacts.colors;
    for (int row = 0; row < awake.size(); ++row) {
        const auto body = static_cast<std::size_t>(awake.body[row]);
        if (body < colors.size() && colors[body] != 0) scratch.motions.mover[row + 1] = Mover::Substeps;
    }
    for (const int i : scratch.scalar_contacts) {
        mark_mover(scratch.motions, scratch.contacts[i].a, Mover::Turning);
        mark_mover(scratch.motions, scratch.contacts[i].b, Mover::Turning);
    }
    // What carries others moves with them.
    const ContactLanes& lanes = stores.contacts.lanes;
    for (const int bucket : lanes.buckets()) {
        if (kind_of(bucket) != BlockKind::Carried) continue;
        for (const int block : lanes.blocks(bucket)) {
            for (const int row : lanes.block(block).a) mark_mover(scratch.motions, row, Mover::Substeps);
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

void collect_outcomes(const ContactStore& contacts, StepScratch& scratch) {
    for (ContactConstraint& c : scratch.contacts) {
        if (!c.in_lane) continue;
        const ContactRecord& record = contacts.slots[c.contact];
        const ContactBlock& block = contacts.lanes.block(record.lane / kLanes);
        const int lane = record.lane % kLanes;
        for (int i = 0; i < c.count; ++i) {
            c.points[i].normal_impulse = block.points[i].impulse[lane];
            c.points[i].total_normal_impulse = block.total_impulse[i][lane];
            c.points[i].end_separation = block.points[i].separation[lane];
        }
        c.friction_impulse = block.friction_impulse[lane];
    }
}

void store_contact_impulses(ContactStore& contacts, const StepScratch& scratch) {
    for (const ContactConstraint& c : scratch.contacts) {
        ContactRecord& record = contacts.slots[c.contact];
        ContactMemory memory;
        for (int i = 0; i < c.count; ++i) {
            memory.features[i] = c.points[i].feature;
            memory.impulse[i] = c.points[i].normal_impulse;
        }
        memory.friction_impulse = c.friction_impulse;
        if (is_colored(record.bucket)) {
            contacts.lanes.set_memory(record.lane, memory);
        } else {
            record.memory = memory;
        }
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
