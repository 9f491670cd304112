// Joints within a step.
#include "world/joint_constraints.h"

#include <algorithm>
#include <cmath>

#include "resolve/joints/joint_solver.h"
#include "resolve/joints/kinds.h"
#include "resolve/joints/spring_mobility.h"
#include "world/joint_frames.h"
#include "world/joint_lists.h"
#include "world/joint_rules.h"
#include "world/joints.h"
#include "world/prepare.h"
#include "world/stiff_springs.h"

namespace cairn::physics {
namespace {

JointAnchors make_anchors(const BodyStore& bodies, const JointRecord& j, const JointFrames& frames) {
    const auto arm = [&](int body, Vec2 local) {
        return rotate(bodies.places[body].rotation, local - bodies.slots[body].mass.center_m);
    };
    return {bodies.places[j.body_a].row, bodies.places[j.body_b].row, arm(j.body_a, frames.anchor_a_m),
            arm(j.body_b, frames.anchor_b_m), bodies.center_offset(j.body_a, j.body_b)};
}

const JointRecord& geared_joint(const Stores& stores, const GearJointDef& def, int i) {
    return stores.joints.slots[stores.joints.slots.find(i == 0 ? def.joint_1 : def.joint_2)];
}

// The bodies of both joints, each once.
void gather_geared_rows(const Stores& stores, const JointRecord& gear, const GearJointDef& def,
                        JointConstraint& c) {
    c.bodies = 0;
    int filled = 0;
    for (int i = 0; i < 2; ++i) {
        const JointRecord& joint = geared_joint(stores, def, i);
        c.geared[static_cast<std::size_t>(i)] = joint.swept_index;
        for (const int body : {joint.body_a, joint.body_b}) {
            const int row = stores.bodies.places[body].row;
            int place = 0;
            while (place < c.bodies && c.rows[static_cast<std::size_t>(place)] != row) ++place;
            if (place == c.bodies) c.rows[static_cast<std::size_t>(c.bodies++)] = row;
            if (body == gear.body_b) c.b = place;
            c.geared_rows[static_cast<std::size_t>(filled++)] = place;
        }
    }
}

// What the gear keeps, as its direction counts: angles from the start of the step.
float held_by_gear(const Stores& stores, const JointRecord& gear, const GearJointDef& def) {
    double held = gear.geared_sum;
    for (int i = 0; i < 2; ++i) {
        const JointRecord& joint = geared_joint(stores, def, i);
        if (kind_of(joint) != JointKind::Revolute) continue;
        held -= (i == 0 ? 1.0 : static_cast<double>(def.ratio)) * joint_angle(stores.bodies, joint);
    }
    return static_cast<float>(held);
}

struct Describe {
    const Stores& stores;
    const JointRecord& record;
    JointConstraint& c;
    const JointStart& start;

    template <class Def>
    void operator()(const Def& def) const {
        describe(c, def, start);
    }
    void operator()(const GearJointDef& def) const {
        // Where one joint sleeps, nothing that the gear could turn moves.
        for (int i = 0; i < 2; ++i) {
            if (geared_joint(stores, def, i).active_index == kNone) return;
        }
        gather_geared_rows(stores, record, def, c);
        describe_gear(c, def, held_by_gear(stores, record, def), start);
    }
    void operator()(const PulleyJointDef& def) const {
        c.from_wheel_a = anchor_a(stores.bodies, record) - def.wheel_a_m;
        c.from_wheel_b = anchor_b(stores.bodies, record) - def.wheel_b_m;
        describe(c, def, start);
    }
    void operator()(const FilterJointDef&) const {}
};

// As new, but for laws and what pulleys have, which are set whole where they are: clearing all of it would be
// half of the work on a pin.
void begin_constraint(JointConstraint& c) {
    c.bodies = 2;
    c.directions = 0;
    c.b = 1;
    c.axis = {1, 0};
    c.start_angle_rad = 0;
    c.ratio = 1;
    c.geared = {};
    c.geared_rows = {};
    c.law_count = 0;
    c.has_spring = false;
    c.turns_with_a = false;
    c.total_impulse = {};
    c.total_angular_impulse = 0;
}

// A pin that lets its bodies turn as they like looks at no angle.
bool needs_angle(const JointRecord& record) {
    const auto* def = std::get_if<RevoluteJointDef>(&record.def);
    return def == nullptr || def->enable_spring || def->enable_motor || def->enable_limit;
}

// Of the frames of joints, where one follows another that is mostly alike.
class FrameTurns {
  public:
    Rotation of(float angle_rad) {
        if (angle_rad != angle_rad_) {
            angle_rad_ = angle_rad;
            turn_ = Rotation::from_angle(static_cast<double>(angle_rad));
        }
        return turn_;
    }

