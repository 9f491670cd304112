// One constant per field; for each prefab, which member of its definition each field is.
#include "bind/prefab_fields.h"

#include <array>
#include <limits>

#include "bind/function.h"
#include "bind/physics_fields.h"
#include "bind/physics_objects.h"
#include "bind/prefab_parameter.h"

namespace cairn::scripting {
namespace {

using namespace physics;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// ---- Shared by several
constexpr Field kX = number_field("x", 0, "0", "m");
constexpr Field kY = number_field("y", 0, "0", "m");
constexpr Field kDensity = at_least(number_field("density", 1, "1", "kg/m^2"), 0);
constexpr Field kFriction = at_least(number_field("friction", 0.6, "0.6", "Coulomb coefficient"), 0);
constexpr Field kRestitution =
    within(number_field("restitution", 0, "0", "share of the approach speed given back"), 0, 1);
constexpr Field kDamping = at_least(number_field("damping", 0, "0", "1/s, of the air"), 0);
constexpr Field kPinFriction = at_least(number_field("friction_torque", 0, "0", "N m, of each pin"), 0);
constexpr Field kHoldStart = boolean_field("hold_start", true, "whether the start is held");
constexpr Field kHoldEnd = boolean_field("hold_end", true, "whether the end is held");
constexpr Field kStartBody = optional_field("start_body", FieldType::Body, "by what; absent: the world");
constexpr Field kEndBody = optional_field("end_body", FieldType::Body, "by what; absent: the world");
constexpr Field kBreakForce =
    within(number_field("break_force", kInfinity, "math.huge", "N, of each joint"), 0, kInfinity);
constexpr Field kBreakTorque =
    within(number_field("break_torque", kInfinity, "math.huge", "N m, of each joint"), 0, kInfinity);
constexpr Field kData = optional_field("data", FieldType::Table, "becomes body.data of every body");
constexpr const Field* kCommon[] = {&kData};
constexpr FieldSet kCommonFields{kCommon, {&kFilterFields}};
/// The same of those whose shapes, or whose main one, are of one material.
constexpr FieldSet kOneMatterFields{kCommon, {&kFilterFields, &kOtherMatterFields}};

void read_end(lua_State* L, const FieldReader& reader, const Field& held, const Field& body, PrefabEnd& end) {
    if (reader.has(held)) end.held = reader.boolean(held);
    if (!reader.push(body)) return;
    const auto living = living_body_at(L, -1);
    if (!living) reader.fail(body, "it was destroyed");
    end.body = living->id();
    end.held = true;
    lua_pop(L, 1);
}

/// Calls `read(path)` with each entry of a list on top of the stack. `what` is one of them, of a list that
/// must hold some; else null.
void read_list(lua_State* L, const FieldReader& reader, const Field& field, int type, const char* what,
               const auto& read) {
    reader.push(field);
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
    if (count == 0 && what != nullptr)
        call_error(L, std::string(field.name) + " = {}: must hold at least one " + what);
    for (lua_Integer i = 1; i <= count; ++i) {
        const std::string path = std::string(field.name) + "[" + std::to_string(i) + "]";
        if (lua_rawgeti(L, -1, i) != type)
            call_error(L, path + " = " + describe_value(L, -1) + ": must be a " + lua_typename(L, type));
        read(path);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
}

/// { 1, 2, ... }, each of them in a range.
std::vector<float> read_numbers(lua_State* L, const FieldReader& reader, const Field& field, const char* what,
                                const Field& each) {
    std::vector<float> numbers;
    read_list(L, reader, field, LUA_TNUMBER, what, [&](const std::string& path) {
        const double number = lua_tonumber(L, -1);
        if (!is_in_range(each, number))
            call_error(L, path + " = " + describe_value(L, -1) + ": " + range_rule(each));
        numbers.push_back(static_cast<float>(number));
    });
    return numbers;
}

template <auto Shape>
constexpr std::array kMatter = {
    parameter<Shape, &ShapeDef::density_kg_m2>(kDensity),
    parameter<Shape, &ShapeDef::material, &Material::friction>(kFriction),
    parameter<Shape, &ShapeDef::material, &Material::restitution>(kRestitution),
};

/// Of the shapes of prefabs that have one description for all.
template <class Def>
Def read_common(const FieldReader& reader, const auto& parameters) {
    Def def;
    read_other_matter(reader, def.shape);  // first, for the fields beside a material go before it
    read_parameters(reader, parameters, def);
    read_filter(reader, def.shape);
    return def;
}

// ---- Chain
constexpr Field kDirectionX = number_field("direction_x", 0, "0", "of any length");
constexpr Field kDirectionY = number_field("direction_y", -1, "-1", "");
constexpr Field kLinks = within(integer_field("links", 10, "10", ""), 1, 10000);
constexpr Field kLinkLength = above(number_field("link_length", 0.5, "0.5", "m, from pin to pin"), 0.01);
constexpr Field kLinkThickness = above(number_field("thickness", 0.15, "0.15", "m"), 0);
constexpr Field kHoldChainEnd = boolean_field("hold_end", false, "whether the end is held");
constexpr std::array kChain = joined(
    std::array{
        parameter<&LinkChainDef::start_m, &Position::x>(kX),
        parameter<&LinkChainDef::start_m, &Position::y>(kY),
        parameter<&LinkChainDef::direction, &Vec2::x>(kDirectionX),
        parameter<&LinkChainDef::direction, &Vec2::y>(kDirectionY),
        parameter<&LinkChainDef::links>(kLinks),
        parameter<&LinkChainDef::link_length_m>(kLinkLength),
        parameter<&LinkChainDef::thickness_m>(kLinkThickness),
        parameter<&LinkChainDef::friction_torque_nm>(kPinFriction),
        parameter<&LinkChainDef::damping_1_s>(kDamping),
    },
    kMatter<&LinkChainDef::shape>);
constexpr auto kChainFields =
    fields_with<kChain>(std::array<const Field*, 4>{&kHoldStart, &kStartBody, &kHoldChainEnd, &kEndBody});

// ---- Rope
constexpr Field kRopeLength =
    at_least(number_field("length", 0, "0", "m, at least the distance of the ends; 0: just that"), 0);
constexpr Field kRopeLinks = within(integer_field("links", 20, "20", ""), 2, 10000);
constexpr Field kRopeRadius = above(number_field("radius", 0.04, "0.04", "m"), 0);
constexpr Field kRopeDamping = at_least(number_field("damping", 1, "1", "1/s, of the air"), 0);
constexpr Field kRopeEndX = number_field("to_x", 5, "5", "m");
constexpr Field kEndY = number_field("to_y", 0, "0", "m");
constexpr std::array kRope = joined(
    std::array{
        parameter<&RopeDef::from_m, &Position::x>(kX),
        parameter<&RopeDef::from_m, &Position::y>(kY),
        parameter<&RopeDef::to_m, &Position::x>(kRopeEndX),
        parameter<&RopeDef::to_m, &Position::y>(kEndY),
        parameter<&RopeDef::length_m>(kRopeLength),
        parameter<&RopeDef::links>(kRopeLinks),
        parameter<&RopeDef::radius_m>(kRopeRadius),
        parameter<&RopeDef::friction_torque_nm>(kPinFriction),
        parameter<&RopeDef::damping_1_s>(kRopeDamping),
    },
    kMatter<&RopeDef::shape>);
constexpr auto kRopeFields =
    fields_with<kRope>(std::array<const Field*, 4>{&kHoldStart, &kStartBody, &kHoldEnd, &kEndBody});

// ---- Bridge
constexpr Field kBridgeEndX = number_field("to_x", 10, "10", "m");
constexpr Field kPlanks = within(integer_field("planks", 20, "20", ""), 2, 10000);
constexpr Field kSlack =
    within(number_field("slack", 0.01, "0.01", "how much longer than the straight way, a share"), 0, 1);
constexpr Field kPlankThickness = above(number_field("thickness", 0.2, "0.2", "m"), 0);
constexpr Field kPlankFriction = at_least(number_field("friction_torque", 0.5, "0.5", "N m, of each pin"), 0);
constexpr Field kPlankDensity = at_least(number_field("density", 4, "4", "kg/m^2"), 0);
constexpr std::array kBridge = {
    parameter<&BridgeDef::from_m, &Position::x>(kX),
    parameter<&BridgeDef::from_m, &Position::y>(kY),
    parameter<&BridgeDef::to_m, &Position::x>(kBridgeEndX),
    parameter<&BridgeDef::to_m, &Position::y>(kEndY),
    parameter<&BridgeDef::planks>(kPlanks),
    parameter<&BridgeDef::slack>(kSlack),
    parameter<&BridgeDef::thickness_m>(kPlankThickness),
    parameter<&BridgeDef::friction_torque_nm>(kPlankFriction),
    parameter<&BridgeDef::damping_1_s>(kRopeDamping),
    parameter<&BridgeDef::strength, &JointStrength::break_force_n>(kBreakForce),
    parameter<&BridgeDef::strength, &JointStrength::break_torque_nm>(kBreakTorque),
    parameter<&BridgeDef::shape, &ShapeDef::density_kg_m2>(kPlankDensity),
    parameter<&BridgeDef::shape, &ShapeDef::material, &Material::friction>(kFriction),
    parameter<&BridgeDef::shape, &ShapeDef::material, &Material::restitution>(kRestitution),
};
constexpr auto kBridgeFields =
    fields_with<kBridge>(std::array<const Field*, 4>{&kHoldStart, &kStartBody, &kHoldEnd, &kEndBody});

// ---- Vehicle
constexpr Field kVehicleLength = above(number_field("length", 3, "3", "m, of the chassis"), 0);
constexpr Field kVehicleHeight = above(number_field("height", 0.6, "0.6", "m, of the chassis"), 0);
constexpr Field kSuspension = above(number_field("suspension_frequency", 3, "3", "Hz"), 0);
constexpr Field kSuspensionDamping =
    at_least(number_field("suspension_damping", 0.8, "0.8", "ratio; 1 is critical"), 0);
constexpr Field kSuspensionTravel = above(number_field("suspension_travel", 0.3, "0.3", "m, up and down"), 0);
constexpr Field kDriveTorque =
    at_least(number_field("drive_torque", 30, "30", "N m, of each driven wheel"), 0);
constexpr Field kBrakeTorque =
    at_least(number_field("brake_torque", 60, "60", "N m, of each braked wheel"), 0);
constexpr Field kChassisDensity = at_least(number_field("density", 2, "2", "kg/m^2, of the chassis"), 0);
constexpr Field kChassisFriction =
    at_least(number_field("friction", 0.6, "0.6", "Coulomb coefficient, of the chassis"), 0);
constexpr Field kTyreFriction = at_least(number_field("tyre_friction", 1, "1", ""), 0);
constexpr Field kTyreDensity = at_least(number_field("tyre_density", 1, "1", "kg/m^2"), 0);
constexpr Field kWheels = optional_field(
    "wheels", FieldType::Table,
    "a list of { x = 0, y = 0, radius = 0.4, driven = true, braked = true }, m in the chassis; absent: two");
constexpr std::array kVehicle = {
    parameter<&VehicleDef::position_m, &Position::x>(kX),
    parameter<&VehicleDef::position_m, &Position::y>(kY),
    parameter<&VehicleDef::length_m>(kVehicleLength),
    parameter<&VehicleDef::height_m>(kVehicleHeight),
    parameter<&VehicleDef::suspension_hz>(kSuspension),
    parameter<&VehicleDef::suspension_damping>(kSuspensionDamping),
    parameter<&VehicleDef::suspension_travel_m>(kSuspensionTravel),
    parameter<&VehicleDef::drive_torque_nm>(kDriveTorque),
    parameter<&VehicleDef::brake_torque_nm>(kBrakeTorque),
    parameter<&VehicleDef::chassis, &ShapeDef::density_kg_m2>(kChassisDensity),
    parameter<&VehicleDef::chassis, &ShapeDef::material, &Material::friction>(kChassisFriction),
    parameter<&VehicleDef::chassis, &ShapeDef::material, &Material::restitution>(kRestitution),
    parameter<&VehicleDef::tyre, &ShapeDef::material, &Material::friction>(kTyreFriction),
    parameter<&VehicleDef::tyre, &ShapeDef::density_kg_m2>(kTyreDensity),
};
constexpr auto kVehicleFields = fields_with<kVehicle>(std::array<const Field*, 1>{&kWheels});

constexpr Field kWheelRadius = above(number_field("radius", 0.4, "0.4", "m"), 0);
constexpr Field kDriven = boolean_field("driven", true, "");
constexpr Field kBraked = boolean_field("braked", true, "");
constexpr const Field* kWheelOwn[] = {&kX, &kY, &kWheelRadius, &kDriven, &kBraked};
constexpr FieldSet kWheelFields{kWheelOwn};

std::vector<VehicleWheelDef> read_wheels(lua_State* L, const FieldReader& reader) {
    std::vector<VehicleWheelDef> wheels;
    read_list(L, reader, kWheels, LUA_TTABLE, nullptr, [&](const std::string&) {
        const FieldReader wheel(L, -1, kWheelFields);
        wheels.push_back({.place_m = {wheel.real(kX), wheel.real(kY)},
                          .radius_m = wheel.real(kWheelRadius),
                          .driven = wheel.boolean(kDriven),
                          .braked = wheel.boolean(kBraked)});
    });
    return wheels;
}

// ---- Ragdoll
constexpr Field kScale = above(number_field("scale", 1, "1", "1: it is 1.6 m tall"), 0);
constexpr Field kMuscle =
    at_least(number_field("friction_torque", 0.05, "0.05", "N m, of the hips, at scale 1"), 0);
constexpr Field kMuscleSpring =
    at_least(number_field("spring_frequency", 0, "0", "Hz, of springs towards how it is made; 0: limp"), 0);
constexpr Field kMuscleDamping =
    at_least(number_field("spring_damping", 0.5, "0.5", "ratio; 1 is critical"), 0);
constexpr Field kVelocityX = number_field("linear_velocity_x", 0, "0", "m/s");
constexpr Field kVelocityY = number_field("linear_velocity_y", 0, "0", "m/s");
constexpr Field kSkinFriction = at_least(number_field("friction", 0.2, "0.2", "Coulomb coefficient"), 0);
constexpr std::array kRagdoll = {
    parameter<&RagdollDef::position_m, &Position::x>(kX),
    parameter<&RagdollDef::position_m, &Position::y>(kY),
    parameter<&RagdollDef::scale>(kScale),
    parameter<&RagdollDef::friction_torque_nm>(kMuscle),
    parameter<&RagdollDef::spring_hz>(kMuscleSpring),
    parameter<&RagdollDef::spring_damping>(kMuscleDamping),
    parameter<&RagdollDef::velocity_m_s, &Vec2::x>(kVelocityX),
    parameter<&RagdollDef::velocity_m_s, &Vec2::y>(kVelocityY),
    parameter<&RagdollDef::shape, &ShapeDef::density_kg_m2>(kDensity),
    parameter<&RagdollDef::shape, &ShapeDef::material, &Material::friction>(kSkinFriction),
    parameter<&RagdollDef::shape, &ShapeDef::material, &Material::restitution>(kRestitution),
};
constexpr auto kRagdollFields = fields_with<kRagdoll>();

// ---- Brick wall
constexpr Field kColumns = within(integer_field("columns", 6, "6", "bricks in a course"), 1, 1000);
constexpr Field kCourses =
    within(integer_field("courses", 8, "8", "a wall has at most 10000 bricks"), 1, 1000);
constexpr Field kBrickWidth = above(number_field("brick_width", 0.5, "0.5", "m"), 0.02);
constexpr Field kBrickHeight = above(number_field("brick_height", 0.25, "0.25", "m"), 0.01);
constexpr Field kMortar = above(number_field("mortar", 400, "400", "N/m: what a metre of mortar bears"), 0);
constexpr std::array kWall = joined(
    std::array{
        parameter<&BrickWallDef::position_m, &Position::x>(kX),
        parameter<&BrickWallDef::position_m, &Position::y>(kY),
        parameter<&BrickWallDef::columns>(kColumns),
        parameter<&BrickWallDef::courses>(kCourses),
        parameter<&BrickWallDef::brick_width_m>(kBrickWidth),
        parameter<&BrickWallDef::brick_height_m>(kBrickHeight),
        parameter<&BrickWallDef::mortar_n_m>(kMortar),
    },
    kMatter<&BrickWallDef::shape>);
constexpr auto kWallFields = fields_with<kWall>();

// ---- Blob
constexpr Field kRings = within(integer_field("rings", 3, "3", "of pieces about the middle one"), 1, 50);
constexpr Field kPieceRadius = above(number_field("piece_radius", 0.15, "0.15", "m"), 0);
constexpr Field kBlobFrequency = above(number_field("frequency", 15, "15", "Hz, of each weld"), 0);
constexpr Field kBlobDamping = at_least(number_field("damping_ratio", 0.7, "0.7", "1 is critical"), 0);
constexpr std::array kBlob = joined(
    std::array{
        parameter<&BlobDef::position_m, &Position::x>(kX),
        parameter<&BlobDef::position_m, &Position::y>(kY),
        parameter<&BlobDef::rings>(kRings),
        parameter<&BlobDef::piece_radius_m>(kPieceRadius),
        parameter<&BlobDef::stiffness_hz>(kBlobFrequency),
        parameter<&BlobDef::damping_ratio>(kBlobDamping),
        parameter<&BlobDef::strength, &JointStrength::break_force_n>(kBreakForce),
        parameter<&BlobDef::strength, &JointStrength::break_torque_nm>(kBreakTorque),
    },
    kMatter<&BlobDef::shape>);
constexpr auto kBlobFields = fields_with<kBlob>();

// ---- Pendulum
constexpr Field kBobs = within(integer_field("bobs", 1, "1", "two make a double pendulum"), 1, 100);
constexpr Field kRod = above(number_field("rod", 1, "1", "m, from centre to centre"), 0);
constexpr Field kBobRadius = above(number_field("radius", 0.15, "0.15", "m, of each bob"), 0);
constexpr Field kStartAngle = number_field("angle", 0.5, "0.5", "rad, from straight down");
constexpr std::array kPendulum = joined(
    std::array{
        parameter<&PendulumDef::pivot_m, &Position::x>(kX),
        parameter<&PendulumDef::pivot_m, &Position::y>(kY),
        parameter<&PendulumDef::bobs>(kBobs),
        parameter<&PendulumDef::rod_m>(kRod),
        parameter<&PendulumDef::radius_m>(kBobRadius),
        parameter<&PendulumDef::angle_rad>(kStartAngle),
        parameter<&PendulumDef::damping_1_s>(kDamping),
    },
    kMatter<&PendulumDef::shape>);
constexpr auto kPendulumFields =
    fields_with<kPendulum>(std::array<const Field*, 2>{&kHoldStart, &kStartBody});

// ---- Windmill
constexpr Field kSails = within(integer_field("sails", 4, "4", ""), 2, 24);
constexpr Field kHubRadius = above(number_field("hub_radius", 0.3, "0.3", "m"), 0);
constexpr Field kSailLength = above(number_field("sail_length", 2, "2", "m"), 0);
constexpr Field kSailWidth = above(number_field("sail_width", 0.4, "0.4", "m"), 0);
constexpr Field kTipRatio = above(
    number_field("tip_speed_ratio", 2, "2", "speed of the tips to that of the wind when nothing brakes"), 0);
constexpr Field kClockwise = boolean_field("clockwise", false, "which way it turns");
constexpr Field kHubFriction = at_least(number_field("friction_torque", 0.5, "0.5", "N m, of the hub"), 0);
constexpr std::array kWindmill = joined(
    std::array{
        parameter<&WindmillDef::position_m, &Position::x>(kX),
        parameter<&WindmillDef::position_m, &Position::y>(kY),
        parameter<&WindmillDef::sails>(kSails),
        parameter<&WindmillDef::hub_radius_m>(kHubRadius),
        parameter<&WindmillDef::sail_length_m>(kSailLength),
        parameter<&WindmillDef::sail_width_m>(kSailWidth),
        parameter<&WindmillDef::tip_speed_ratio>(kTipRatio),
        parameter<&WindmillDef::clockwise>(kClockwise),
        parameter<&WindmillDef::friction_torque_nm>(kHubFriction),
    },
    kMatter<&WindmillDef::shape>);
constexpr auto kWindmillFields =
    fields_with<kWindmill>(std::array<const Field*, 2>{&kHoldStart, &kStartBody});

// ---- Elevator
constexpr Field kFloors = optional_field(
    "floors", FieldType::Table, "a list of heights over y, m, ascending, at least one; absent: { 0, 3, 6 }");
constexpr Field kFloor = number_field("floor", 0, "0", "m");
constexpr Field kPlatformWidth = above(number_field("width", 2, "2", "m, of the platform"), 0);
constexpr Field kPlatformThickness = above(number_field("thickness", 0.2, "0.2", "m"), 0);
constexpr Field kSpeed = above(number_field("speed", 1.5, "1.5", "m/s"), 0);
constexpr Field kLoad = at_least(number_field("load", 100, "100", "kg, that it can carry"), 0);
constexpr Field kPlatformDensity = at_least(number_field("density", 100, "100", "kg/m^2"), 0);
constexpr Field kPlatformFriction = at_least(number_field("friction", 0.9, "0.9", "Coulomb coefficient"), 0);
constexpr std::array kElevator = {
    parameter<&ElevatorDef::position_m, &Position::x>(kX),
    parameter<&ElevatorDef::position_m, &Position::y>(kY),
    parameter<&ElevatorDef::width_m>(kPlatformWidth),
    parameter<&ElevatorDef::thickness_m>(kPlatformThickness),
    parameter<&ElevatorDef::speed_m_s>(kSpeed),
    parameter<&ElevatorDef::load_kg>(kLoad),
    parameter<&ElevatorDef::shape, &ShapeDef::density_kg_m2>(kPlatformDensity),
    parameter<&ElevatorDef::shape, &ShapeDef::material, &Material::friction>(kPlatformFriction),
    parameter<&ElevatorDef::shape, &ShapeDef::material, &Material::restitution>(kRestitution),
};
constexpr auto kElevatorFields = fields_with<kElevator>(std::array<const Field*, 1>{&kFloors});

// ---- Gear train
constexpr Field kRadii =
    optional_field("radii", FieldType::Table, "a list of radii, m, at least one; absent: { 0.5, 1, 0.25 }");
constexpr Field kRadius = above(number_field("radius", 1, "1", "m"), 0);
constexpr Field kAlongX = number_field("direction_x", 1, "1", "of the row, of any length");
constexpr Field kAlongY = number_field("direction_y", 0, "0", "");
constexpr Field kGearSpeed = number_field("motor_speed", 1, "1", "rad/s, of the first wheel");
constexpr Field kGearTorque =
    within(number_field("max_motor_torque", 0, "0", "N m; 0: no motor"), 0, kInfinity);
constexpr std::array kGears = joined(
    std::array{
        parameter<&GearTrainDef::position_m, &Position::x>(kX),
        parameter<&GearTrainDef::position_m, &Position::y>(kY),
        parameter<&GearTrainDef::direction, &Vec2::x>(kAlongX),
        parameter<&GearTrainDef::direction, &Vec2::y>(kAlongY),
        parameter<&GearTrainDef::motor_speed_rad_s>(kGearSpeed),
        parameter<&GearTrainDef::max_motor_torque_nm>(kGearTorque),
    },
    kMatter<&GearTrainDef::shape>);
constexpr auto kGearFields = fields_with<kGears>(std::array<const Field*, 1>{&kRadii});

// ---- Pulley lift
constexpr Field kDistance =
    above(number_field("distance", 4, "4", "m, between the centres of the platforms"), 0);
constexpr Field kTravel = above(number_field("travel", 2, "2", "m, up and down"), 0);
constexpr Field kLiftWidth = above(number_field("width", 1.5, "1.5", "m, of each platform"), 0);
constexpr Field kRopeUp = above(number_field("rope", 5, "5", "m, up to the wheels"), 0);
constexpr Field kRatio = above(number_field("ratio", 1, "1", "of a block and tackle on the right"), 0);
constexpr Field kLeftDensity = at_least(number_field("left_density", 1, "1", "kg/m^2"), 0);
constexpr Field kRightDensity = at_least(number_field("right_density", 1, "1", "kg/m^2"), 0);
constexpr std::array kLift = {
    parameter<&PulleyLiftDef::position_m, &Position::x>(kX),
    parameter<&PulleyLiftDef::position_m, &Position::y>(kY),
    parameter<&PulleyLiftDef::distance_m>(kDistance),
    parameter<&PulleyLiftDef::travel_m>(kTravel),
    parameter<&PulleyLiftDef::width_m>(kLiftWidth),
    parameter<&PulleyLiftDef::thickness_m>(kPlatformThickness),
    parameter<&PulleyLiftDef::rope_m>(kRopeUp),
    parameter<&PulleyLiftDef::ratio>(kRatio),
    parameter<&PulleyLiftDef::left, &ShapeDef::density_kg_m2>(kLeftDensity),
    parameter<&PulleyLiftDef::right, &ShapeDef::density_kg_m2>(kRightDensity),
};
constexpr auto kLiftFields = fields_with<kLift>();

}  // namespace

const FieldSet PrefabReader<LinkChainDef>::kFields{kChainFields, {&kOneMatterFields}};
const FieldSet PrefabReader<RopeDef>::kFields{kRopeFields, {&kOneMatterFields}};
const FieldSet PrefabReader<BridgeDef>::kFields{kBridgeFields, {&kOneMatterFields}};
const FieldSet PrefabReader<VehicleDef>::kFields{kVehicleFields, {&kOneMatterFields}};
const FieldSet PrefabReader<RagdollDef>::kFields{kRagdollFields, {&kOneMatterFields}};
const FieldSet PrefabReader<BrickWallDef>::kFields{kWallFields, {&kOneMatterFields}};
const FieldSet PrefabReader<BlobDef>::kFields{kBlobFields, {&kOneMatterFields}};
const FieldSet PrefabReader<PendulumDef>::kFields{kPendulumFields, {&kOneMatterFields}};
const FieldSet PrefabReader<WindmillDef>::kFields{kWindmillFields, {&kOneMatterFields}};
const FieldSet PrefabReader<ElevatorDef>::kFields{kElevatorFields, {&kOneMatterFields}};
const FieldSet PrefabReader<GearTrainDef>::kFields{kGearFields, {&kOneMatterFields}};
const FieldSet PrefabReader<PulleyLiftDef>::kFields{kLiftFields, {&kCommonFields}};

LinkChainDef PrefabReader<LinkChainDef>::read(lua_State* L, const FieldReader& reader) {
    auto def = read_common<LinkChainDef>(reader, kChain);
    read_end(L, reader, kHoldStart, kStartBody, def.start);
    read_end(L, reader, kHoldChainEnd, kEndBody, def.end);
    return def;
}
RopeDef PrefabReader<RopeDef>::read(lua_State* L, const FieldReader& reader) {
    auto def = read_common<RopeDef>(reader, kRope);
    read_end(L, reader, kHoldStart, kStartBody, def.from);
    read_end(L, reader, kHoldEnd, kEndBody, def.to);
    return def;
}
BridgeDef PrefabReader<BridgeDef>::read(lua_State* L, const FieldReader& reader) {
    auto def = read_common<BridgeDef>(reader, kBridge);
    read_end(L, reader, kHoldStart, kStartBody, def.from);
    read_end(L, reader, kHoldEnd, kEndBody, def.to);
    return def;
}
VehicleDef PrefabReader<VehicleDef>::read(lua_State* L, const FieldReader& reader) {
    VehicleDef def;
    read_other_matter(reader, def.chassis);
    read_parameters(reader, kVehicle, def);
    read_filter(reader, def.chassis);
    read_filter(reader, def.tyre);
    if (reader.has(kWheels)) def.wheels = read_wheels(L, reader);
    return def;
}
RagdollDef PrefabReader<RagdollDef>::read(lua_State*, const FieldReader& reader) {
    auto def = read_common<RagdollDef>(reader, kRagdoll);
    def.group = def.shape.filter.group;
    return def;
}
BrickWallDef PrefabReader<BrickWallDef>::read(lua_State*, const FieldReader& reader) {
    return read_common<BrickWallDef>(reader, kWall);
}
BlobDef PrefabReader<BlobDef>::read(lua_State*, const FieldReader& reader) {
    return read_common<BlobDef>(reader, kBlob);
}
PendulumDef PrefabReader<PendulumDef>::read(lua_State* L, const FieldReader& reader) {
    auto def = read_common<PendulumDef>(reader, kPendulum);
    read_end(L, reader, kHoldStart, kStartBody, def.pivot);
    return def;
}
WindmillDef PrefabReader<WindmillDef>::read(lua_State* L, const FieldReader& reader) {
    auto def = read_common<WindmillDef>(reader, kWindmill);
    read_end(L, reader, kHoldStart, kStartBody, def.hub);
    return def;
}
ElevatorDef PrefabReader<ElevatorDef>::read(lua_State* L, const FieldReader& reader) {
    auto def = read_common<ElevatorDef>(reader, kElevator);
    if (reader.has(kFloors)) def.floors_m = read_numbers(L, reader, kFloors, "height", kFloor);
    return def;
}
GearTrainDef PrefabReader<GearTrainDef>::read(lua_State* L, const FieldReader& reader) {
    auto def = read_common<GearTrainDef>(reader, kGears);
    if (reader.has(kRadii)) def.radii_m = read_numbers(L, reader, kRadii, "radius", kRadius);
    return def;
}
PulleyLiftDef PrefabReader<PulleyLiftDef>::read(lua_State*, const FieldReader& reader) {
    PulleyLiftDef def;
    read_parameters(reader, kLift, def);
    read_filter(reader, def.left);
    read_filter(reader, def.right);
    return def;
}

void push_prefab_data(lua_State* L, const FieldReader& reader) {
    if (!reader.push(kData)) lua_pushnil(L);
}

}  // namespace cairn::scripting
