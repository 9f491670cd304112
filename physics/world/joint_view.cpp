// The public Joint view.
#include <cairn/physics/joint.h>

#include "world/joints.h"
#include "world/validation.h"

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

Error wrong_kind(const char* what, const char* kind) {
    return {"joint." + std::string(what) + " belongs to " + kind + " joints, and this is another kind"};
}

}  // namespace

JointKind Joint::kind() const {
    return std::holds_alternative<RevoluteJointDef>(record_of(*world_, id_).def) ? JointKind::Revolute
                                                                                 : JointKind::Distance;
}

BodyId Joint::body_a() const {
    return world_->stores.bodies.slots.id(record_of(*world_, id_).body_a);
}
BodyId Joint::body_b() const {
    return world_->stores.bodies.slots.id(record_of(*world_, id_).body_b);
}

Position Joint::anchor_a() const {
    const JointRecord& record = record_of(*world_, id_);
    const Vec2 local = std::visit([](const auto& def) { return def.local_anchor_a_m; }, record.def);
    return transform_point(world_->stores.bodies.transform(record.body_a), local);
}

Position Joint::anchor_b() const {
    const JointRecord& record = record_of(*world_, id_);
    const Vec2 local = std::visit([](const auto& def) { return def.local_anchor_b_m; }, record.def);
    return transform_point(world_->stores.bodies.transform(record.body_b), local);
}

Vec2 Joint::reaction_force() const {
    return record_of(*world_, id_).reaction_force;
}
float Joint::reaction_torque() const {
    return record_of(*world_, id_).reaction_torque;
}
std::uint64_t Joint::user_data() const {
    return record_of(*world_, id_).user_data;
}
void Joint::set_user_data(std::uint64_t data) {
    record_of(*world_, id_).user_data = data;
}

float Joint::joint_angle() const {
    const JointRecord& record = record_of(*world_, id_);
    const auto* def = std::get_if<RevoluteJointDef>(&record.def);
    if (!def) return 0;
    const Rotation a = world_->stores.bodies.transform(record.body_a).q;
    const Rotation b = world_->stores.bodies.transform(record.body_b).q;
    return (inverse(Rotation::from_angle(def->reference_angle_rad)) * (inverse(a) * b)).angle_rad();
}

float Joint::current_length() const {
    return length(anchor_b() - anchor_a());
}

Result<void> Joint::set_motor(bool enabled, float speed_rad_s, float max_torque_nm) {
    auto* def = std::get_if<RevoluteJointDef>(&record_of(*world_, id_).def);
    if (!def) return wrong_kind("set_motor", "revolute");
    if (auto fault = validate_motor(speed_rad_s, max_torque_nm)) return *fault;
    def->enable_motor = enabled;
    def->motor_speed_rad_s = speed_rad_s;
    def->max_motor_torque_nm = max_torque_nm;
    wake_joint_bodies(world_->stores, slot_of(*world_, id_));
    return {};
}

Result<void> Joint::set_limits(bool enabled, float lower_rad, float upper_rad) {
    auto* def = std::get_if<RevoluteJointDef>(&record_of(*world_, id_).def);
    if (!def) return wrong_kind("set_limits", "revolute");
    if (auto fault = validate_limits(lower_rad, upper_rad)) return *fault;
    def->enable_limit = enabled;
    def->lower_rad = lower_rad;
    def->upper_rad = upper_rad;
    wake_joint_bodies(world_->stores, slot_of(*world_, id_));
    return {};
}

Result<void> Joint::set_length(float length_m) {
    auto* def = std::get_if<DistanceJointDef>(&record_of(*world_, id_).def);
    if (!def) return wrong_kind("set_length", "distance");
    DistanceJointDef changed = *def;
    changed.length_m = length_m;
    if (auto fault = validate(changed, world_->stores)) return *fault;
    *def = changed;
    wake_joint_bodies(world_->stores, slot_of(*world_, id_));
    return {};
}

Result<void> Joint::set_spring(bool enabled, float frequency_hz, float damping_ratio) {
    auto* def = std::get_if<DistanceJointDef>(&record_of(*world_, id_).def);
    if (!def) return wrong_kind("set_spring", "distance");
    if (auto fault = validate_spring(frequency_hz, damping_ratio)) return *fault;
    def->enable_spring = enabled;
    def->frequency_hz = frequency_hz;
    def->damping_ratio = damping_ratio;
    wake_joint_bodies(world_->stores, slot_of(*world_, id_));
    return {};
}

}  // namespace cairn::physics
