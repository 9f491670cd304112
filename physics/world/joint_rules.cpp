// Rules and words for bad definitions of joints.
#include "world/joint_rules.h"

#include <cmath>
#include <string>

#include <cairn/physics/tuning.h>

#include "world/validation.h"

namespace cairn::physics {
namespace {

using check::Fault;

double d(float x) {
    return static_cast<double>(x);
}

// The fields of one definition, by name: "revolute_joint.lower_rad".
class Fields {
  public:
    explicit Fields(JointKind kind) : kind_(name_of(kind)) {}

    Fields& finite(const char* field, float x) { return keep(check::finite(field, d(x))); }
    Fields& finite(const char* field, Vec2 x) { return keep(check::finite(field, x)); }
    Fields& placed(const char* field, Position x) { return keep(check::placed(field, x)); }
    Fields& positive(const char* field, float x) { return keep(check::positive(field, d(x))); }
    Fields& not_negative(const char* field, float x) { return keep(check::not_negative(field, d(x))); }
    Fields& require(bool holds, const char* field, float x, const char* rule) {
        return keep(check::require(holds, field, d(x), rule));
    }
    /// A cap: it may be infinite.
    Fields& cap(const char* field, float x) { return require(x >= 0, field, x, "at least 0"); }
    Fields& strength(const JointStrength& s) {
        return require(s.break_force_n > 0, "strength.break_force_n", s.break_force_n, "greater than 0")
            .require(s.break_torque_nm > 0, "strength.break_torque_nm", s.break_torque_nm, "greater than 0");
    }
    Fields& stiffness(const JointStiffness& s) {
        return positive("stiffness.frequency_hz", s.frequency_hz)
            .not_negative("stiffness.damping_ratio", s.damping_ratio);
    }
    Fields& range(const char* low_field, float low, const char* high_field, float high, const char* rule) {
        return finite(low_field, low).finite(high_field, high).require(low <= high, low_field, low, rule);
    }
    [[nodiscard]] Fault fault() const { return fault_; }

  private:
    // Names are put together for errors only: joints are made by the thousand.
    Fields& keep(Fault fault) {
        if (fault && !fault_) fault_ = Error{std::string(kind_) + "." + fault->message};
        return *this;
    }

