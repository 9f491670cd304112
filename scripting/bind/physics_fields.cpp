// One constant per field: its name, default, unit and meaning stand here and nowhere else.
#include "bind/physics_fields.h"

#include <array>
#include <cmath>
#include <limits>

#include <cairn/physics/tuning.h>

#include "bind/context.h"
#include "bind/convex_parts.h"
#include "bind/function.h"
#include "bind/physics_objects.h"
#include "data/nearest.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

using physics::Vec2;

// What the physics accepts, in the words of the fields: a shape reaches at most so far from the body's
// origin, and two points that are nearer than its slop are one to it.
constexpr double kMaxReach_m = 1e6;
constexpr auto kPointsApart_m = static_cast<double>(physics::tuning::kLinearSlop_m);

// ---- World
constexpr Field kGravityX = number_field("gravity_x", 0, "0", "m/s^2");
constexpr Field kGravityY = number_field("gravity_y", -10, "-10", "m/s^2");
constexpr Field kSubsteps = within(integer_field("substeps", 4, "4", "solver passes per step"), 1, 64);
constexpr Field kSleep = boolean_field("sleep", true, "whether resting bodies stop being computed");
constexpr Field kHitSpeed = at_least(
    number_field("hit_speed", 1, "1", "m/s; the least approach speed that makes a \"hit\" event"), 0);
constexpr Field kRestitutionSpeed =
    at_least(number_field("restitution_speed", 1, "1", "m/s; slower approaches do not bounce"), 0);
constexpr Field kPushOutSpeed =
    above(number_field("max_push_out_speed", 3, "3", "m/s; how fast overlap is undone at most"), 0);
constexpr Field kJointSolver = choice_field(
    "joint_solver", "automatic", "automatic sweeping direct",
    "\"automatic\", \"sweeping\" (cheapest) or \"direct\" (all structures at once, whatever it costs)");
constexpr Field kThreads =
    within(integer_field("threads", 1, "1", "that share a step; the results do not depend on it"), 1, 64);
constexpr const Field* kWorldOwn[] = {&kGravityX,         &kGravityY,     &kSubsteps,    &kSleep,  &kHitSpeed,
                                      &kRestitutionSpeed, &kPushOutSpeed, &kJointSolver, &kThreads};

// ---- Body
constexpr Field kX = within(number_field("x", 0, "0", "m"), -physics::kFarthest_m, physics::kFarthest_m);
constexpr Field kY = within(number_field("y", 0, "0", "m"), -physics::kFarthest_m, physics::kFarthest_m);
constexpr Field kAngle = number_field("angle", 0, "0", "rad");
// In the order of physics::BodyType.
constexpr Field kType =
    choice_field("type", "dynamic", "static kinematic dynamic", "\"static\", \"kinematic\" or \"dynamic\"");
constexpr Field kVelocityX = number_field("linear_velocity_x", 0, "0", "m/s, of the centre of mass");
constexpr Field kVelocityY = number_field("linear_velocity_y", 0, "0", "m/s, of the centre of mass");
constexpr Field kAngularVelocity = number_field("angular_velocity", 0, "0", "rad/s");
constexpr Field kLinearDamping = at_least(number_field("linear_damping", 0, "0", "1/s; c in v e^(-c t)"), 0);
constexpr Field kAngularDamping = at_least(number_field("angular_damping", 0, "0", "1/s"), 0);
constexpr Field kGravityScale = number_field("gravity_scale", 1, "1", "");
constexpr Field kAllowSleep = boolean_field("allow_sleep", true, "");
constexpr Field kAwake = boolean_field("awake", true, "");
constexpr Field kLockX = boolean_field("lock_x", false, "the centre of mass stays at its x");
constexpr Field kLockY = boolean_field("lock_y", false, "the centre of mass stays at its y");
constexpr Field kLockRotation = boolean_field("lock_rotation", false, "it does not turn");
constexpr Field kSleepSpeed =
    at_least(number_field("sleep_speed", static_cast<double>(physics::tuning::kSleepSpeed_m_s), "0.05",
                          "m/s; may sleep when slower than this for half a second; at 0 it never does"),
             0);
