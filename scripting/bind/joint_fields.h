// The described fields of joints: what `world:add_..._joint` takes, and what can be read and changed while a
// joint lives. Invariant: each parameter is named once, beside the member of the physics definition that
// holds it; making, reading, changing and the reference all follow from that.
#pragma once

#include <lua.hpp>
#include <span>
#include <string_view>

#include <cairn/physics/joint.h>

#include "bind/fields.h"
#include "bind/physics_objects.h"

namespace cairn::scripting {

/// A number or a boolean (as 0 or 1) of a joint's definition.
struct JointParameter {
    const Field* field;
    double (*get)(const physics::JointDef& def);
    void (*set)(physics::JointDef& def, double value);
};

struct JointKindFields {
    const char* name;  ///< "revolute"
    FieldSet making;   ///< of `world:add_..._joint`
    FieldSet changing;
    std::span<const JointParameter> made;  ///< what can be given when the joint is made, besides its place
    std::span<const JointParameter> all;   ///< what can be read and changed while it lives
};

/// By JointKind.
extern const JointKindFields kJointKinds[11];
constexpr const JointKindFields& fields_of(physics::JointKind kind) {
    return kJointKinds[static_cast<int>(kind)];
}

/// Makes the joint that a table describes and pushes it. Its frames follow from how the bodies stand now.
void push_made_joint(lua_State* L, WorldRef world, int table, physics::JointKind kind);

/// Changes what a table names, and nothing else.
void change_joint(lua_State* L, JointRef joint, int table);

/// Pushes a parameter's present value.
void push_parameter(lua_State* L, const physics::JointDef& def, const JointParameter& parameter);

namespace joint_places {

// Given when a joint is made, and never changed.
inline constexpr Field kBodyA =
    required_field("body_a", FieldType::Body, "`world:ground()` for a joint to the world");
inline constexpr Field kBodyB = required_field("body_b", FieldType::Body, "");
inline constexpr Field kHeldBody = required_field("body", FieldType::Body, "what is drawn");
inline constexpr Field kJoint1 = required_field("joint_1", FieldType::Joint, "revolute or prismatic");
inline constexpr Field kJoint2 = required_field("joint_2", FieldType::Joint, "revolute or prismatic");
inline constexpr Field kX =
    required_field("x", FieldType::Number, "m; the anchor on both bodies, in the world");
inline constexpr Field kY = required_field("y", FieldType::Number, "m");
inline constexpr Field kTargetX =
    required_field("x", FieldType::Number, "m; what is held now, and the target at first, in the world");
inline constexpr Field kAxisAngle =
    optional_field("axis_angle", FieldType::Number, "rad, of the axis in the world");
inline constexpr Field kAxisX = optional_field(
    "axis_x", FieldType::Number, "the axis as a direction of any length, instead of axis_angle");
inline constexpr Field kAxisY = optional_field("axis_y", FieldType::Number, "");
inline constexpr Field kAnchorXA = optional_field(
    "x_a", FieldType::Number, "m; the anchor on body a, in the world; absent: the body's origin");
inline constexpr Field kAnchorYA = optional_field("y_a", FieldType::Number, "m");
inline constexpr Field kAnchorXB = optional_field("x_b", FieldType::Number, "m; the anchor on body b");
inline constexpr Field kAnchorYB = optional_field("y_b", FieldType::Number, "m");
inline constexpr Field kData = optional_field("data", FieldType::Table, "becomes joint.data");

}  // namespace joint_places

}  // namespace cairn::scripting
