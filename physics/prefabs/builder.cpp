// Making and undoing.
#include "prefabs/builder.h"

namespace cairn::physics {

void destroy_prefab(World& world, const Prefab& prefab) {
    for (const JointId joint : prefab.joints) {
        if (world.contains(joint)) world.destroy_joint(joint).value();
    }
    for (const BodyId body : prefab.bodies) {
        if (world.contains(body)) world.destroy_body(body).value();
    }
}

check::Fault check_count(const char* field, int value, int low, int high) {
    return check::within(field, value, low, high);
}

void Builder::require(std::initializer_list<check::Fault> faults) {
    for (const check::Fault& fault : faults) {
        if (!fault) continue;
        if (fault_)
            fault_->message += std::string(kAndAlso) + fault->message;
        else
            fault_ = fault;
    }
}

BodyId Builder::body(const BodyDef& def) {
    if (fault_) return {};
    const BodyId id = keep(world_.create_body(def));
    if (!fault_) made_.bodies.push_back(id);
    return id;
}

void Builder::shape(BodyId body, const Geometry& geometry, const ShapeDef& def) {
    if (!fault_) keep(world_.create_shape(body, geometry, def));
}

JointId Builder::joint(const JointDef& def) {
    if (fault_) return {};
    const JointId id = keep(world_.create_joint(def));
    if (!fault_) made_.joints.push_back(id);
    return id;
}

BodyId Builder::holder(const PrefabEnd& end, Position point_m) {
    if (!end.body) return body({.type = BodyType::Static, .position_m = point_m});
    if (!fault_) {
        if (const auto held_by = world_.body(end.body); !held_by) fault_ = held_by.error();
    }
    return end.body;
}

Vec2 Builder::local(BodyId body, Position point_m) const {
    if (fault_) return {};
    return inverse_transform_point(world_.body(body)->transform(), point_m);
}

JointId Builder::pin(BodyId a, BodyId b, Position point_m, float friction_torque_nm, JointStrength strength) {
    RevoluteJointDef def;
    place(def, a, b, point_m);
    def.enable_motor = friction_torque_nm > 0;
    def.max_motor_torque_nm = friction_torque_nm;
    def.strength = strength;
    return joint(def);
}

}  // namespace cairn::physics