constexpr Field kData = optional_field("data", FieldType::Table, "becomes body.data");
constexpr Field kShapeData = optional_field("data", FieldType::Table, "becomes shape.data");
constexpr const Field* kPlaceOwn[] = {&kX, &kY, &kAngle};
constexpr const Field* kShapeDataOwn[] = {&kShapeData};
constexpr const Field* kBodyOwn[] = {&kX,
                                     &kY,
                                     &kAngle,
                                     &kType,
                                     &kVelocityX,
                                     &kVelocityY,
                                     &kAngularVelocity,
                                     &kLinearDamping,
                                     &kAngularDamping,
                                     &kGravityScale,
                                     &kAllowSleep,
                                     &kAwake,
                                     &kLockX,
                                     &kLockY,
                                     &kLockRotation,
                                     &kSleepSpeed,
                                     &kData};

// ---- Shape
constexpr Field kDensity = at_least(
    number_field(
        "density", 1, "1",
        "kg/m^2; a dynamic body whose shapes all have 0 has no mass: no force moves it, gravity neither, and "
        "only its velocity, if it is given one, does"),
    0);
constexpr Field kFriction = at_least(number_field("friction", 0.6, "0.6", "Coulomb coefficient"), 0);
constexpr Field kRestitution =
    within(number_field("restitution", 0, "0", "share of the approach speed given back"), 0, 1);
constexpr Field kCategories = integer_field("categories", 1, "1", "bit set: what the shape is");
constexpr Field kMask = integer_field("mask", -1, "-1", "bit set: what it collides with; -1 is everything");
constexpr Field kGroup = within(
    integer_field("group", 0, "0",
                  "two shapes of the same group other than 0: positive always collide, negative never"),
    kGroups);
constexpr Field kContactEvents = boolean_field("contact_events", true, "\"begin\" and \"end\" events");
constexpr Field kHitEvents = boolean_field("hit_events", true, "\"hit\" events");
constexpr Field kRolling = at_least(
    number_field("rolling_resistance", 0, "0",
                 "coefficient: a torque of this times the normal force times the radius resists rolling"),
    0);
constexpr Field kSurfaceSpeed = number_field(
    "surface_speed", 0, "0", "m/s; a conveyor belt: positive carries what lies on top to the right");
constexpr Field kMaterialKind =
    within(integer_field("material_kind", 0, "0", "what `world:set_material_rule` knows the material by"),
           kMaterialKindNumbers);
constexpr Field kSensor = boolean_field(
    "sensor", false, "collides with nothing; `world:sensor_events()` tells what comes to overlap it");
constexpr Field kSeenBySensors = boolean_field("seen_by_sensors", true, "");
constexpr Field kOneWayX = number_field(
    "one_way_x", 0, "0", "not (0, 0): solid only for what comes from that side, as a platform is");
constexpr Field kOneWayY = number_field("one_way_y", 0, "0", "in the body's frame, of any length");
constexpr Field kMaterialName =
    optional_field("material", FieldType::String,
                   "a name of `cairn.physics.define_material`; what is not said beside it is as there");
constexpr const Field* kMaterialNameOwn[] = {&kMaterialName};
constexpr const Field* kShapeOwn[] = {&kMaterialName, &kDensity,       &kFriction,      &kRestitution,
                                      &kRolling,      &kSurfaceSpeed,  &kMaterialKind,  &kCategories,
                                      &kMask,         &kGroup,         &kContactEvents, &kHitEvents,
                                      &kSensor,       &kSeenBySensors, &kOneWayX,       &kOneWayY};
constexpr const Field* kMaterialOwn[] = {&kMaterialName, &kFriction,     &kRestitution,
                                         &kRolling,      &kSurfaceSpeed, &kMaterialKind};
