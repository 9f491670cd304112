// Moves of joints between lists and lanes.
#include "world/joint_lists.h"

#include <bit>
#include <cmath>

#include "resolve/joints/laws.h"
#include "world/contact_order.h"
#include "world/domains.h"
#include "world/joint_frames.h"
#include "world/joint_rules.h"
#include "world/joints.h"
#include "world/prepare.h"
#include "world/stiff_springs.h"

namespace cairn::physics {
namespace {

constexpr double kTurn_rad = 2 * static_cast<double>(kPi);

bool can_be_moved(const BodyRecord& body) {
    return body.inverse_mass > 0;
}

// Springs without damping start from a guess of their own, new ones from a speed of their own, and gears and
// structures look at the constraints of their joints: these are for the scalar solver, as are axes that do
// not move.
template <class Def>
bool has_spring_for_lane(const JointRecord& record) {
    const auto* def = std::get_if<Def>(&record.def);
    return def != nullptr && (!def->enable_spring || (def->damping_ratio != 0 && record.stepped));
}

// Stiff wheels may be as stiff as asked for, or on their way there, which constraints can tell
// (stiff_springs.h). Pins with springs are always softened where they are swept.
bool is_stiff_wheel(const JointRecord& record, float most_swept_hz) {
    const auto* wheel = std::get_if<WheelJointDef>(&record.def);
    return wheel != nullptr && wheel->enable_spring &&
           (record.softened_hz > 0 || wheel->frequency_hz > most_swept_hz);
}

bool fits_lane(const Stores& stores, int joint, float most_swept_hz) {
    const JointRecord& record = stores.joints.slots[joint];
    if (record.direct) return false;
    if (!has_spring_for_lane<RevoluteJointDef>(record) && !has_spring_for_lane<WheelJointDef>(record))
        return false;
    if (is_stiff_wheel(record, most_swept_hz)) return false;
    const BodyRecord& a = stores.bodies.slots[record.body_a];
    const BodyRecord& b = stores.bodies.slots[record.body_b];
    if (!can_be_moved(b) || locked_axes(a) != 0 || locked_axes(b) != 0) return false;
    return find_gear_on(stores, joint) == kNone;
}

double angle_between(const JointFrames& frames) {
    return static_cast<double>(frames.angle_b_rad) - static_cast<double>(frames.angle_a_rad);
}

AnchorLane make_anchor(const Stores& stores, int joint) {
    const JointRecord& record = stores.joints.slots[joint];
    const JointFrames frames = frames_of(record.def);
    AnchorLane lane;
    lane.joint = joint;
    lane.body_a = record.body_a;
    lane.body_b = record.body_b;
    lane.local_a = frames.anchor_a_m - stores.bodies.slots[record.body_a].mass.center_m;
    lane.local_b = frames.anchor_b_m - stores.bodies.slots[record.body_b].mass.center_m;
    lane.turn =
        inverse(stores.bodies.places[record.body_a].rotation) * stores.bodies.places[record.body_b].rotation;
    const double angle =
        deterministic::atan2(static_cast<double>(lane.turn.s), static_cast<double>(lane.turn.c)) +
        angle_between(frames);
    lane.turns = static_cast<float>(std::round((joint_angle(stores.bodies, record) - angle) / kTurn_rad));
    const JointStrength strength = strength_of(record.def);
    lane.breakable = std::isfinite(strength.break_force_n) || std::isfinite(strength.break_torque_nm);
    return lane;
}

// All but where the spring draws to and the limits are.
template <class Def>
DriveLane make_laws(const Def& def, const StepTime& time) {
    const float h_s = time.h_s;
    DriveLane drive;
    drive.softness = softness_of(def.stiffness, h_s);
    if (def.enable_spring) {
        const SpringTone tone = softened({def.frequency_hz, def.damping_ratio}, time.most_swept_hz);
        drive.spring_frequency_rad_s = 2 * kPi * tone.frequency_hz;
        drive.square = (drive.spring_frequency_rad_s * h_s) * (drive.spring_frequency_rad_s * h_s);
        drive.damping = 2 * tone.damping_ratio * (drive.spring_frequency_rad_s * h_s);
        drive.spring =
            make_exact_spring(static_cast<double>(tone.frequency_hz), static_cast<double>(tone.damping_ratio),
                              static_cast<double>(h_s), 1);
    }
    if (def.enable_motor) {
        drive.motor_speed = def.motor_speed_rad_s;
        drive.motor_limit = def.max_motor_torque_nm * h_s;
    }
    return drive;
}

DriveLane make_drive(const RevoluteJointDef& def, const StepTime& time) {
    const float frames = def.local_angle_b_rad - def.local_angle_a_rad;
    DriveLane drive = make_laws(def, time);
    if (def.enable_spring) drive.spring_target = def.target_rad - frames;
    if (def.enable_limit) {
        drive.lower = std::max(def.lower_rad - frames, -kNoLimit);
        drive.upper = std::min(def.upper_rad - frames, kNoLimit);
    }
    return drive;
}

DriveLane make_drive(const WheelJointDef& def, const StepTime& time) {
    DriveLane drive = make_laws(def, time);
    if (def.enable_spring) drive.spring_target = def.target_m;
    if (def.enable_limit) {
        drive.lower = std::max(def.lower_m, -kNoLimit);
        drive.upper = std::min(def.upper_m, kNoLimit);
    }
    return drive;
}

DriveLane make_drive(const JointRecord& record, const StepTime& time) {
    if (const auto* wheel = std::get_if<WheelJointDef>(&record.def)) return make_drive(*wheel, time);
    return make_drive(std::get<RevoluteJointDef>(record.def), time);
}

JointSeat add_to_lane(JointLanes& lanes, int bucket, const AnchorLane& anchor, const JointRecord& record,
                      const StepTime& time) {
    if (const auto* wheel = std::get_if<WheelJointDef>(&record.def)) {
        const Rotation frame = Rotation::from_angle(static_cast<double>(wheel->local_angle_a_rad));
        return lanes.add_wheel(bucket, anchor, {frame.c, frame.s}, make_drive(*wheel, time));
    }
    const auto& revolute = std::get<RevoluteJointDef>(record.def);
    if (is_plain_pin(revolute)) return lanes.add_pin(bucket, anchor);
    return lanes.add_drive(bucket, anchor, make_drive(revolute, time));
}

bool try_to_seat(Stores& stores, int joint, const StepTime& time) {
    if (!fits_lane(stores, joint, time.most_swept_hz)) return false;
    JointStore& joints = stores.joints;
    JointRecord& record = joints.slots[joint];
    const bool both = can_be_moved(stores.bodies.slots[record.body_a]);
    std::uint32_t used = joints.colors[static_cast<std::size_t>(record.body_b)];
    if (both) used |= joints.colors[static_cast<std::size_t>(record.body_a)];
    const int color = std::countr_one(used);
    if (color >= kJointColors) return false;
    settle_in_domain(stores, record.body_b);
    if (both) settle_in_domain(stores, record.body_a);
    const int bucket = joint_bucket(color, both ? JointBlockKind::TwoBodies : JointBlockKind::Anchored,
                                    domain_of(stores.domains, record.body_a, record.body_b, both));
    joints.colors[static_cast<std::size_t>(record.body_b)] |= 1u << color;
    if (both) joints.colors[static_cast<std::size_t>(record.body_a)] |= 1u << color;

    record.seat = add_to_lane(joints.lanes, bucket, make_anchor(stores, joint), record, time);
    joints.lanes.set_impulses(record.seat, record.impulse);
    record.softened_hz = 0;
    if (record.load_n != Vec2{}) joints.lanes.set_load(record.seat, record.load_n);
    return true;
}

void forget_lane(Stores& stores, int joint) {
    JointStore& joints = stores.joints;
    JointRecord& record = joints.slots[joint];
    if (record.seat.lane == kNone) return;
    const JointMemory memory = memory_of(joints, joint);
    record.impulse = memory.impulse;
    record.load_n = joints.lanes.load(record.seat);
    record.softened_hz = softened_frequency(record.def, joints.lanes.most_swept_hz);
    record.angle_rad = memory.angle_rad;
    record.reaction_force = memory.reaction_force;
    record.reaction_torque = memory.reaction_torque;

    const std::uint32_t others = ~(1u << joint_color(record.seat.bucket));
    joints.colors[static_cast<std::size_t>(record.body_b)] &= others;
    if (joint_block_kind(record.seat.bucket) == JointBlockKind::TwoBodies)
        joints.colors[static_cast<std::size_t>(record.body_a)] &= others;
    const int moved = joints.lanes.remove(record.seat);
    if (moved != kNone) joints.slots[moved].seat.lane = record.seat.lane;
    record.seat = {};
}

void unseat_stiff_wheels(Stores& stores, float most_swept_hz) {
    for (const int joint : stores.joints.active) {
        const JointRecord& record = stores.joints.slots[joint];
        if (record.seat.lane != kNone && is_stiff_wheel(record, most_swept_hz)) leave_lane(stores, joint);
    }
}

}  // namespace

bool is_plain_pin(const RevoluteJointDef& def) {
    const JointStiffness usual;
    return !def.enable_spring && !def.enable_motor && !def.enable_limit &&
           def.stiffness.frequency_hz == usual.frequency_hz &&
           def.stiffness.damping_ratio == usual.damping_ratio;
}

void list_joint(Stores& stores, int joint) {
    const JointRecord& record = stores.joints.slots[joint];
    if (record.active_index != kNone) return;
    ++stores.joints.version;
    stores.joints.active.add(stores.joints.slots, joint);
    stores.joints.swept.add(stores.joints.slots, joint);
}

void unlist_joint(Stores& stores, int joint) {
    if (stores.joints.slots[joint].active_index == kNone) return;
    ++stores.joints.version;
    forget_lane(stores, joint);
    stores.joints.active.remove(stores.joints.slots, joint);
    stores.joints.swept.remove(stores.joints.slots, joint);
}

void unseat_joint(Stores& stores, int joint) {
    ++stores.joints.version;
    leave_lane(stores, joint);
}

void leave_lane(Stores& stores, int joint) {
    if (stores.joints.slots[joint].seat.lane == kNone) return;
    forget_lane(stores, joint);
    stores.joints.swept.add(stores.joints.slots, joint);
}

void forget_memory(Stores& stores, int joint) {
    unseat_joint(stores, joint);
    JointRecord& record = stores.joints.slots[joint];
    record.impulse = {};
    record.load_n = {};
    record.reaction_force = {};
    record.reaction_torque = 0;
    if (!std::isfinite(record.angle_rad)) record.angle_rad = joint_angle(stores.bodies, record, 0);
}

void seat_joints(Stores& stores, const StepTime& time, StepScratch& scratch) {
    JointStore& joints = stores.joints;
    if (joints.active.size() == 0 && joints.lanes.empty()) return;
    const bool other_time = joints.lanes.h_s != time.h_s || joints.lanes.most_swept_hz != time.most_swept_hz;
    if (other_time) unseat_stiff_wheels(stores, time.most_swept_hz);
    joints.lanes.arrange();
    if (other_time) {
        joints.lanes.h_s = time.h_s;
        joints.lanes.most_swept_hz = time.most_swept_hz;
        joints.lanes.set_drives([&](int joint) { return make_drive(joints.slots[joint], time); });
    }
    if (joints.swept.size() == 0) return;
    const auto bodies = static_cast<std::size_t>(stores.bodies.slots.end_index());
    if (joints.colors.size() < bodies) joints.colors.resize(bodies, 0);
    scratch.unseated.assign(joints.swept.begin(), joints.swept.end());
    for (const int joint : scratch.unseated) {
        if (try_to_seat(stores, joint, time)) joints.swept.remove(joints.slots, joint);
    }
    joints.lanes.arrange();
}

void order_joints(Stores& stores, std::uint64_t step_count, StepScratch& scratch) {
    // Fewer blocks are no work for several threads.
    constexpr std::size_t kLeastBlocks = 128;
    JointStore& joints = stores.joints;
    if (joints.lanes.block_count() < kLeastBlocks) return;
    // Not only when it is needed: a step that has warmed up allocates nothing.
    joints.lanes.make_room(scratch.lane_order);
    if (step_count % kOrderInterval != 0) return;
    joints.lanes.sort(stores.bodies.places, scratch.lane_order,
                      [&](int joint, int lane) { joints.slots[joint].seat.lane = lane; });
}

void move_to_domain(JointStore& joints, int joint, int domain) {
    JointSeat& seat = joints.slots[joint].seat;
    const int lane = seat.lane;
    const int filler = joints.lanes.move(
        seat, joint_bucket(joint_color(seat.bucket), joint_block_kind(seat.bucket), domain));
    if (filler != kNone) joints.slots[filler].seat.lane = lane;
}

JointMemory memory_of(const JointStore& joints, int joint) {
    const JointRecord& record = joints.slots[joint];
    if (record.seat.lane == kNone)
        return {record.impulse, record.angle_rad, record.reaction_force, record.reaction_torque};
    JointMemory memory = joints.lanes.memory(record.seat);
    memory.angle_rad += angle_between(frames_of(record.def));
    return memory;
}

int find_gear_on(const Stores& stores, int joint) {
    const JointId id = stores.joints.slots.id(joint);
    const JointRecord& record = stores.joints.slots[joint];
    int found = kNone;
    for (const int body : {record.body_a, record.body_b}) {
        for_each_edge(stores.joints.slots, stores.bodies.slots[body].first_joint, [&](int other, int) {
            const auto* gear = std::get_if<GearJointDef>(&stores.joints.slots[other].def);
            if (gear && (gear->joint_1 == id || gear->joint_2 == id)) found = other;
        });
    }
    return found;
}

}  // namespace cairn::physics
