// The methods of Joint.
#include "bind/joint_fields.h"
#include "bind/modules.h"
#include "bind/pair_filter.h"
#include "bind/physics_objects.h"
#include "data/nearest.h"
#include "data/table_writer.h"

namespace cairn::scripting {
namespace {

/// Of a joint that is there, or that broke in the last step: then it is gone, but an author who reads of it
/// wants to know.
struct KindOf {
    physics::JointKind kind;
};

}  // namespace

template <>
struct Argument<KindOf> {
    static constexpr std::string_view kType = "Joint";
    static KindOf get(lua_State* L, int index) {
        const auto* object = object_at<JointObject>(L, index);
        const physics::World* world = object == nullptr ? nullptr : readable_world(*object->world);
        if (world != nullptr) {
            for (const physics::JointBreak& event : world->joint_breaks()) {
                if (event.joint == object->id) return {event.kind};
            }
        }
        return {Argument<JointRef>::get(L, index).joint.kind()};
    }
};

namespace {

using Change = physics::Result<void>;

std::string_view kind(KindOf self) {
    return fields_of(self.kind).name;
}

Pushed body_a(lua_State* L, JointRef self) {
    push_world_of(L, self.index);
    push_body(L, -1, self.joint.body_a());
    return {1};
}
Pushed body_b(lua_State* L, JointRef self) {
    push_world_of(L, self.index);
    push_body(L, -1, self.joint.body_b());
    return {1};
}

std::tuple<double, double> anchor_a(JointRef self) {
    const physics::Position p = self.joint.anchor_a();
    return {p.x, p.y};
}
std::tuple<double, double> anchor_b(JointRef self) {
    const physics::Position p = self.joint.anchor_b();
    return {p.x, p.y};
}
std::tuple<float, float> reaction_force(JointRef self) {
    const physics::Vec2 f = self.joint.reaction_force();
    return {f.x, f.y};
}
float reaction_torque(JointRef self) {
    return self.joint.reaction_torque();
}
float angle(JointRef self) {
    return self.joint.joint_angle();
}
float length(JointRef self) {
    return self.joint.current_length();
}

float translation(JointRef self) {
    return self.joint.translation();
}

Pushed parameter(lua_State* L, JointRef self, std::string_view name) {
    const JointKindFields& fields = fields_of(self.joint.kind());
    std::vector<std::string> names;
    for (const JointParameter& candidate : fields.all) {
        if (name == candidate.field->name) {
            push_parameter(L, self.joint.definition(), candidate);
            return {1};
        }
        names.emplace_back(candidate.field->name);
    }
    call_error(L, "name is " + quote_text(name) + ": a " + fields.name + " joint has no such parameter" +
                      suggestion(name, names));
}

Pushed parameters(lua_State* L, JointRef self) {
    const JointKindFields& fields = fields_of(self.joint.kind());
    lua_createtable(L, 0, static_cast<int>(fields.all.size()));
    for (const JointParameter& candidate : fields.all) {
        push_parameter(L, self.joint.definition(), candidate);
        lua_setfield(L, -2, candidate.field->name);
    }
    return {1};
}

void change(lua_State* L, JointRef self, TableArgument changes) {
    change_joint(L, self, changes.index);
}

Change set_motor(JointRef self, bool enabled, float speed, Ranged<kNotNegativeOrInfinite, float> max_effort) {
    return self.joint.set_motor(enabled, speed, max_effort);
}
Change set_limits(JointRef self, bool enabled, float lower, float upper) {
    return self.joint.set_limits(enabled, lower, upper);
}
Change set_length(JointRef self, Positive length_m) {
    return self.joint.set_length(length_m);
}
Change set_spring(JointRef self, bool enabled, NotNegative frequency, NotNegative damping_ratio) {
    return self.joint.set_spring(enabled, frequency, damping_ratio);
}

Change set_target(lua_State* L, JointRef self, double target, std::optional<double> y) {
    const bool is_mouse = self.joint.kind() == physics::JointKind::Mouse;
    if (is_mouse && !y) call_error(L, "y is nil; a mouse joint has a target x, y");
    if (is_mouse) return self.joint.set_target(physics::Position{target, *y});
    if (y) call_error(L, "y is given, but only a mouse joint has a target x, y");
    return self.joint.set_target(static_cast<float>(target));
}

Change destroy(JointRef self) {
    return self.object.world->world->destroy_joint(self.object.id);
}
bool is_valid(Maybe<JointObject> self) {
    const physics::World* world = readable_world(*self.object.world);
    return world != nullptr && world->contains(self.object.id);
}

constexpr std::array<std::string_view, 1> kReturnsBody = {"Body"};
constexpr std::array<std::string_view, 1> kReturnsValue = {"number|boolean"};
constexpr std::array<std::string_view, 1> kReturnsTable = {"table"};

constexpr Function kFunctions[] = {
    function<&kind>("kind", "", "kind",
                    "\"distance\", \"revolute\", \"prismatic\", \"weld\", \"wheel\", \"motor\", "
                    "\"mouse\", \"gear\", \"pulley\", \"friction\" or \"filter\". Of a joint that broke, "
                    "too, until the next "
                    "step."),
    function_pushing<&body_a>("body_a", "", "body", kReturnsBody, ""),
    function_pushing<&body_b>("body_b", "", "body", kReturnsBody, ""),
    function<&anchor_a>("anchor_a", "", "x [m], y [m]", "In the world; of a mouse joint the target."),
    function<&anchor_b>("anchor_b", "", "x [m], y [m]", "In the world."),
    function<&reaction_force>("reaction_force", "", "x [N], y [N]",
                              "What the joint did to body b, as the mean over the last step."),
    function<&reaction_torque>("reaction_torque", "", "torque [N m]",
                               "What the joint did to body b, as the mean over the last step."),
    function<&angle>("angle", "", "angle [rad]",
                     "Of b relative to a, with whole turns; 0 for kinds that have none."),
    function<&translation>("translation", "", "translation [m]",
                           "Of b along the axis of a prismatic or wheel joint; 0 for others."),
    function<&length>("length", "", "length [m]", "The distance between the two anchors."),
    function_pushing<&parameter>(
        "parameter", "name", "value", kReturnsValue,
        "The present value of a field that `add_..._joint` of this kind takes besides bodies and places, or "
        "of a frame: `local_x_a`, `local_y_a`, `local_x_b`, `local_y_b` (m), `local_angle_a` and "
        "`local_angle_b` (rad), the anchors and axes in the coordinates of the bodies."),
    function_pushing<&parameters>("parameters", "", "values", kReturnsTable,
                                  "A new table of them all, by name."),
    function<&change>("change", "fields", "",
                      "Changes any of the parameters, by the names of `parameter`, and wakes the bodies: "
                      "`joint:change{ motor_speed = 3, upper = 1 }`. What is not named stays."),
    function<&set_motor>("set_motor", "enabled, speed, max_effort", "",
                         "Of a revolute or wheel joint in rad/s and N m, of a prismatic one in m/s and N."),
    function<&set_limits>("set_limits", "enabled, lower, upper", "",
                          "Of a revolute joint in rad, of a prismatic or wheel joint in m."),
    function<&set_spring>("set_spring", "enabled, frequency [Hz], damping_ratio", "",
                          "Of a distance, revolute, prismatic or wheel joint."),
    function<&set_target>("set_target", "target, y = nil", "",
                          "Where the spring draws to: of a revolute joint in rad, of a prismatic or wheel "
                          "joint in m. Of a mouse joint x, y in the world."),
    function<&set_length>("set_length", "length [m]", "",
                          "Of a distance joint: its rest length. Of a pulley joint: its rope's."),
    function<&destroy>("destroy", "", "", ""),
    function<&is_valid>("is_valid", "", "valid",
                        "Whether the joint was not destroyed; it goes with either of its bodies."),
};

}  // namespace

const Module kJointMethods = {"Joint",
                              "Two bodies held together. `joint.data` is a table of your own that is kept as "
                              "long as the joint and may be "
                              "replaced.",
                              kFunctions, true};

}  // namespace cairn::scripting
