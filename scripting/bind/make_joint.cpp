// Joints from tables, and their changes. Anchors and axes are given in the world and become frames on the
// bodies as they stand at that moment, so that a new joint is at rest: its angle and its translation are 0.
#include "bind/joint_fields.h"
#include "bind/object_data.h"

namespace cairn::scripting {
namespace {

using namespace joint_places;
using physics::JointKind;
using physics::Position;
using physics::Vec2;

constexpr double kUpward_rad = static_cast<double>(physics::kPi) / 2;
/// Of a mouse joint unless it is given: a hundred times what the body weighs on earth.
constexpr float kGripForce_n_kg = 1000;

struct LivingBody {
    physics::BodyId id{};
    physics::Transform transform{};
};

LivingBody read_body(lua_State* L, const FieldReader& reader, const Field& field) {
    reader.push(field);
    const auto body = living_body_at(L, -1);
    if (!body) reader.fail(field, "it was destroyed");
    lua_pop(L, 1);
    return {body->id(), body->transform()};
}

physics::JointId read_geared(lua_State* L, const FieldReader& reader, const Field& field) {
    reader.push(field);
    const auto joint = living_joint_at(L, -1);
    if (!joint) reader.fail(field, "it was destroyed");
    lua_pop(L, 1);
    return joint->id();
}

/// Two fields that only make sense together.
void require_both(lua_State* L, const FieldReader& reader, const Field& first, const Field& second) {
    if (reader.has(first) == reader.has(second)) return;
    const bool has_first = reader.has(first);
    call_error(L, std::string(has_first ? first.name : second.name) + " is given without " +
                      (has_first ? second.name : first.name) + "; both or neither are expected");
}

/// An anchor; absent, the body's origin.
Position read_anchor(lua_State* L, const FieldReader& reader, const Field& x, const Field& y,
                     const LivingBody& body) {
    require_both(L, reader, x, y);
    if (!reader.has(x)) return body.transform.p;
    return {reader.number(x), reader.number(y)};
}

/// In the world, rad.
double read_axis(lua_State* L, const FieldReader& reader, double default_rad) {
    require_both(L, reader, kAxisX, kAxisY);
    if (!reader.has(kAxisX)) return reader.optional_number(kAxisAngle).value_or(default_rad);
    if (reader.has(kAxisAngle)) {
        call_error(L, "axis_angle is given beside axis_x and axis_y; one or the other is expected");
    }
    const double x = reader.number(kAxisX);
    const double y = reader.number(kAxisY);
    if (x == 0 && y == 0) call_error(L, "axis_x, axis_y = 0, 0: must be a direction");
    return physics::deterministic::atan2(y, x);
}

/// How b stands to a, rad.
float turn_between(const LivingBody& a, const LivingBody& b) {
    return (physics::inverse(a.transform.q) * b.transform.q).angle_rad();
}

/// Bodies and anchors of the kinds that have these.
class Places {
  public:
    Places(lua_State* L, const FieldReader& reader)
        : L_(L), reader_(reader), a_(read_body(L, reader, kBodyA)), b_(read_body(L, reader, kBodyB)) {}

    [[nodiscard]] const LivingBody& a() const { return a_; }
    [[nodiscard]] const LivingBody& b() const { return b_; }

    template <class Def>
    void set_bodies(Def& def) const {
        def.body_a = a_.id;
        def.body_b = b_.id;
    }
    template <class Def>
    void set_anchor(Def& def) const {
        set_bodies(def);
        const Position anchor{reader_.number(kX), reader_.number(kY)};
        def.local_anchor_a_m = physics::inverse_transform_point(a_.transform, anchor);
        def.local_anchor_b_m = physics::inverse_transform_point(b_.transform, anchor);
    }
    /// Gives how far the two are apart, m.
    template <class Def>
    float set_two_anchors(Def& def) const {
        set_bodies(def);
        const Position anchor_a = read_anchor(L_, reader_, kAnchorXA, kAnchorYA, a_);
        const Position anchor_b = read_anchor(L_, reader_, kAnchorXB, kAnchorYB, b_);
        def.local_anchor_a_m = physics::inverse_transform_point(a_.transform, anchor_a);
        def.local_anchor_b_m = physics::inverse_transform_point(b_.transform, anchor_b);
        return physics::length(anchor_b - anchor_a);
    }