    const char* kind_;
    Fault fault_;
};

Fault rules(const DistanceJointDef& def) {
    return Fields(JointKind::Distance)
        .finite("local_anchor_a_m", def.local_anchor_a_m)
        .finite("local_anchor_b_m", def.local_anchor_b_m)
        .require(std::isfinite(def.length_m) && def.length_m > tuning::kLinearSlop_m, "length_m",
                 def.length_m, "finite and greater than 0.005 m")
        .not_negative("frequency_hz", def.frequency_hz)
        .not_negative("damping_ratio", def.damping_ratio)
        .require(def.min_spring_force_n <= 0, "min_spring_force_n", def.min_spring_force_n, "at most 0")
        .cap("max_spring_force_n", def.max_spring_force_n)
        .not_negative("min_length_m", def.min_length_m)
        .require(def.min_length_m <= def.length_m, "min_length_m", def.min_length_m, "at most length_m")
        .require(def.max_length_m >= def.length_m, "max_length_m", def.max_length_m, "at least length_m")
        .stiffness(def.stiffness)
        .strength(def.strength)
        .fault();
}

Fault rules(const RevoluteJointDef& def) {
    return Fields(JointKind::Revolute)
        .finite("local_anchor_a_m", def.local_anchor_a_m)
        .finite("local_anchor_b_m", def.local_anchor_b_m)
        .finite("local_angle_a_rad", def.local_angle_a_rad)
        .finite("local_angle_b_rad", def.local_angle_b_rad)
        .range("lower_rad", def.lower_rad, "upper_rad", def.upper_rad, "at most upper_rad")
        .finite("motor_speed_rad_s", def.motor_speed_rad_s)
        .cap("max_motor_torque_nm", def.max_motor_torque_nm)
        .positive("frequency_hz", def.frequency_hz)
        .not_negative("damping_ratio", def.damping_ratio)
        .finite("target_rad", def.target_rad)
        .stiffness(def.stiffness)
        .strength(def.strength)
        .fault();
}

Fault rules(const PrismaticJointDef& def) {
    return Fields(JointKind::Prismatic)
        .finite("local_anchor_a_m", def.local_anchor_a_m)
        .finite("local_anchor_b_m", def.local_anchor_b_m)
        .finite("local_angle_a_rad", def.local_angle_a_rad)
        .finite("local_angle_b_rad", def.local_angle_b_rad)
        .range("lower_m", def.lower_m, "upper_m", def.upper_m, "at most upper_m")
        .finite("motor_speed_m_s", def.motor_speed_m_s)
        .cap("max_motor_force_n", def.max_motor_force_n)
        .positive("frequency_hz", def.frequency_hz)
        .not_negative("damping_ratio", def.damping_ratio)
        .finite("target_m", def.target_m)
        .stiffness(def.stiffness)
        .strength(def.strength)
        .fault();
}

Fault rules(const WeldJointDef& def) {
    return Fields(JointKind::Weld)
        .finite("local_anchor_a_m", def.local_anchor_a_m)
        .finite("local_anchor_b_m", def.local_anchor_b_m)
        .finite("local_angle_a_rad", def.local_angle_a_rad)
        .finite("local_angle_b_rad", def.local_angle_b_rad)
        .not_negative("linear_frequency_hz", def.linear_frequency_hz)
        .not_negative("linear_damping_ratio", def.linear_damping_ratio)
        .not_negative("angular_frequency_hz", def.angular_frequency_hz)
        .not_negative("angular_damping_ratio", def.angular_damping_ratio)
        .stiffness(def.stiffness)
        .strength(def.strength)
        .fault();
}

Fault rules(const WheelJointDef& def) {
    return Fields(JointKind::Wheel)
        .finite("local_anchor_a_m", def.local_anchor_a_m)
        .finite("local_anchor_b_m", def.local_anchor_b_m)
        .finite("local_angle_a_rad", def.local_angle_a_rad)
        .positive("frequency_hz", def.frequency_hz)
        .not_negative("damping_ratio", def.damping_ratio)
        .finite("target_m", def.target_m)
        .range("lower_m", def.lower_m, "upper_m", def.upper_m, "at most upper_m")
        .finite("motor_speed_rad_s", def.motor_speed_rad_s)
        .cap("max_motor_torque_nm", def.max_motor_torque_nm)
        .stiffness(def.stiffness)
        .strength(def.strength)
        .fault();
}

Fault rules(const MotorJointDef& def) {
    return Fields(JointKind::Motor)
        .finite("local_anchor_a_m", def.local_anchor_a_m)
        .finite("local_anchor_b_m", def.local_anchor_b_m)
        .finite("local_angle_a_rad", def.local_angle_a_rad)
        .finite("local_angle_b_rad", def.local_angle_b_rad)
        .finite("target_offset_m", def.target_offset_m)
        .finite("target_angle_rad", def.target_angle_rad)
        .finite("linear_velocity_m_s", def.linear_velocity_m_s)
        .finite("angular_velocity_rad_s", def.angular_velocity_rad_s)
        .not_negative("linear_frequency_hz", def.linear_frequency_hz)
        .not_negative("linear_damping_ratio", def.linear_damping_ratio)
        .not_negative("angular_frequency_hz", def.angular_frequency_hz)
        .not_negative("angular_damping_ratio", def.angular_damping_ratio)
        .cap("max_force_n", def.max_force_n)
        .cap("max_torque_nm", def.max_torque_nm)
        .strength(def.strength)
        .fault();
}

Fault rules(const MouseJointDef& def) {
    return Fields(JointKind::Mouse)
        .finite("local_target_m", def.local_target_m)
        .finite("local_anchor_b_m", def.local_anchor_b_m)
        .positive("frequency_hz", def.frequency_hz)
        .not_negative("damping_ratio", def.damping_ratio)
        .cap("max_force_n", def.max_force_n)
        .strength(def.strength)
        .fault();
}

Fault rules(const GearJointDef& def) {
    return Fields(JointKind::Gear)
        .require(std::isfinite(def.ratio) && def.ratio != 0, "ratio", def.ratio, "finite and not 0")
        .stiffness(def.stiffness)
        .strength(def.strength)
        .fault();
}

Fault rules(const PulleyJointDef& def) {
    return Fields(JointKind::Pulley)
        .finite("local_anchor_a_m", def.local_anchor_a_m)
        .finite("local_anchor_b_m", def.local_anchor_b_m)
        .placed("wheel_a_m", def.wheel_a_m)
        .placed("wheel_b_m", def.wheel_b_m)
        .positive("ratio", def.ratio)
        .not_negative("length_m", def.length_m)
        .stiffness(def.stiffness)
        .strength(def.strength)
        .fault();
}

Fault rules(const FrictionJointDef& def) {
    return Fields(JointKind::Friction)
        .finite("local_anchor_a_m", def.local_anchor_a_m)
        .finite("local_anchor_b_m", def.local_anchor_b_m)
        .not_negative("max_force_n", def.max_force_n)
        .not_negative("max_torque_nm", def.max_torque_nm)
        .fault();
}

Fault rules(const FilterJointDef&) {
    return {};
}

Fault check_two_bodies(const std::string& name, int a, int b, const Stores& stores) {
    if (a == b) return Error{name + ".body_a and .body_b are the same body, but must be two bodies"};
    const auto type = [&](int body) { return stores.bodies.slots[body].type; };
    if (type(a) != BodyType::Dynamic && type(b) != BodyType::Dynamic) {
        return Error{name + ".body_a and .body_b are both immovable, but one must be dynamic"};
    }
    return {};
}

template <class Def>
Fault check_bodies(const std::string& name, const Def& def, const Stores& stores) {
    const std::uint64_t tag = stores.bodies.slots.world_tag();
    for (const auto& [field, id] : {std::pair{".body_a", def.body_a}, std::pair{".body_b", def.body_b}}) {
        if (stores.bodies.slots.find(id) == kNone) {
            return Error{name + field + ": " + bad_handle("body", id.index1, id.world, tag).message};
        }
    }
    return check_two_bodies(name, stores.bodies.slots.find(def.body_a), stores.bodies.slots.find(def.body_b),
                            stores);
}

// The body of a joint that a gear acts on for islands and filters.
int geared_body(const Stores& stores, JointId id) {
    const JointRecord& joint = stores.joints.slots[stores.joints.slots.find(id)];
    const bool b_moves = stores.bodies.slots[joint.body_b].type == BodyType::Dynamic;
    return b_moves ? joint.body_b : joint.body_a;
}

Fault check_bodies(const std::string& name, const GearJointDef& def, const Stores& stores) {
    const std::uint64_t tag = stores.joints.slots.world_tag();
    for (const auto& [field, id] : {std::pair{".joint_1", def.joint_1}, std::pair{".joint_2", def.joint_2}}) {
        const int joint = stores.joints.slots.find(id);
        if (joint == kNone)
            return Error{name + field + ": " + bad_handle("joint", id.index1, id.world, tag).message};
        const JointKind kind = kind_of(stores.joints.slots[joint]);
        if (kind != JointKind::Revolute && kind != JointKind::Prismatic) {
            return Error{name + field + " is a " + name_of(kind) + ", but must be revolute or prismatic"};
        }
    }
    if (geared_body(stores, def.joint_1) == geared_body(stores, def.joint_2)) {
        return Error{name + ".joint_1 and .joint_2 move the same body, but must move two bodies"};
    }
    return {};
}

}  // namespace

check::Fault validate(const JointDef& def, const Stores& stores) {
    const std::string name = name_of(static_cast<JointKind>(def.index()));
    return std::visit(
        [&](const auto& d) -> Fault {
            if (auto fault = check_bodies(name, d, stores)) return fault;
            return rules(d);
        },
        def);
}

const char* name_of(JointKind kind) {
    switch (kind) {
        case JointKind::Distance:
            return "distance_joint";
        case JointKind::Revolute:
            return "revolute_joint";
        case JointKind::Prismatic:
            return "prismatic_joint";
        case JointKind::Weld:
            return "weld_joint";
        case JointKind::Wheel:
            return "wheel_joint";
        case JointKind::Motor:
            return "motor_joint";
        case JointKind::Mouse:
            return "mouse_joint";
        case JointKind::Gear:
            return "gear_joint";
        case JointKind::Pulley:
            return "pulley_joint";
        case JointKind::Friction:
            return "friction_joint";
        case JointKind::Filter:
            return "filter_joint";
    }
    return "joint";
}

JointBodies bodies_of(const JointDef& def, const Stores& stores) {
    return std::visit(
        [&](const auto& d) -> JointBodies {
            if constexpr (std::is_same_v<std::decay_t<decltype(d)>, GearJointDef>) {
                return {geared_body(stores, d.joint_1), geared_body(stores, d.joint_2)};
            } else {
                return {stores.bodies.slots.find(d.body_a), stores.bodies.slots.find(d.body_b)};
            }
        },
        def);
}

JointStrength strength_of(const JointDef& def) {
    return std::visit(
        [](const auto& d) -> JointStrength {
            if constexpr (requires { d.strength; }) {
                return d.strength;
            } else {
                return {};
            }
        },
        def);
}

}  // namespace cairn::physics