constexpr const Field* kMatterOwn[] = {&kDensity, &kFriction,     &kRestitution,
                                       &kRolling, &kSurfaceSpeed, &kMaterialKind};
constexpr const Field* kOtherMatterOwn[] = {&kMaterialName, &kRolling, &kSurfaceSpeed, &kMaterialKind};
constexpr const Field* kFilterOwn[] = {&kCategories, &kMask, &kGroup, &kContactEvents, &kHitEvents};

// ---- Geometry
constexpr Field kWidth = above(required_field("width", FieldType::Number, "m"), 0, 2 * kMaxReach_m);
constexpr Field kHeight = above(required_field("height", FieldType::Number, "m"), 0, 2 * kMaxReach_m);
constexpr Field kRadius = above(required_field("radius", FieldType::Number, "m"), 0, kMaxReach_m);
constexpr Field kRounding =
    within(number_field("radius", 0, "0", "m; rounds the corners outward"), 0, kMaxReach_m);
constexpr Field kLength =
    above(required_field("length", FieldType::Number, "m, between the centres of the two ends, along x"),
          kPointsApart_m, 2 * kMaxReach_m);
constexpr Field kPoints = required_field("points", FieldType::Points,
                                         "{ {x, y}, ... }, m: 3 to 256 corners in order, either way round");
constexpr Field kX1 = required_field("x1", FieldType::Number, "m; one end, in the body's frame");
constexpr Field kY1 = required_field("y1", FieldType::Number, "m");
constexpr Field kX2 = required_field("x2", FieldType::Number, "m; the other end");
constexpr Field kY2 = required_field("y2", FieldType::Number, "m");
constexpr const Field* kBoxOwn[] = {&kWidth, &kHeight, &kRounding};
constexpr const Field* kCircleOwn[] = {&kRadius};
constexpr const Field* kCapsuleOwn[] = {&kLength, &kRadius};
constexpr const Field* kPolygonOwn[] = {&kPoints, &kRounding};

constexpr const Field* kSegmentOwn[] = {&kX1, &kY1, &kX2, &kY2};

// ---- Chain
constexpr Field kChainPoints = required_field("points", FieldType::Points,
                                              "{ {x, y}, ... }, m: walking along them, others are kept on "
                                              "the right, so ground runs from right to left");
constexpr Field kClosed = boolean_field("closed", false, "a segment leads from the last point to the first");
constexpr Field kBeforeX = optional_field("before_x", FieldType::Number,
                                          "m; the point with which another chain goes on before the first");
constexpr Field kBeforeY = optional_field("before_y", FieldType::Number, "m");
constexpr Field kAfterX = optional_field("after_x", FieldType::Number, "m; the same behind the last point");
constexpr Field kAfterY = optional_field("after_y", FieldType::Number, "m");
constexpr const Field* kChainOwn[] = {&kChainPoints,   &kClosed,       &kBeforeX,    &kBeforeY,     &kAfterX,
                                      &kAfterY,        &kMaterialName, &kFriction,   &kRestitution, &kRolling,
                                      &kSurfaceSpeed,  &kMaterialKind, &kCategories, &kMask,        &kGroup,
                                      &kContactEvents, &kHitEvents};

constexpr const Field* kChainOutlineOwn[] = {&kChainPoints, &kClosed, &kBeforeX,
                                             &kBeforeY,     &kAfterX, &kAfterY};

constexpr FieldSet kBodyFields{kBodyOwn};

std::vector<Vec2> read_points(lua_State* L, const FieldReader& reader, const Field& field) {
    reader.push(field);
    std::vector<Vec2> points = read_point_list(L, -1, field.name);
    lua_pop(L, 1);
    return points;
}

