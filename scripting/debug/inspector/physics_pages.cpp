// Worlds, bodies and joints. Changes go through the public interface of the physics, which refuses what makes
// no sense; the last refusal is shown below the fields.
#include <algorithm>
#include <array>
#include <cmath>
#include <imgui.h>
#include <set>

#include "bind/joint_fields.h"
#include "bind/physics_names.h"
#include "bind/physics_objects.h"
#include "debug/inspector/pages.h"

namespace cairn::scripting {
namespace {

using physics::BodyType;

/// What was refused last; one at a time can be edited.
std::string& refusal() {
    static std::string text;
    return text;
}

void note(const physics::Result<void>& result) {
    refusal() = result ? std::string() : result.error().message;
}

void show_refusal() {
    if (!refusal().empty()) ImGui::TextColored({0.98f, 0.5f, 0.4f, 1}, "%s", refusal().c_str());
}

bool drag(const char* label, float& value, float speed) {
    return ImGui::DragFloat(label, &value, speed, 0, 0, "%.4g");
}

void edit_motion(physics::Body& body) {
    const physics::Position p = body.position();
    std::array<double, 3> place{p.x, p.y, static_cast<double>(body.angle())};
    if (ImGui::DragScalarN("x, y, angle", ImGuiDataType_Double, place.data(), 3, 0.02f, nullptr, nullptr,
                           "%.4f"))
        note(body.set_transform({place[0], place[1]}, place[2]));
    const physics::Vec2 v = body.linear_velocity();
    std::array<float, 2> velocity{v.x, v.y};
    if (ImGui::DragFloat2("velocity", velocity.data(), 0.05f, 0, 0, "%.4g m/s"))
        note(body.set_linear_velocity({velocity[0], velocity[1]}));
    float spin = body.angular_velocity();
    if (drag("spin, rad/s", spin, 0.05f)) note(body.set_angular_velocity(spin));
    float scale = body.gravity_scale();
    if (drag("gravity scale", scale, 0.02f)) note(body.set_gravity_scale(scale));
    float damping = body.linear_damping();
    if (drag("damping, 1/s", damping, 0.01f)) note(body.set_linear_damping(damping));
    bool is_awake = body.is_awake();
    if (body.type() != BodyType::Static && ImGui::Checkbox("awake", &is_awake)) body.set_awake(is_awake);
    physics::AxisLocks locks = body.locks();
    ImGui::SameLine();
    bool changed = ImGui::Checkbox("lock x", &locks.x);
    ImGui::SameLine();
    changed |= ImGui::Checkbox("y", &locks.y);
    ImGui::SameLine();
    changed |= ImGui::Checkbox("rotation", &locks.rotation);
    if (changed) body.set_locks(locks);
}

void edit_shape(physics::Shape& shape) {
    ImGui::PushID(static_cast<int>(shape.id().index1));
    const physics::Outline& outline = shape.outline();
    if (ImGui::TreeNodeEx("shape", ImGuiTreeNodeFlags_DefaultOpen, "%s, %d points, radius %.3g m%s",
                          name_of(outline.kind).data(), int{outline.count},
                          static_cast<double>(outline.radius_m), shape.is_sensor() ? ", sensor" : "")) {
        float density = shape.density();
        if (drag("density, kg/m2", density, 0.02f)) note(shape.set_density(density));
        physics::Material material = shape.material();
        bool changed = drag("friction", material.friction, 0.01f);
        changed |= drag("restitution", material.restitution, 0.01f);
        changed |= drag("rolling resistance", material.rolling_resistance, 0.005f);
        changed |= drag("surface speed, m/s", material.surface_speed_m_s, 0.05f);
        if (changed) note(shape.set_material(material));
        ImGui::TreePop();
    }
    ImGui::PopID();
}

void show_body(physics::World& world, physics::BodyId id, bool can_change) {
    auto found = world.body(id);
    if (!found) return;
    physics::Body& body = *found;
    const physics::MassData mass = body.mass_data();
    ImGui::Text("body %u, %s, %.5g kg, %.5g kg m2", static_cast<unsigned>(id.index1 - 1),
                name_of(body.type()).data(), static_cast<double>(mass.mass_kg),
                static_cast<double>(mass.inertia_kg_m2));
    ImGui::BeginDisabled(!can_change);
    edit_motion(body);
    for (const physics::ShapeId shape_id : body.shapes()) {
        if (auto shape = world.shape(shape_id)) edit_shape(*shape);
    }
    ImGui::EndDisabled();
    show_refusal();
}

/// By the description that the Lua API is made from, so all that scripts can change is here too.
bool edit_parameter(physics::JointDef& def, const JointParameter& parameter) {
    double value = parameter.get(def);
    bool changed = false;
    if (parameter.field->type == FieldType::Boolean) {
        bool is_on = value != 0;
        changed = ImGui::Checkbox(parameter.field->name, &is_on);
        value = is_on ? 1 : 0;
    } else {
        const auto speed = static_cast<float>(std::clamp(0.01 * std::fabs(value), 0.01, 1e4));
        changed = ImGui::DragScalar(parameter.field->name, ImGuiDataType_Double, &value, speed, nullptr,
                                    nullptr, "%.5g");
    }
    if (ImGui::IsItemHovered() && *parameter.field->doc != '\0')
        ImGui::SetTooltip("%s", parameter.field->doc);
    if (changed) parameter.set(def, value);
    return changed;
}

void show_joint(physics::World& world, physics::JointId id, bool can_change) {
    auto found = world.joint(id);
    if (!found) return;
    physics::Joint& joint = *found;
    const physics::Vec2 force = joint.reaction_force();
    ImGui::Text("joint %u, %s", static_cast<unsigned>(id.index1 - 1), fields_of(joint.kind()).name);
    ImGui::Text("bodies %u and %u", static_cast<unsigned>(joint.body_a().index1 - 1),
                static_cast<unsigned>(joint.body_b().index1 - 1));
    ImGui::Text("force %.4g, %.4g N; torque %.4g N m", static_cast<double>(force.x),
                static_cast<double>(force.y), static_cast<double>(joint.reaction_torque()));
    ImGui::Text("angle %.4f rad; translation %.4f m; length %.4f m", static_cast<double>(joint.joint_angle()),
                static_cast<double>(joint.translation()), static_cast<double>(joint.current_length()));
    ImGui::BeginDisabled(!can_change);
    physics::JointDef def = joint.definition();
    bool changed = false;
    for (const JointParameter& parameter : fields_of(joint.kind()).all)
        changed = edit_parameter(def, parameter) || changed;
    if (changed) note(joint.redefine(def));
    ImGui::EndDisabled();
    show_refusal();
}

/// A list of which only the lines that are seen are made, however long it is.
template <class Id, class Line>
void show_list(const char* label, const std::vector<Id>& ids, Id& chosen, Line&& line) {
    ImGui::BeginChild(label, {0, 9 * ImGui::GetTextLineHeightWithSpacing()}, true);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(ids.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const Id id = ids[static_cast<std::size_t>(i)];
            ImGui::PushID(i);
            if (ImGui::Selectable(line(id).c_str(), id == chosen)) {
                chosen = id;
                refusal().clear();
            }
            ImGui::PopID();
        }
    }
    ImGui::EndChild();
}

}  // namespace

