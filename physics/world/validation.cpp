// Rules and words for bad definitions.
#include "world/validation.h"

#include <cairn/physics/tuning.h>

#include "world/features.h"

namespace cairn::physics {
namespace {

double d(float x) {
    return static_cast<double>(x);
}

check::Fault validate_tasks(const TaskSystem* tasks) {
    if (tasks == nullptr) return {};
    if (!tasks->enqueue) return Error{"world.tasks.enqueue is null, but must be a function"};
    if (!tasks->wait) return Error{"world.tasks.wait is null, but must be a function"};
    return {};
}

}  // namespace

check::Fault validate(const WorldDef& def) {
    return check::first_of(
        {check::finite("world.gravity_m_s2", def.gravity_m_s2),
         check::within("world.substeps", def.substeps, 1, 64),
         check::not_negative("world.hit_speed_m_s", d(def.hit_speed_m_s)),
         check::not_negative("world.restitution_speed_m_s", d(def.restitution_speed_m_s)),
         check::positive("world.max_push_out_speed_m_s", d(def.max_push_out_speed_m_s)),
         check::within("world.threads", def.threads, 1, TaskPool::kMaxThreads), validate_tasks(def.tasks),
         require_built_in(Feature::DirectSolver, def.joint_solver == JointSolver::Direct)});
}

check::Fault validate(const BodyDef& def) {
    return check::first_of(
        {check::within("body.type", static_cast<int>(def.type), 0, static_cast<int>(BodyType::Dynamic)),
         check::placed("body.position_m", def.position_m), check::finite("body.angle_rad", def.angle_rad),
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
         check::within("material.kind", material.kind, 0, kMaterialKinds - 1),
         require_built_in(Feature::Restitution, material.restitution > 0),
         require_built_in(Feature::RollingResistance, material.rolling_resistance > 0),
         require_built_in(Feature::SurfaceSpeed, material.surface_speed_m_s != 0)});
}

check::Fault validate(const MaterialRule& rule) {
    const auto known = [](const char* field, Mixing mixing) {
        return check::within(field, static_cast<double>(mixing), 0, static_cast<double>(Mixing::Fixed));
    };
    return check::first_of({known("material_rule.friction.mixing", rule.friction.mixing),
                            known("material_rule.restitution.mixing", rule.restitution.mixing),
                            check::not_negative("material_rule.friction.fixed", d(rule.friction.fixed)),
                            check::within("material_rule.restitution.fixed", d(rule.restitution.fixed), 0, 1),
                            require_built_in(Feature::Restitution, rule.restitution.fixed > 0)});
}

check::Fault validate_material_kinds(int kind_a, int kind_b) {
    return check::first_of({check::within("material_rule.kind_a", kind_a, 0, kMaterialKinds - 1),
                            check::within("material_rule.kind_b", kind_b, 0, kMaterialKinds - 1)});
}

check::Fault validate(const ShapeDef& def) {
    return check::first_of({check::not_negative("shape.density_kg_m2", d(def.density_kg_m2)),
                            validate(def.material), check::finite("shape.one_way_normal", def.one_way_normal),
                            require_built_in(Feature::Sensors, def.sensor),
                            require_built_in(Feature::Events, def.contact_events || def.hit_events)});
}

check::Fault validate_step(float dt_s) {
    return check::require(dt_s > 0 && dt_s <= 1, "step.dt_s", d(dt_s), "greater than 0 and at most 1 s");
}

check::Fault refuse_within_step(const WorldState& world) {
    if (!world.stepping && !world.stores.filter_calls.any()) return {};
    const std::string what = world.stepping ? "step" : "query";
    return Error{"the world is within a " + what + ", and must not be changed by the filter that it asks"};
}

Error bad_handle(const char* kind, std::uint64_t index1, std::uint64_t world, std::uint64_t own_world) {
    const std::string name = kind;
    if (index1 == 0) return {"the " + name + " handle is null"};
    if (world != own_world) return {"the " + name + " belongs to another world"};
    return {"the " + name + " has been destroyed"};
}

}  // namespace cairn::physics
