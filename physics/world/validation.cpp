// Rules and words for bad definitions.
#include "world/validation.h"

#include <cairn/physics/tuning.h>

namespace cairn::physics {
namespace {

double d(float x) {
    return static_cast<double>(x);
}

check::Fault validate_joint_bodies(const char* kind, BodyId a, BodyId b, const Stores& stores) {
    const std::string name = kind;
    const std::uint64_t tag = stores.bodies.slots.world_tag();
    for (const auto& [field, id] : {std::pair{".body_a", a}, std::pair{".body_b", b}}) {
        if (stores.bodies.slots.find(id) == kNone) {
            return Error{name + field + ": " + bad_handle("body", id.index1, id.world, tag).message};
        }
    }
    if (a == b) return Error{name + ".body_a and .body_b are the same body, but must be two bodies"};
    const auto type = [&](BodyId id) { return stores.bodies.slots[stores.bodies.slots.find(id)].type; };
    if (type(a) != BodyType::Dynamic && type(b) != BodyType::Dynamic) {
        return Error{name + ".body_a and .body_b are both immovable, but one must be dynamic"};
    }
    return {};
}

check::Fault validate_tasks(const TaskSystem* tasks) {
    if (tasks == nullptr) return {};
    if (!tasks->enqueue) return Error{"world.tasks.enqueue is null, but must be a function"};
    if (!tasks->wait) return Error{"world.tasks.wait is null, but must be a function"};
    return {};
}

}  // namespace

check::Fault validate(const WorldDef& def) {
    return check::first_of({check::finite("world.gravity_m_s2", def.gravity_m_s2),
                            check::within("world.substeps", def.substeps, 1, 64),
                            check::not_negative("world.hit_speed_m_s", d(def.hit_speed_m_s)),
                            check::not_negative("world.restitution_speed_m_s", d(def.restitution_speed_m_s)),
                            check::positive("world.max_push_out_speed_m_s", d(def.max_push_out_speed_m_s)),
                            check::within("world.threads", def.threads, 1, TaskPool::kMaxThreads),
                            validate_tasks(def.tasks)});
}

check::Fault validate(const BodyDef& def) {
    return check::first_of({check::finite("body.position_m", def.position_m),
                            check::finite("body.angle_rad", def.angle_rad),
                            check::finite("body.linear_velocity_m_s", def.linear_velocity_m_s),
                            check::finite("body.angular_velocity_rad_s", d(def.angular_velocity_rad_s)),
                            check::not_negative("body.linear_damping_1_s", d(def.linear_damping_1_s)),
                            check::not_negative("body.angular_damping_1_s", d(def.angular_damping_1_s)),
                            check::finite("body.gravity_scale", d(def.gravity_scale)),
                            check::not_negative("body.sleep_speed_m_s", d(def.sleep_speed_m_s))});
}

check::Fault validate(const Material& material) {
    return check::first_of(
        {check::not_negative("material.friction", d(material.friction)),
         check::within("material.restitution", d(material.restitution), 0, 1),
         check::not_negative("material.rolling_resistance", d(material.rolling_resistance)),
         check::finite("material.surface_speed_m_s", d(material.surface_speed_m_s)),
         check::within("material.kind", material.kind, 0, kMaterialKinds - 1)});
}

check::Fault validate(const MaterialRule& rule) {
    const auto known = [](const char* field, Mixing mixing) {
        return check::within(field, static_cast<double>(mixing), 0, static_cast<double>(Mixing::Fixed));
    };
    return check::first_of(
        {known("material_rule.friction.mixing", rule.friction.mixing),
         known("material_rule.restitution.mixing", rule.restitution.mixing),
         check::not_negative("material_rule.friction.fixed", d(rule.friction.fixed)),
         check::within("material_rule.restitution.fixed", d(rule.restitution.fixed), 0, 1)});
}

check::Fault validate_material_kinds(int kind_a, int kind_b) {
    return check::first_of({check::within("material_rule.kind_a", kind_a, 0, kMaterialKinds - 1),
                            check::within("material_rule.kind_b", kind_b, 0, kMaterialKinds - 1)});
}

check::Fault validate(const ShapeDef& def) {
    return check::first_of({check::not_negative("shape.density_kg_m2", d(def.density_kg_m2)),
                            validate(def.material),
                            check::finite("shape.one_way_normal", def.one_way_normal)});
}

check::Fault validate(const RevoluteJointDef& def, const Stores& stores) {
    return check::first_of({validate_joint_bodies("revolute_joint", def.body_a, def.body_b, stores),
                            check::finite("revolute_joint.local_anchor_a_m", def.local_anchor_a_m),
                            check::finite("revolute_joint.local_anchor_b_m", def.local_anchor_b_m),
                            check::finite("revolute_joint.reference_angle_rad", def.reference_angle_rad),
                            validate_limits(def.lower_rad, def.upper_rad),
                            validate_motor(def.motor_speed_rad_s, def.max_motor_torque_nm)});
}

check::Fault validate(const DistanceJointDef& def, const Stores& stores) {
    const auto at_least_slop = [](const char* field, float length_m) {
        return check::require(std::isfinite(length_m) && length_m > tuning::kLinearSlop_m, field, d(length_m),
                              "finite and greater than 0.005 m");
    };
    return check::first_of({validate_joint_bodies("distance_joint", def.body_a, def.body_b, stores),
                            check::finite("distance_joint.local_anchor_a_m", def.local_anchor_a_m),
                            check::finite("distance_joint.local_anchor_b_m", def.local_anchor_b_m),
                            at_least_slop("distance_joint.length_m", def.length_m),
                            validate_spring(def.frequency_hz, def.damping_ratio),
                            check::not_negative("distance_joint.min_length_m", d(def.min_length_m)),
                            check::require(def.min_length_m <= def.length_m, "distance_joint.min_length_m",
                                           d(def.min_length_m), "at most length_m"),
                            check::require(def.max_length_m >= def.length_m, "distance_joint.max_length_m",
                                           d(def.max_length_m), "at least length_m")});
}

check::Fault validate_step(float dt_s) {
    return check::require(dt_s > 0 && dt_s <= 1, "step.dt_s", d(dt_s), "greater than 0 and at most 1 s");
}

check::Fault validate_limits(float lower_rad, float upper_rad) {
    const auto inside = [](const char* field, float angle) {
        return check::require(angle > -kPi && angle < kPi, field, d(angle), "between -pi and pi");
    };
    return check::first_of({inside("revolute_joint.lower_rad", lower_rad),
                            inside("revolute_joint.upper_rad", upper_rad),
                            check::require(lower_rad <= upper_rad, "revolute_joint.lower_rad", d(lower_rad),
                                           "at most upper_rad")});
}

check::Fault validate_motor(float speed_rad_s, float max_torque_nm) {
    return check::first_of({check::finite("revolute_joint.motor_speed_rad_s", d(speed_rad_s)),
                            check::require(max_torque_nm >= 0, "revolute_joint.max_motor_torque_nm",
                                           d(max_torque_nm), "at least 0")});
}

check::Fault validate_spring(float frequency_hz, float damping_ratio) {
    return check::first_of({check::positive("distance_joint.frequency_hz", d(frequency_hz)),
                            check::not_negative("distance_joint.damping_ratio", d(damping_ratio))});
}

check::Fault refuse_within_step(const WorldState& world) {
    if (!world.stepping) return {};
    return Error{"the world is within a step, and must not be changed by the filter that it asks"};
}

Error bad_handle(const char* kind, std::uint64_t index1, std::uint64_t world, std::uint64_t own_world) {
    const std::string name = kind;
    if (index1 == 0) return {"the " + name + " handle is null"};
    if (world != own_world) return {"the " + name + " belongs to another world"};
    return {"the " + name + " has been destroyed"};
}

}  // namespace cairn::physics
