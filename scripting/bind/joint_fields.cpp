// One constant per field; for each kind of joint, which member of its definition each field is.
#include "bind/joint_fields.h"

#include <array>
#include <limits>

#include <cairn/physics/tuning.h>

#include "bind/member_path.h"

namespace cairn::scripting {
namespace {

using namespace joint_places;
using physics::JointDef;
using physics::Position;
using physics::Vec2;

constexpr auto kPointsApart_m = static_cast<double>(physics::tuning::kLinearSlop_m);
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// ---- Parameters
constexpr Field kCollide = boolean_field("collide_connected", false, "whether the two bodies collide");
constexpr Field kCollideToo = boolean_field("collide_connected", true, "whether the two bodies collide");
constexpr Field kStiffness =
    above(number_field("stiffness_frequency", 60, "60", "Hz; softer where what is held shall give"), 0);
constexpr Field kStiffnessDamping =
    at_least(number_field("stiffness_damping_ratio", 2, "2", "1 is critical"), 0);
constexpr Field kBreakForce = above(number_field("break_force", kInfinity, "math.huge",
                                                 "N, the mean over a step; beyond it the joint breaks"),
                                    0, kInfinity);
constexpr Field kBreakTorque =
    above(number_field("break_torque", kInfinity, "math.huge", "N m, likewise"), 0, kInfinity);

constexpr Field kLowerAngle =
    optional_field("lower", FieldType::Number, "rad; with upper: turns the limit on");
constexpr Field kUpperAngle = optional_field("upper", FieldType::Number, "rad; any number of turns");
constexpr Field kLowerWay =
    optional_field("lower", FieldType::Number, "m along the axis; with upper: turns the limit on");
constexpr Field kUpperWay = optional_field("upper", FieldType::Number, "m");
constexpr Field kEnableLimit =
    optional_field("enable_limit", FieldType::Boolean, "absent: on when lower and upper are given");
constexpr Field kMotorTurn =
    optional_field("motor_speed", FieldType::Number, "rad/s, of b against a; turns the motor on");
constexpr Field kMotorWay =
    optional_field("motor_speed", FieldType::Number, "m/s, of b against a; turns the motor on");
constexpr Field kMaxMotorTorque = within(number_field("max_motor_torque", 0, "0", "N m"), 0, kInfinity);
constexpr Field kMaxMotorForce = within(number_field("max_motor_force", 0, "0", "N"), 0, kInfinity);
constexpr Field kEnableMotor =
    optional_field("enable_motor", FieldType::Boolean, "absent: on when motor_speed is given");

constexpr Field kFrequency =
    above(optional_field("frequency", FieldType::Number, "Hz; turns the spring on"), 0);
constexpr Field kFreeFrequency =
    at_least(optional_field(
                 "frequency", FieldType::Number,
                 "Hz, as the bodies stand when it is set; turns the spring on; with 0 nothing but its limits "
                 "acts, as in a rope"),
             0);
constexpr Field kSuspension = above(number_field("frequency", 2, "2", "Hz"), 0);
constexpr Field kGrip = above(number_field("frequency", 5, "5", "Hz"), 0);
constexpr Field kDamping = at_least(number_field("damping_ratio", 0, "0", "1 is critical"), 0);
constexpr Field kSuspensionDamping = at_least(number_field("damping_ratio", 0.7, "0.7", "1 is critical"), 0);
constexpr Field kGripDamping = at_least(number_field("damping_ratio", 1, "1", "1 is critical"), 0);
constexpr Field kEnableSpring =
    optional_field("enable_spring", FieldType::Boolean, "absent: on when frequency is given");
constexpr Field kEnableSuspension = boolean_field("enable_spring", true, "");
constexpr Field kTargetTurn = number_field("target", 0, "0", "rad; where the spring draws to");
constexpr Field kTargetWay = number_field("target", 0, "0", "m; where the spring draws to");

constexpr Field kRestLength =
    above(optional_field("length", FieldType::Number, "m; absent: the present distance"), kPointsApart_m);
constexpr Field kMinLength = at_least(number_field("min_length", 0, "0", "m, of the spring"), 0);
constexpr Field kMaxLength =
    within(number_field("max_length", kInfinity, "math.huge", "m, of the spring"), 0, kInfinity);
constexpr Field kMinSpringForce =
    within(number_field("min_spring_force", -kInfinity, "-math.huge", "N; the spring pushes with no more"),
           -kInfinity, 0);
constexpr Field kMaxSpringForce = within(
    number_field("max_spring_force", kInfinity, "math.huge", "N; and pulls with no more"), 0, kInfinity);

constexpr Field kWeldLinear =
    at_least(number_field("linear_frequency", 0, "0", "Hz, of a spring that holds the place; 0 is rigid"), 0);
constexpr Field kWeldAngular = at_least(
    number_field("angular_frequency", 0, "0", "Hz, of a spring that holds the angle; 0 is rigid"), 0);
constexpr Field kMotorLinear = at_least(
    number_field("linear_frequency", 0, "0", "Hz, of the way to the target; 0: the velocity counts"), 0);
constexpr Field kMotorAngular = at_least(
    number_field("angular_frequency", 0, "0", "Hz, of the turn to the target; 0: the velocity counts"), 0);
constexpr Field kLinearDamping = at_least(number_field("linear_damping_ratio", 1, "1", "1 is critical"), 0);
constexpr Field kAngularDamping = at_least(number_field("angular_damping_ratio", 1, "1", "1 is critical"), 0);
constexpr Field kOffsetX = number_field("target_x", 0, "0", "m; where b's anchor shall be, in frame a");
constexpr Field kOffsetY = number_field("target_y", 0, "0", "m");
constexpr Field kOffsetAngle = number_field("target_angle", 0, "0", "rad; how b shall stand to a");
constexpr Field kDriveX =
    number_field("linear_velocity_x", 0, "0", "m/s, of b's anchor in frame a, without linear_frequency");
constexpr Field kDriveY = number_field("linear_velocity_y", 0, "0", "m/s");
constexpr Field kDriveAngle =
    number_field("angular_velocity", 0, "0", "rad/s, of b against a, without angular_frequency");
constexpr Field kMaxForce = within(number_field("max_force", 0, "0", "N"), 0, kInfinity);
constexpr Field kMaxTorque = within(number_field("max_torque", 0, "0", "N m"), 0, kInfinity);
constexpr Field kMaxGripForce = within(
    optional_field("max_force", FieldType::Number, "N; absent: 1000 for each kg of the body"), 0, kInfinity);

constexpr Field kGearRatio = number_field(
    "ratio", 1, "1", "coordinate 1 + ratio * coordinate 2 stays; not 0; in m or 1/m between kinds");
constexpr Field kPulleyRatio =
    above(number_field("ratio", 1, "1", "of a block and tackle on the side of b"), 0);
constexpr Field kRopeLength = at_least(
    optional_field("length", FieldType::Number, "m, of a's side + ratio * b's; absent: as it is now"), 0);
constexpr Field kWheelXA = required_field("wheel_x_a", FieldType::Number, "m; a's wheel, in the world");
constexpr Field kWheelYA = required_field("wheel_y_a", FieldType::Number, "m");
constexpr Field kWheelXB = required_field("wheel_x_b", FieldType::Number, "m; b's wheel");
constexpr Field kWheelYB = required_field("wheel_y_b", FieldType::Number, "m");

// ---- Frames, which are derived when a joint is made, and can be changed later
constexpr Field kLocalXA = optional_field("local_x_a", FieldType::Number, "m");
constexpr Field kLocalYA = optional_field("local_y_a", FieldType::Number, "m");
constexpr Field kLocalXB = optional_field("local_x_b", FieldType::Number, "m");
constexpr Field kLocalYB = optional_field("local_y_b", FieldType::Number, "m");
constexpr Field kLocalAngleA = optional_field("local_angle_a", FieldType::Number, "rad");
constexpr Field kLocalAngleB = optional_field("local_angle_b", FieldType::Number, "rad");

// ---- Which member is which field

/// The member at the end of the path `First, Rest...`, which begins at a definition.
template <auto First, auto... Rest>
constexpr JointParameter parameter(const Field& field) {
    using Def = decltype(owner_of(First));
    return {
        &field,
        [](const JointDef& def) { return static_cast<double>(member<First, Rest...>(std::get<Def>(def))); },
        [](JointDef& def, double value) {
            auto& place = member<First, Rest...>(std::get<Def>(def));
            place = static_cast<std::remove_reference_t<decltype(place)>>(value);
        }};
}

/// The same; and when it is set, a part of the joint is turned on.
template <auto Switch, auto Member>
constexpr JointParameter switching(const Field& field) {
    JointParameter result = parameter<Member>(field);
    result.set = [](JointDef& def, double value) {
        parameter<Member>(kX).set(def, value);
        parameter<Switch>(kX).set(def, 1);
    };
    return result;
}

template <class Def>
constexpr std::array kStrong = {
    parameter<&Def::strength, &physics::JointStrength::break_force_n>(kBreakForce),
    parameter<&Def::strength, &physics::JointStrength::break_torque_nm>(kBreakTorque),
};
template <class Def>
constexpr std::array kStiff =
    joined(std::array{parameter<&Def::stiffness, &physics::JointStiffness::frequency_hz>(kStiffness),
                      parameter<&Def::stiffness, &physics::JointStiffness::damping_ratio>(kStiffnessDamping)},
           kStrong<Def>);
template <class Def>
constexpr std::array kApart = {parameter<&Def::collide_connected>(kCollide)};
template <class Def>
constexpr std::array kColliding = {parameter<&Def::collide_connected>(kCollideToo)};
template <class Def>
constexpr std::array kAnchors = {parameter<&Def::local_anchor_a_m, &Vec2::x>(kLocalXA),
                                 parameter<&Def::local_anchor_a_m, &Vec2::y>(kLocalYA),
                                 parameter<&Def::local_anchor_b_m, &Vec2::x>(kLocalXB),
                                 parameter<&Def::local_anchor_b_m, &Vec2::y>(kLocalYB)};
template <class Def>
constexpr std::array kAngleA = {parameter<&Def::local_angle_a_rad>(kLocalAngleA)};
template <class Def>
constexpr std::array kFrames = joined(kAnchors<Def>, kAngleA<Def>,
                                      std::array{parameter<&Def::local_angle_b_rad>(kLocalAngleB)});
constexpr std::array<JointParameter, 0> kNoFrames{};

using Distance = physics::DistanceJointDef;
constexpr std::array kDistance = joined(
    std::array{
        parameter<&Distance::length_m>(kRestLength),
        switching<&Distance::enable_spring, &Distance::frequency_hz>(kFreeFrequency),
        parameter<&Distance::damping_ratio>(kDamping),
        parameter<&Distance::min_length_m>(kMinLength),
        parameter<&Distance::max_length_m>(kMaxLength),
        parameter<&Distance::min_spring_force_n>(kMinSpringForce),
        parameter<&Distance::max_spring_force_n>(kMaxSpringForce),
        parameter<&Distance::enable_spring>(kEnableSpring),
    },
    kApart<Distance>, kStiff<Distance>);

using Revolute = physics::RevoluteJointDef;
constexpr std::array kRevolute = joined(
    std::array{
        switching<&Revolute::enable_limit, &Revolute::lower_rad>(kLowerAngle),
        switching<&Revolute::enable_limit, &Revolute::upper_rad>(kUpperAngle),
        parameter<&Revolute::enable_limit>(kEnableLimit),
        switching<&Revolute::enable_motor, &Revolute::motor_speed_rad_s>(kMotorTurn),
        parameter<&Revolute::max_motor_torque_nm>(kMaxMotorTorque),
        parameter<&Revolute::enable_motor>(kEnableMotor),
        switching<&Revolute::enable_spring, &Revolute::frequency_hz>(kFrequency),
        parameter<&Revolute::damping_ratio>(kDamping),
        parameter<&Revolute::target_rad>(kTargetTurn),
        parameter<&Revolute::enable_spring>(kEnableSpring),
    },
    kApart<Revolute>, kStiff<Revolute>);

using Prismatic = physics::PrismaticJointDef;
constexpr std::array kPrismatic = joined(
    std::array{
        switching<&Prismatic::enable_limit, &Prismatic::lower_m>(kLowerWay),
        switching<&Prismatic::enable_limit, &Prismatic::upper_m>(kUpperWay),
        parameter<&Prismatic::enable_limit>(kEnableLimit),
        switching<&Prismatic::enable_motor, &Prismatic::motor_speed_m_s>(kMotorWay),
        parameter<&Prismatic::max_motor_force_n>(kMaxMotorForce),
        parameter<&Prismatic::enable_motor>(kEnableMotor),
        switching<&Prismatic::enable_spring, &Prismatic::frequency_hz>(kFrequency),
        parameter<&Prismatic::damping_ratio>(kDamping),
        parameter<&Prismatic::target_m>(kTargetWay),
        parameter<&Prismatic::enable_spring>(kEnableSpring),
    },
    kApart<Prismatic>, kStiff<Prismatic>);

using Weld = physics::WeldJointDef;
constexpr std::array kWeld = joined(
    std::array{
        parameter<&Weld::linear_frequency_hz>(kWeldLinear),
        parameter<&Weld::linear_damping_ratio>(kLinearDamping),
        parameter<&Weld::angular_frequency_hz>(kWeldAngular),
        parameter<&Weld::angular_damping_ratio>(kAngularDamping),
    },
    kApart<Weld>, kStiff<Weld>);

using Wheel = physics::WheelJointDef;
constexpr std::array kWheel = joined(
    std::array{
        parameter<&Wheel::frequency_hz>(kSuspension),
        parameter<&Wheel::damping_ratio>(kSuspensionDamping),
        parameter<&Wheel::target_m>(kTargetWay),
        parameter<&Wheel::enable_spring>(kEnableSuspension),
        switching<&Wheel::enable_limit, &Wheel::lower_m>(kLowerWay),
        switching<&Wheel::enable_limit, &Wheel::upper_m>(kUpperWay),
        parameter<&Wheel::enable_limit>(kEnableLimit),
        switching<&Wheel::enable_motor, &Wheel::motor_speed_rad_s>(kMotorTurn),
        parameter<&Wheel::max_motor_torque_nm>(kMaxMotorTorque),
        parameter<&Wheel::enable_motor>(kEnableMotor),
    },
    kApart<Wheel>, kStiff<Wheel>);

using Motor = physics::MotorJointDef;
constexpr std::array kMotor = joined(
    std::array{
        parameter<&Motor::target_offset_m, &Vec2::x>(kOffsetX),
        parameter<&Motor::target_offset_m, &Vec2::y>(kOffsetY),
        parameter<&Motor::target_angle_rad>(kOffsetAngle),
        parameter<&Motor::linear_velocity_m_s, &Vec2::x>(kDriveX),
        parameter<&Motor::linear_velocity_m_s, &Vec2::y>(kDriveY),
        parameter<&Motor::angular_velocity_rad_s>(kDriveAngle),
        parameter<&Motor::linear_frequency_hz>(kMotorLinear),
        parameter<&Motor::linear_damping_ratio>(kLinearDamping),
        parameter<&Motor::angular_frequency_hz>(kMotorAngular),
        parameter<&Motor::angular_damping_ratio>(kAngularDamping),
        parameter<&Motor::max_force_n>(kMaxForce),
        parameter<&Motor::max_torque_nm>(kMaxTorque),
    },
    kColliding<Motor>, kStrong<Motor>);

using Mouse = physics::MouseJointDef;
constexpr std::array kMouse = joined(
    std::array{
        parameter<&Mouse::frequency_hz>(kGrip),
        parameter<&Mouse::damping_ratio>(kGripDamping),
        parameter<&Mouse::max_force_n>(kMaxGripForce),
    },
    kColliding<Mouse>, kStrong<Mouse>);
constexpr std::array kMouseFrames = {parameter<&Mouse::local_anchor_b_m, &Vec2::x>(kLocalXB),
                                     parameter<&Mouse::local_anchor_b_m, &Vec2::y>(kLocalYB)};

using Gear = physics::GearJointDef;
constexpr std::array kGear =
    joined(std::array{parameter<&Gear::ratio>(kGearRatio)}, kColliding<Gear>, kStiff<Gear>);

using Pulley = physics::PulleyJointDef;
constexpr std::array kPulley = joined(
    std::array{
        parameter<&Pulley::wheel_a_m, &Position::x>(kWheelXA),
        parameter<&Pulley::wheel_a_m, &Position::y>(kWheelYA),
        parameter<&Pulley::wheel_b_m, &Position::x>(kWheelXB),
        parameter<&Pulley::wheel_b_m, &Position::y>(kWheelYB),
        parameter<&Pulley::ratio>(kPulleyRatio),
        parameter<&Pulley::length_m>(kRopeLength),
    },
    kColliding<Pulley>, kStiff<Pulley>);

using Friction = physics::FrictionJointDef;
constexpr std::array kFriction = joined(
    std::array{parameter<&Friction::max_force_n>(kMaxForce), parameter<&Friction::max_torque_nm>(kMaxTorque)},
    kColliding<Friction>);

constexpr std::array<JointParameter, 0> kFilter{};

constexpr std::array kWheelFrames = joined(kAnchors<Wheel>, kAngleA<Wheel>);

// ---- The kinds

/// A kind's parameters, then its frames.
template <const auto& kOwn, const auto& kFrame>
constexpr auto kAll = joined(kOwn, kFrame);

template <const auto& kParameters>
constexpr auto kFieldsOf = [] {
    std::array<const Field*, kParameters.size()> fields{};
    for (std::size_t i = 0; i < fields.size(); ++i) fields[i] = kParameters[i].field;
    return fields;
}();

constexpr const Field* kTwoBodies[] = {&kBodyA, &kBodyB};
constexpr const Field* kAtPoint[] = {&kBodyA, &kBodyB, &kX, &kY};
constexpr const Field* kAlongAxis[] = {&kBodyA, &kBodyB, &kX, &kY, &kAxisAngle, &kAxisX, &kAxisY};
constexpr const Field* kAtTwoPoints[] = {&kBodyA, &kBodyB, &kAnchorXA, &kAnchorYA, &kAnchorXB, &kAnchorYB};
constexpr const Field* kInHand[] = {&kHeldBody, &kTargetX, &kY};
constexpr const Field* kTwoJoints[] = {&kJoint1, &kJoint2};

/// What is given when a joint of a kind is made.
template <const auto& kPlaces, const auto& kOwn>
constexpr auto kMaking = joined(std::to_array(kPlaces), kFieldsOf<kOwn>, std::array{&kData});

template <const auto& kPlaces, const auto& kOwn, const auto& kFrame>
constexpr JointKindFields kind_of_joint(const char* name) {
    return {name, {kMaking<kPlaces, kOwn>}, {kFieldsOf<kAll<kOwn, kFrame>>}, kOwn, kAll<kOwn, kFrame>};
}

}  // namespace

// In the order of JointKind.
const JointKindFields kJointKinds[11] = {
    kind_of_joint<kAtTwoPoints, kDistance, kAnchors<Distance>>("distance"),
    kind_of_joint<kAtPoint, kRevolute, kFrames<Revolute>>("revolute"),
    kind_of_joint<kAlongAxis, kPrismatic, kFrames<Prismatic>>("prismatic"),
    kind_of_joint<kAtPoint, kWeld, kFrames<Weld>>("weld"),
    kind_of_joint<kAlongAxis, kWheel, kWheelFrames>("wheel"),
    kind_of_joint<kAtPoint, kMotor, kFrames<Motor>>("motor"),
    kind_of_joint<kInHand, kMouse, kMouseFrames>("mouse"),
    kind_of_joint<kTwoJoints, kGear, kNoFrames>("gear"),
    kind_of_joint<kAtTwoPoints, kPulley, kAnchors<Pulley>>("pulley"),
    kind_of_joint<kAtPoint, kFriction, kAnchors<Friction>>("friction"),
    kind_of_joint<kTwoBodies, kFilter, kNoFrames>("filter"),
};

}  // namespace cairn::scripting