/// The material that the table names, or null.
const Matter* find_material(const FieldReader& reader) {
    if (!reader.has(kMaterialName)) return nullptr;
    const std::string_view name = reader.text(kMaterialName);
    const Materials& materials = context_of(reader.lua()).materials;
    const auto found = materials.find(name);
    if (found != materials.end()) return &found->second;
    if (materials.empty())
        reader.fail(kMaterialName,
                    "no such material; cairn.physics.define_material gives names to materials");
    std::vector<std::string> names;
    for (const auto& material : materials) names.push_back(material.first);
    reader.fail(kMaterialName, "no such material" + suggestion(name, names));
}

std::optional<Vec2> read_end(lua_State* L, const FieldReader& reader, const Field& x, const Field& y) {
    const auto given_x = reader.optional_number(x);
    const auto given_y = reader.optional_number(y);
    if (given_x.has_value() != given_y.has_value())
        call_error(L,
                   std::string(x.name) + " and " + y.name + " belong together; both or neither are expected");
    if (!given_x) return std::nullopt;
    return Vec2{static_cast<float>(*given_x), static_cast<float>(*given_y)};
}

}  // namespace

const FieldSet kWorldFields{kWorldOwn};
const FieldSet kNewBodyFields{kBodyOwn};
const FieldSet kFilterFields{kFilterOwn};

const FieldSet kShapeFields{kShapeOwn};
const FieldSet kPlaceFields{kPlaceOwn};
const FieldSet kDataFields{kShapeDataOwn};
const FieldSet kMaterialFields{kMaterialOwn};
const FieldSet kMatterFields{kMatterOwn};
const FieldSet kOtherMatterFields{kOtherMatterOwn};
const FieldSet kMaterialNameFields{kMaterialNameOwn};
const FieldSet kChainShapeFields{kChainOwn};
const FieldSet kChainOutlineFields{kChainOutlineOwn};

const FieldSet kGeometryFields[kGeometryKinds] = {
    {kBoxOwn}, {kCircleOwn}, {kCapsuleOwn}, {kPolygonOwn}, {kSegmentOwn},
};
const FieldSet kWorldAddFields[kGeometryKinds] = {
    {kBoxOwn, {&kBodyFields, &kShapeFields}},     {kCircleOwn, {&kBodyFields, &kShapeFields}},
    {kCapsuleOwn, {&kBodyFields, &kShapeFields}}, {kPolygonOwn, {&kBodyFields, &kShapeFields}},
    {kSegmentOwn, {&kBodyFields, &kShapeFields}},
};
const FieldSet kBodyAddFields[kGeometryKinds] = {
    {kBoxOwn, {&kPlaceFields, &kShapeFields, &kDataFields}},
    {kCircleOwn, {&kPlaceFields, &kShapeFields, &kDataFields}},
    {kCapsuleOwn, {&kPlaceFields, &kShapeFields, &kDataFields}},
    {kPolygonOwn, {&kPlaceFields, &kShapeFields, &kDataFields}},
    {kSegmentOwn, {&kPlaceFields, &kShapeFields, &kDataFields}},
};
const FieldSet kWorldAddChainFields{kChainOwn, {&kBodyFields}};
const FieldSet kBodyAddChainFields{kChainOwn};

std::vector<Vec2> read_point_list(lua_State* L, int index, const std::string& name) {
    const int table = lua_absindex(L, index);
    std::vector<Vec2> points;
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, table));
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_rawgeti(L, table, i);
        const std::string where = name + "[" + std::to_string(i) + "]";
        if (!lua_istable(L, -1)) call_error(L, where + " is " + describe_value(L, -1) + "; expected {x, y}");
        lua_rawgeti(L, -1, 1);
        lua_rawgeti(L, -2, 2);
        if (lua_type(L, -2) != LUA_TNUMBER || lua_type(L, -1) != LUA_TNUMBER) {
            call_error(L, where + " is {" + describe_value(L, -2) + ", " + describe_value(L, -1) +
                              "}; expected {x, y}, two numbers");
        }
        points.push_back({static_cast<float>(lua_tonumber(L, -2)), static_cast<float>(lua_tonumber(L, -1))});
        lua_pop(L, 3);
    }
    return points;
}