  private:
    lua_State* L_;
    const FieldReader& reader_;
    LivingBody a_;
    LivingBody b_;
};

float in_frame(double world_angle_rad, const LivingBody& body) {
    return static_cast<float>(world_angle_rad) - body.transform.q.angle_rad();
}

/// Bodies and frames; the parameters are as in the physics.
physics::JointDef placed_joint(lua_State* L, WorldRef world, const FieldReader& reader, JointKind kind) {
    switch (kind) {
        case JointKind::Distance: {
            physics::DistanceJointDef def;
            def.length_m = Places(L, reader).set_two_anchors(def);
            return def;
        }
        case JointKind::Revolute: {
            physics::RevoluteJointDef def;
            const Places places(L, reader);
            places.set_anchor(def);
            def.local_angle_a_rad = turn_between(places.a(), places.b());
            return def;
        }
        case JointKind::Prismatic: {
            physics::PrismaticJointDef def;
            const Places places(L, reader);
            places.set_anchor(def);
            const double axis_rad = read_axis(L, reader, 0);
            def.local_angle_a_rad = in_frame(axis_rad, places.a());
            def.local_angle_b_rad = in_frame(axis_rad, places.b());
            return def;
        }
        case JointKind::Weld: {
            physics::WeldJointDef def;
            const Places places(L, reader);
            places.set_anchor(def);
            def.local_angle_a_rad = turn_between(places.a(), places.b());
            return def;
        }
        case JointKind::Wheel: {
            physics::WheelJointDef def;
            const Places places(L, reader);
            places.set_anchor(def);
            def.local_angle_a_rad = in_frame(read_axis(L, reader, kUpward_rad), places.a());
            return def;
        }
        case JointKind::Motor: {
            physics::MotorJointDef def;
            const Places places(L, reader);
            places.set_anchor(def);
            def.local_angle_b_rad = -turn_between(places.a(), places.b());
            return def;
        }
        case JointKind::Mouse: {
            physics::MouseJointDef def;
            const LivingBody body = read_body(L, reader, kHeldBody);
            const Position target{reader.number(kTargetX), reader.number(kY)};
            push_ground(L, world);
            const LivingBody ground{living_body_at(L, -1)->id(), living_body_at(L, -1)->transform()};
            lua_pop(L, 1);
            def.body_a = ground.id;
            def.body_b = body.id;
            def.local_target_m = physics::inverse_transform_point(ground.transform, target);
            def.local_anchor_b_m = physics::inverse_transform_point(body.transform, target);
            if (const auto held = world.world.body(body.id)) def.max_force_n = kGripForce_n_kg * held->mass();
            return def;
        }
        case JointKind::Gear: {
            physics::GearJointDef def;
            def.joint_1 = read_geared(L, reader, kJoint1);
            def.joint_2 = read_geared(L, reader, kJoint2);
            return def;
        }
        case JointKind::Pulley: {
            physics::PulleyJointDef def;
            Places(L, reader).set_two_anchors(def);
            return def;
        }
        case JointKind::Friction: {
            physics::FrictionJointDef def;
            Places(L, reader).set_anchor(def);
            return def;
        }
        case JointKind::Filter: {
            physics::FilterJointDef def;
            Places(L, reader).set_bodies(def);
            return def;
        }
    }
    return {};
}

double read_value(const FieldReader& reader, const Field& field) {
    if (field.type == FieldType::Boolean) return reader.boolean(field) ? 1 : 0;
    return reader.number(field);
}

void require_whole_limit(lua_State* L, const FieldReader& reader, const JointKindFields& kind) {
    const Field* lower = nullptr;
    for (const JointParameter& parameter : kind.made) {
        const std::string_view name = parameter.field->name;
        if (name == "lower") lower = parameter.field;
        if (name == "upper") require_both(L, reader, *lower, *parameter.field);
    }
}

}  // namespace

void push_made_joint(lua_State* L, WorldRef world, int table, JointKind kind) {
    const JointKindFields& fields = fields_of(kind);
    const FieldReader reader(L, table, fields.making);
    physics::JointDef def = placed_joint(L, world, reader, kind);
    require_whole_limit(L, reader, fields);
    for (const JointParameter& parameter : fields.made) {
        const bool is_required = parameter.field->default_text == nullptr;
        if (is_required || reader.has(*parameter.field)) {
            parameter.set(def, read_value(reader, *parameter.field));
        }
    }
    const int world_index = lua_absindex(L, world.index);
    push_joint(L, world_index, world.object, value_or_raise(L, world.world.create_joint(def)));
    if (reader.push(kData)) set_data(L);
}

void change_joint(lua_State* L, JointRef joint, int table) {
    const JointKindFields& fields = fields_of(joint.joint.kind());
    const FieldReader reader(L, table, fields.changing);
    physics::JointDef def = joint.joint.definition();
    for (const JointParameter& parameter : fields.all) {
        if (reader.has(*parameter.field)) parameter.set(def, read_value(reader, *parameter.field));
    }
    check_or_raise(L, joint.joint.redefine(def));
}

void push_parameter(lua_State* L, const physics::JointDef& def, const JointParameter& parameter) {
    const double value = parameter.get(def);
    if (parameter.field->type == FieldType::Boolean) {
        lua_pushboolean(L, value != 0);
    } else {
        lua_pushnumber(L, value);
    }
}

}  // namespace cairn::scripting