void show_world_page(const Context& context, Selection& selection, bool can_change) {
    for (std::size_t i = 0; i < context.worlds.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        const std::string label = "world " + std::to_string(i + 1);
        if (ImGui::RadioButton(label.c_str(), selection.world == i)) selection = {.world = i};
    }
    physics::World& world = *context.worlds[selection.world]->world;
    const physics::Counts counts = world.counts();
    ImGui::Text("%llu steps", static_cast<unsigned long long>(world.step_count()));
    ImGui::Text("%d bodies, %d awake", counts.bodies, counts.awake_bodies);
    ImGui::Text("%d shapes, %d joints", counts.shapes, counts.joints);
    ImGui::Text("%d contacts, %d touch", counts.contacts, counts.touching);
    int islands = 0;
    int asleep = 0;
    std::set<int> sleeping_islands;
    for (const physics::DebugIsland& island : world.debug_islands()) {
        islands = std::max(islands, island.island + 1);
        if (island.is_awake) continue;
        ++asleep;
        sleeping_islands.insert(island.island);
    }
    ImGui::Text("%d islands; %d bodies asleep in %zu of them", islands, asleep, sleeping_islands.size());
    const physics::WorldReport report = world.report();
    ImGui::Text("shapes overlap by %.4g mm at most", 1e3 * static_cast<double>(report.max_penetration_m));
    ImGui::Text("joints are off by %.4g mm, %.4g mrad at most",
                1e3 * static_cast<double>(report.max_joint_error_m),
                1e3 * static_cast<double>(report.max_joint_error_rad));
    ImGui::Text("energy %.6g J: kinetic %.6g, potential %.6g, elastic %.6g", report.energy_j(),
                report.kinetic_energy_j, report.potential_energy_j, report.elastic_energy_j);
    ImGui::Text("momentum %.5g, %.5g kg m/s; angular %.5g kg m2/s", report.momentum_x_kg_m_s,
                report.momentum_y_kg_m_s, report.angular_momentum_kg_m2_s);
    ImGui::BeginDisabled(!can_change);
    std::array<float, 2> gravity{world.gravity().x, world.gravity().y};
    if (ImGui::DragFloat2("gravity, m/s2", gravity.data(), 0.05f))
        note(world.set_gravity({gravity[0], gravity[1]}));
    ImGui::EndDisabled();
    show_refusal();
}

void show_bodies_page(physics::World& world, Selection& selection, bool can_change) {
    ImGui::TextDisabled("A click in the picture picks a body.");
    const std::vector<physics::BodyId> bodies = world.bodies();
    show_list("bodies", bodies, selection.body, [&](physics::BodyId id) {
        const auto body = world.body(id);
        return std::to_string(id.index1 - 1) + "  " + std::string(name_of(body->type())) +
               (body->type() != BodyType::Static && !body->is_awake() ? ", asleep" : "");
    });
    show_body(world, selection.body, can_change);
}

void show_joints_page(physics::World& world, Selection& selection, bool can_change) {
    std::vector<physics::JointId> joints;
    std::set<std::uint64_t> seen;  // each is in the lists of two bodies
    for (const physics::BodyId id : world.bodies()) {
        for (const physics::JointId joint : world.body(id)->joints()) {
            if (seen.insert(joint.bits()).second) joints.push_back(joint);
        }
    }
    if (joints.empty()) ImGui::TextDisabled("The world has no joints.");
    show_list("joints", joints, selection.joint, [&](physics::JointId id) {
        return std::to_string(id.index1 - 1) + "  " + fields_of(world.joint(id)->kind()).name;
    });
    show_joint(world, selection.joint, can_change);
}

}  // namespace cairn::scripting