  private:
    float angle_rad_ = 0;
    Rotation turn_;
};

// Of x and y. What is kept from step to step is in coordinates of body a, as axes may turn over.
void turn_impulse(JointImpulses& impulse, Rotation turn) {
    float& x = impulse[static_cast<std::size_t>(impulse_index(0, Role::HoldOrSpring))];
    float& y = impulse[static_cast<std::size_t>(impulse_index(1, Role::HoldOrSpring))];
    const Vec2 turned = rotate(turn, {x, y});
    x = turned.x;
    y = turned.y;
}

// Where the spring between two points rests, how its bodies answer there, and along which axes.
void lay_spring(const BodyStore& bodies, const JointRecord& record, const JointFrames& frames,
                JointConstraint& c) {
    JointLaw* const end = c.laws.data() + c.law_count;
    JointLaw* const spring = std::find_if(c.laws.data(), end, [](const JointLaw& law) {
        return law.kind == LawKind::Spring && law.direction == 0;
    });
    if (spring == end) return;
    const auto end_of = [&](int body, Vec2 anchor) {
        const BodyRecord& b = bodies.slots[body];
        return SpringEnd{b.inverse_mass, b.inverse_inertia, anchor - b.mass.center_m};
    };
    const SpringEnd a = end_of(record.body_a, frames.anchor_a_m);
    SpringEnd b = end_of(record.body_b, frames.anchor_b_m);
    if (c.kind == JointKind::Distance)
        spring->mobility.xx = mobility_along(a, record.line_a, b, record.line_b);
    if (!c.turns_with_a) return;
    const auto* motor = std::get_if<MotorJointDef>(&record.def);
    const float resting_rad = frames.angle_a_rad - frames.angle_b_rad + (motor ? motor->target_angle_rad : 0);
    b.arm = rotate(Rotation::from_angle(static_cast<double>(resting_rad)), b.arm);
    const PrincipalMobility at_rest = principal_mobility(a, b);
    spring->mobility = at_rest.k;
    c.axis_on_a = at_rest.axis;
    c.axis = rotate(bodies.places[record.body_a].rotation, at_rest.axis);
    turn_impulse(c.impulse, inverse(Rotation{at_rest.axis.x, at_rest.axis.y}));
}

void make_constraint(const Stores& stores, int joint, const StepTime& time, FrameTurns& frame_turns,
                     JointConstraint& c) {
    const JointRecord& record = stores.joints.slots[joint];
    const JointFrames frames = frames_of(record.def);
    begin_constraint(c);
    c.kind = kind_of(record);
    c.joint = joint;
    c.direct = record.direct;
    c.is_new = !record.stepped;
    c.anchors = make_anchors(stores.bodies, record, frames);
    c.rows = {c.anchors.a, c.anchors.b};
    for (std::size_t i = 0; i < c.impulse.size(); ++i) c.impulse[i] = time.impulse_ratio * record.impulse[i];

    JointStart start;
    start.h_s = time.h_s;
    if (needs_angle(record)) {
        start.frame_a = stores.bodies.places[record.body_a].rotation * frame_turns.of(frames.angle_a_rad);
        const double angle = joint_angle(stores.bodies, record);
        start.whole_turns_rad =
            2 * static_cast<double>(kPi) * std::round(angle / (2 * static_cast<double>(kPi)));
        c.start_angle_rad = start.angle(static_cast<float>(angle));
    }
    std::visit(Describe{stores, record, c, start}, record.def);
    if (c.has_spring) lay_spring(stores.bodies, record, frames, c);
    c.softened_hz = c.has_spring ? record.softened_hz : 0;
}

// What is switched off starts from nothing when it is switched on again.
void forget_idle_impulses(JointConstraint& c) {
    JointImpulses kept{};
    for (int l = 0; l < c.law_count; ++l) {
        const JointLaw& law = c.laws[static_cast<std::size_t>(l)];
        for (int i = 0; i < law.count; ++i) {
            const auto at = static_cast<std::size_t>(impulse_index(law.direction + i, role_of(law.kind)));
            kept[at] = c.impulse[at];
        }
    }
    c.impulse = kept;
}

void mark_turning(Motions& motions, int row) {
    motions.mover[row] = MovedBy::Turning;
}

// What was a plain pin in a structure with loops may have become another.
bool has_load(const JointRecord& joint) {
    if (joint.load_n == Vec2{} || joint.direct) return false;
    const auto* pin = std::get_if<RevoluteJointDef>(&joint.def);
    return pin != nullptr && is_plain_pin(*pin);
}

// How much a pin gives under an impulse at rest.
PinLoads pin_loads(float h_s) {
    const Softness soft = softness_of(JointStiffness{}, h_s);
    return {h_s, soft.impulse_scale / (soft.mass_scale * soft.bias_rate)};
}

bool is_rigid_in_lane(const JointRecord& joint) {
    const auto* wheel = std::get_if<WheelJointDef>(&joint.def);
    return is_rigid(wheel ? wheel->stiffness : std::get<RevoluteJointDef>(joint.def).stiffness);
}

// Where joints are few among many bodies, the rows of theirs.
void list_jointed_rows(const Stores& stores, StepScratch& scratch) {
    constexpr std::size_t kManyBodies = 32;
    const JointLanes& lanes = stores.joints.lanes;
    const std::size_t most = kMaxJointBodies * scratch.joints.size() + 2 * kLanes * lanes.block_count();
    std::vector<int>& rows = scratch.jointed_rows;
    rows.clear();
    scratch.few_are_jointed = most * kManyBodies <= static_cast<std::size_t>(scratch.motions.size());
    if (!scratch.few_are_jointed) return;
    for (const JointConstraint& c : scratch.joints)
        rows.insert(rows.end(), c.rows.begin(), c.rows.begin() + c.bodies);
    lanes.for_each_joint([&](int, const AnchorBlock& anchors, std::size_t lane) {
        for (const int body : {anchors.body_a[lane], anchors.body_b[lane]})
            rows.push_back(stores.bodies.places[static_cast<std::size_t>(body)].row);
    });
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
}

}  // namespace

void prepare_joints(Stores& stores, const StepTime& time, StepScratch& scratch, TaskPool& tasks) {
    std::vector<JointConstraint>& joints = scratch.joints;
    joints.resize(static_cast<std::size_t>(stores.joints.swept.size()));
    scratch.torn.clear();
    scratch.has_crowded_springs = false;
    if (stores.joints.slots.size() == 0 && !stores.joints.lanes.springs_changed()) {
        scratch.jointed_rows.clear();
        scratch.few_are_jointed = true;
        return;
    }
    std::size_t next = 0;
    bool springs = false;
    FrameTurns frame_turns;
    JointLanes& lanes = stores.joints.lanes;
    const PinLoads loads = joints.empty() && lanes.empty() ? PinLoads{} : pin_loads(time.h_s);
    for (const int joint : stores.joints.swept) {
        JointConstraint& c = joints[next++];
        make_constraint(stores, joint, time, frame_turns, c);
        forget_idle_impulses(c);
        if (TornJoint torn{}; hide_tear(c, torn)) scratch.torn.push_back(torn);
        if (has_load(stores.joints.slots[joint]))
            take_off_load(c, stores.joints.slots[joint].load_n, loads, scratch.motions);
        springs = springs || c.has_spring;
        for (int i = 0; i < c.bodies; ++i) mark_turning(scratch.motions, c.rows[static_cast<std::size_t>(i)]);
    }
    if (!joints.empty()) place_joints(joints, scratch.motions, scratch.joint_places);
    if (!lanes.empty()) {
        if (lanes.place(stores.bodies.places, scratch.motions, time.impulse_ratio, time.dt_s, tasks))
            lanes.hide_tears([&](int joint) { return is_rigid_in_lane(stores.joints.slots[joint]); },
                             scratch.torn);
        lanes.take_off_loads(scratch.motions, loads, tasks);
    }
    list_jointed_rows(stores, scratch);
    if (!springs && !lanes.springs_changed()) return;
    weigh_springs(joints, scratch.joint_places);
    soften_stiff_springs(stores, time, scratch);
    scratch.spring_loads.assign(static_cast<std::size_t>(scratch.motions.size()), {});
    add_spring_loads(joints, scratch.joint_places, scratch.motions, scratch.spring_loads);
    lanes.add_spring_loads(scratch.motions, scratch.spring_loads, tasks);
    scratch.has_crowded_springs = make_springs(joints, time.h_s, scratch.spring_loads);
    start_springs(joints, scratch.joint_places, time.h_s, scratch.motions);
    lanes.settle_springs(scratch.spring_loads, springs, tasks);
}

void store_joint_impulses(JointStore& joints, const StepTime& time, const StepScratch& scratch) {
    for (std::size_t i = 0; i < scratch.joints.size(); ++i) {
        const JointConstraint& c = scratch.joints[i];
        JointRecord& record = joints.slots[c.joint];
        record.stepped = true;
        record.softened_hz =
            c.has_spring ? balanced_frequency(c, scratch.joint_places[i], time) : c.softened_hz;
        record.impulse = c.impulse;
        if (c.turns_with_a) turn_impulse(record.impulse, {c.axis_on_a.x, c.axis_on_a.y});
        record.angle_rad += static_cast<double>(scratch.motions.angle(c.anchors.b)) -
                            static_cast<double>(scratch.motions.angle(c.anchors.a));
        record.reaction_force = (1 / time.dt_s) * c.total_impulse;
        record.reaction_torque = c.total_angular_impulse / time.dt_s;
    }
}

void break_joints(Stores& stores, StepScratch& scratch, Events& events) {
    std::vector<int>& joints = scratch.unseated;
    joints.clear();
    for (const JointConstraint& c : scratch.joints) joints.push_back(c.joint);
    stores.joints.lanes.for_each_breakable([&](int joint) { joints.push_back(joint); });
    for (const int joint : joints) {
        // A gear may have gone with a joint that broke before it.
        if (!stores.joints.slots.alive(joint)) continue;
        const JointRecord& record = stores.joints.slots[joint];
        const JointStrength strength = strength_of(record.def);
        const JointMemory memory = memory_of(stores.joints, joint);
        const float force = length(memory.reaction_force);
        if (!(force > strength.break_force_n) &&
            !(std::fabs(memory.reaction_torque) > strength.break_torque_nm)) {
            continue;
        }
        events.joint_breaks.push_back({stores.joints.slots.id(joint), kind_of(record),
                                       stores.bodies.slots.id(record.body_a),
                                       stores.bodies.slots.id(record.body_b), anchor_b(stores.bodies, record),
                                       memory.reaction_force, memory.reaction_torque, record.user_data});
        destroy_joint(stores, joint);
    }
}

}  // namespace cairn::physics
