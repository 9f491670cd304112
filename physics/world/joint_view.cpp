// The public Joint view.
#include <string>

#include <cairn/physics/joint.h>

#include "world/joint_frames.h"
#include "world/joint_lists.h"
#include "world/joint_rules.h"
#include "world/joints.h"

namespace cairn::physics {
namespace {

int slot_of(const WorldState& world, JointId id) {
    const int joint = world.stores.joints.slots.find(id);
    CAIRN_ASSERT(joint != kNone, "a Joint view was used after its joint was destroyed");
    return joint;
}

JointRecord& record_of(WorldState& world, JointId id) {
    return world.stores.joints.slots[slot_of(world, id)];
}

// Changes a copy of the definition and takes it when it is good. `change` returns whether the kind has the
// part.
template <class Change>
Result<void> edit(WorldState& world, JointId id, const char* what, const char* kinds, Change&& change) {
    const int joint = slot_of(world, id);
    JointDef def = world.stores.joints.slots[joint].def;
    if (!std::visit(change, def)) {
        return Error{"joint." + std::string(what) + " belongs to " + kinds + " joints, and this is a " +
                     name_of(static_cast<JointKind>(def.index()))};
    }
    if (auto fault = validate(def, world.stores)) return *fault;
    redefine_joint(world, joint, std::move(def));
    return {};
}

}  // namespace

JointKind Joint::kind() const {
    return kind_of(record_of(*world_, id_));
}

BodyId Joint::body_a() const {
    return world_->stores.bodies.slots.id(record_of(*world_, id_).body_a);
}
BodyId Joint::body_b() const {
    return world_->stores.bodies.slots.id(record_of(*world_, id_).body_b);
}
Position Joint::anchor_a() const {
    return physics::anchor_a(world_->stores.bodies, record_of(*world_, id_));
}
Position Joint::anchor_b() const {
    return physics::anchor_b(world_->stores.bodies, record_of(*world_, id_));
}
Vec2 Joint::reaction_force() const {
    return memory_of(world_->stores.joints, slot_of(*world_, id_)).reaction_force;
}
float Joint::reaction_torque() const {
    return memory_of(world_->stores.joints, slot_of(*world_, id_)).reaction_torque;
}
std::uint64_t Joint::user_data() const {
    return record_of(*world_, id_).user_data;
}
void Joint::set_user_data(std::uint64_t data) {
    JointRecord& record = record_of(*world_, id_);
    record.user_data = data;
    std::visit([&](auto& def) { def.user_data = data; }, record.def);
}

float Joint::joint_angle() const {
    const JointRecord& record = record_of(*world_, id_);
    switch (kind_of(record)) {
        case JointKind::Revolute:
        case JointKind::Prismatic:
        case JointKind::Weld:
        case JointKind::Wheel:
        case JointKind::Motor:
        case JointKind::Friction:
            return static_cast<float>(
                physics::joint_angle(world_->stores.bodies, record,
                                     memory_of(world_->stores.joints, slot_of(*world_, id_)).angle_rad));
        case JointKind::Distance:
        case JointKind::Mouse:
        case JointKind::Gear:
        case JointKind::Pulley:
        case JointKind::Filter:
            return 0;
    }
    return 0;
}

float Joint::translation() const {
    const JointRecord& record = record_of(*world_, id_);
    const JointKind kind = kind_of(record);
    if (kind != JointKind::Prismatic && kind != JointKind::Wheel) return 0;
    return joint_translation(world_->stores.bodies, record);
}

float Joint::current_length() const {
    return length(anchor_b() - anchor_a());
}

const JointDef& Joint::definition() const {
    return record_of(*world_, id_).def;
}

Result<void> Joint::redefine(const JointDef& def) {
    const int joint = slot_of(*world_, id_);
    const JointRecord& record = world_->stores.joints.slots[joint];
    if (def.index() != record.def.index()) {
        return Error{std::string("joint.redefine was given a ") +
                     name_of(static_cast<JointKind>(def.index())) + ", and this is a " +
                     name_of(kind_of(record))};
    }
    if (auto fault = validate(def, world_->stores)) return *fault;
    const JointBodies bodies = bodies_of(def, world_->stores);
    if (bodies.a != record.body_a || bodies.b != record.body_b) {
        return Error{std::string(name_of(kind_of(record))) +
                     ".body_a and .body_b cannot be changed: make another joint"};
    }
    redefine_joint(*world_, joint, def);
    return {};
}

Result<void> Joint::set_motor(bool enabled, float speed, float max_effort) {
    return edit(*world_, id_, "set_motor", "revolute, prismatic and wheel", [&](auto& def) {
        if constexpr (requires { def.max_motor_torque_nm; }) {
            def.motor_speed_rad_s = speed;
            def.max_motor_torque_nm = max_effort;
            def.enable_motor = enabled;
            return true;
        } else if constexpr (requires { def.max_motor_force_n; }) {
            def.motor_speed_m_s = speed;
            def.max_motor_force_n = max_effort;
            def.enable_motor = enabled;
            return true;
        } else {
            return false;
        }
    });
}

Result<void> Joint::set_limits(bool enabled, float lower, float upper) {
    return edit(*world_, id_, "set_limits", "revolute, prismatic and wheel", [&](auto& def) {
        if constexpr (requires { def.lower_rad; }) {
            def.lower_rad = lower;
            def.upper_rad = upper;
            def.enable_limit = enabled;
            return true;
        } else if constexpr (requires { def.lower_m; }) {
            def.lower_m = lower;
            def.upper_m = upper;
            def.enable_limit = enabled;
            return true;
        } else {
            return false;
        }
    });
}

Result<void> Joint::set_spring(bool enabled, float frequency_hz, float damping_ratio) {
    return edit(*world_, id_, "set_spring", "distance, revolute, prismatic and wheel", [&](auto& def) {
        if constexpr (requires { def.enable_spring; }) {
            def.enable_spring = enabled;
            def.frequency_hz = frequency_hz;
            def.damping_ratio = damping_ratio;
            return true;
        } else {
            return false;
        }
    });
}

Result<void> Joint::set_target(float target) {
    return edit(*world_, id_, "set_target", "revolute, prismatic and wheel", [&](auto& def) {
        if constexpr (requires { def.target_rad; }) {
            def.target_rad = target;
            return true;
        } else if constexpr (requires { def.target_m; }) {
            def.target_m = target;
            return true;
        } else {
            return false;
        }
    });
}

Result<void> Joint::set_target(Position target_m) {
    if (auto fault = check::placed("mouse_joint.target_m", target_m)) return *fault;
    const Transform frame = world_->stores.bodies.transform(record_of(*world_, id_).body_a);
    return edit(*world_, id_, "set_target", "mouse", [&](auto& def) {
        if constexpr (requires { def.local_target_m; }) {
            def.local_target_m = inverse_transform_point(frame, target_m);
            return true;
        } else {
            return false;
        }
    });
}

Result<void> Joint::set_length(float length_m) {
    return edit(*world_, id_, "set_length", "distance and pulley", [&](auto& def) {
        if constexpr (requires { def.length_m; }) {
            def.length_m = length_m;
            return true;
        } else {
            return false;
        }
    });
}

}  // namespace cairn::physics