physics::WorldDef read_world_def(const FieldReader& reader) {
    physics::WorldDef def;
    def.gravity_m_s2 = {reader.real(kGravityX), reader.real(kGravityY)};
    def.substeps = static_cast<int>(reader.integer(kSubsteps));
    def.enable_sleep = reader.boolean(kSleep);
    def.hit_speed_m_s = reader.real(kHitSpeed);
    def.restitution_speed_m_s = reader.real(kRestitutionSpeed);
    def.max_push_out_speed_m_s = reader.real(kPushOutSpeed);
    def.joint_solver = static_cast<physics::JointSolver>(reader.choice(kJointSolver));
    def.threads = static_cast<int>(reader.integer(kThreads));
    return def;
}

physics::BodyDef read_body_def(const FieldReader& reader) {
    physics::BodyDef def;
    def.type = static_cast<physics::BodyType>(reader.choice(kType));
    def.position_m = {reader.number(kX), reader.number(kY)};
    def.angle_rad = reader.number(kAngle);
    def.linear_velocity_m_s = {reader.real(kVelocityX), reader.real(kVelocityY)};
    def.angular_velocity_rad_s = reader.real(kAngularVelocity);
    def.linear_damping_1_s = reader.real(kLinearDamping);
    def.angular_damping_1_s = reader.real(kAngularDamping);
    def.gravity_scale = reader.real(kGravityScale);
    def.allow_sleep = reader.boolean(kAllowSleep);
    def.awake = reader.boolean(kAwake);
    def.locks = {reader.boolean(kLockX), reader.boolean(kLockY), reader.boolean(kLockRotation)};
    def.sleep_speed_m_s = reader.real(kSleepSpeed);
    return def;
}

physics::ShapeDef read_shape_def(const FieldReader& reader) {
    physics::ShapeDef def;
    const Matter matter = read_matter(reader);
    def.density_kg_m2 = matter.density_kg_m2;
    def.material = matter.material;
    def.sensor = reader.boolean(kSensor);
    def.seen_by_sensors = reader.boolean(kSeenBySensors);
    def.one_way_normal = {reader.real(kOneWayX), reader.real(kOneWayY)};
    read_filter(reader, def);
    return def;
}

Matter read_matter(const FieldReader& reader) {
    const Matter* named = find_material(reader);
    const auto surface = [&](const Field& field, float physics::Material::*value) {
        return named != nullptr && !reader.has(field) ? named->material.*value : reader.real(field);
    };
    Matter matter;
    matter.density_kg_m2 =
        named != nullptr && !reader.has(kDensity) ? named->density_kg_m2 : reader.real(kDensity);
    matter.material = {.friction = surface(kFriction, &physics::Material::friction),
                       .restitution = surface(kRestitution, &physics::Material::restitution),
                       .rolling_resistance = surface(kRolling, &physics::Material::rolling_resistance),
                       .surface_speed_m_s = surface(kSurfaceSpeed, &physics::Material::surface_speed_m_s),
                       .kind = named != nullptr ? named->material.kind : 0};
    if (named == nullptr || reader.has(kMaterialKind))
        matter.material.kind = static_cast<int>(reader.integer(kMaterialKind));
    return matter;
}

void read_other_matter(const FieldReader& reader, physics::ShapeDef& def) {
    if (const Matter* named = find_material(reader)) {
        def.density_kg_m2 = named->density_kg_m2;
        def.material = named->material;
    }
    if (reader.has(kRolling)) def.material.rolling_resistance = reader.real(kRolling);
    if (reader.has(kSurfaceSpeed)) def.material.surface_speed_m_s = reader.real(kSurfaceSpeed);
    if (reader.has(kMaterialKind)) def.material.kind = static_cast<int>(reader.integer(kMaterialKind));
}

physics::Material read_material(const FieldReader& reader) {
    return read_matter(reader).material;
}

