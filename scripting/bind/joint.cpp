// The methods of Joint.
#include "bind/modules.h"
#include "bind/physics_objects.h"

namespace cairn::scripting {
namespace {

using Change = physics::Result<void>;

std::string_view kind(JointRef self) {
    switch (self.joint.kind()) {
        case physics::JointKind::Revolute:
            return "revolute";
        case physics::JointKind::Distance:
            return "distance";
    }
    return "";
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

Change set_motor(JointRef self, bool enabled, float speed, float max_torque) {
    return self.joint.set_motor(enabled, speed, max_torque);
}
Change set_limits(JointRef self, bool enabled, float lower, float upper) {
    return self.joint.set_limits(enabled, lower, upper);
}
Change set_length(JointRef self, float length_m) {
    return self.joint.set_length(length_m);
}
Change set_spring(JointRef self, bool enabled, float frequency, float damping_ratio) {
    return self.joint.set_spring(enabled, frequency, damping_ratio);
}

Change destroy(JointRef self) {
    return self.object.world->world->destroy_joint(self.object.id);
}
bool is_valid(Maybe<JointObject> self) {
    const WorldObject& owner = *self.object.world;
    return owner.world && owner.world->contains(self.object.id);
}

constexpr std::array<std::string_view, 1> kReturnsBody = {"Body"};

constexpr Function kFunctions[] = {
    function<&kind>("kind", "", "kind", "\"revolute\" or \"distance\"."),
    function_pushing<&body_a>("body_a", "", "body", kReturnsBody, ""),
    function_pushing<&body_b>("body_b", "", "body", kReturnsBody, ""),
    function<&anchor_a>("anchor_a", "", "x [m], y [m]", "In the world."),
    function<&anchor_b>("anchor_b", "", "x [m], y [m]", "In the world."),
    function<&reaction_force>("reaction_force", "", "x [N], y [N]",
                              "What the joint did to body b in the last step."),
    function<&reaction_torque>("reaction_torque", "", "torque [N m]",
                               "What the joint did to body b in the last step."),
    function<&angle>("angle", "", "angle [rad]", "Of a revolute joint: of b relative to a; 0 for others."),
    function<&length>("length", "", "length [m]", "The distance between the two anchors."),
    function<&set_motor>("set_motor", "enabled, speed [rad/s], max_torque [N m]", "", "Of a revolute joint."),
    function<&set_limits>("set_limits", "enabled, lower [rad], upper [rad]", "", "Of a revolute joint."),
    function<&set_length>("set_length", "length [m]", "", "Of a distance joint: its rest length."),
    function<&set_spring>("set_spring", "enabled, frequency [Hz], damping_ratio", "", "Of a distance joint."),
    function<&destroy>("destroy", "", "", ""),
    function<&is_valid>("is_valid", "", "valid",
                        "Whether the joint was not destroyed; it goes with either of its bodies."),
};

}  // namespace

const Module kJointMethods = {"Joint", "Two bodies held together.", kFunctions, true};

}  // namespace cairn::scripting