void push_material(lua_State* L, const physics::Material& material) {
    const std::pair<const Field&, float> numbers[] = {{kFriction, material.friction},
                                                      {kRestitution, material.restitution},
                                                      {kRolling, material.rolling_resistance},
                                                      {kSurfaceSpeed, material.surface_speed_m_s}};
    lua_createtable(L, 0, 6);
    for (const auto& [field, value] : numbers) {
        lua_pushnumber(L, static_cast<double>(value));
        lua_setfield(L, -2, field.name);
    }
    lua_pushinteger(L, material.kind);
    lua_setfield(L, -2, kMaterialKind.name);
}

void read_chain(lua_State* L, const FieldReader& reader, OwnedChain& out) {
    out.points_m = read_points(L, reader, kChainPoints);
    out.material = read_material(reader);
    physics::ShapeDef shape;
    read_filter(reader, shape);
    out.def.points_m = out.points_m;
    out.def.closed = reader.boolean(kClosed);
    out.def.before_m = read_end(L, reader, kBeforeX, kBeforeY);
    out.def.after_m = read_end(L, reader, kAfterX, kAfterY);
    out.def.materials = {&out.material, 1};
    out.def.filter = shape.filter;
    out.def.contact_events = shape.contact_events;
    out.def.hit_events = shape.hit_events;
}

void read_filter(const FieldReader& reader, physics::ShapeDef& def) {
    def.filter.categories = static_cast<std::uint64_t>(reader.integer(kCategories));
    def.filter.mask = static_cast<std::uint64_t>(reader.integer(kMask));
    def.filter.group = static_cast<std::int32_t>(reader.integer(kGroup));
    def.contact_events = reader.boolean(kContactEvents);
    def.hit_events = reader.boolean(kHitEvents);
}

ShapePlace read_shape_place(const FieldReader& reader) {
    return {{reader.real(kX), reader.real(kY)}, reader.number(kAngle)};
}

BodyPlace read_body_place(const FieldReader& reader) {
    return {{reader.number(kX), reader.number(kY)}, reader.number(kAngle)};
}

void read_geometry(lua_State* L, const FieldReader& reader, GeometryKind kind, const ShapePlace& place,
                   OwnedGeometry& out) {
    const physics::Rotation q = physics::Rotation::from_angle(place.angle_rad);
    switch (kind) {
        case GeometryKind::Box:
            out.parts = {physics::Box{.half_width_m = reader.real(kWidth) / 2,
                                      .half_height_m = reader.real(kHeight) / 2,
                                      .center_m = place.position_m,
                                      .angle_rad = static_cast<float>(place.angle_rad),
                                      .radius_m = reader.real(kRounding)}};
            return;
        case GeometryKind::Circle:
            out.parts = {physics::Circle{.center_m = place.position_m, .radius_m = reader.real(kRadius)}};
            return;
        case GeometryKind::Capsule: {
            const Vec2 half = physics::rotate(q, {reader.real(kLength) / 2, 0});
            out.parts = {physics::Capsule{.a_m = place.position_m - half,
                                          .b_m = place.position_m + half,
                                          .radius_m = reader.real(kRadius)}};
            return;
        }
        case GeometryKind::Polygon:
            out.points_m = value_or_raise(L, convex_parts(read_points(L, reader, kPoints)));
            for (std::vector<Vec2>& part : out.points_m) {
                for (Vec2& point : part) point = place.position_m + physics::rotate(q, point);
                out.parts.push_back(physics::Polygon{.points_m = part, .radius_m = reader.real(kRounding)});
            }
            return;
        case GeometryKind::Segment: {
            const auto placed = [&](const Field& x, const Field& y) {
                return place.position_m + physics::rotate(q, {reader.real(x), reader.real(y)});
            };
            out.parts = {physics::Segment{.a_m = placed(kX1, kY1), .b_m = placed(kX2, kY2)}};
            return;
        }
    }
}

void push_data_table(lua_State* L, const FieldReader& reader) {
    if (!reader.push(kData)) lua_newtable(L);
}

}  // namespace cairn::scripting
