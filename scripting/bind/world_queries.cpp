// A shape that asks is a table: `shape`, its fields, and where it stands.
#include "bind/world_queries.h"

#include <algorithm>
#include <array>

#include "bind/fields.h"
#include "data/nearest.h"

namespace cairn::scripting {
namespace {

using physics::Position;
using physics::QueryFilter;
using physics::Vec2;

constexpr Field kShape = choice_field("shape", nullptr, "box circle capsule polygon segment", "");
constexpr const Field* kAskingOwn[] = {&kShape};

struct AskingShape {
    OwnedGeometry geometry;
    physics::Transform pose;
};

void read_asking(lua_State* L, TableArgument table, AskingShape& out) {
    lua_getfield(L, table.index, kShape.name);
    if (lua_type(L, -1) != LUA_TSTRING)
        call_error(L, "shape is " + describe_value(L, -1) +
                          "; expected \"box\", \"circle\", \"capsule\", "
                          "\"polygon\" or \"segment\"");
    const std::string name = lua_tostring(L, -1);
    lua_pop(L, 1);
    const std::vector<std::string> names = words_of(kShape.choices);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        call_error(L, "shape = \"" + name + "\": no such shape" + suggestion(name, names));
    const auto kind = static_cast<GeometryKind>(found - names.begin());
    const FieldSet fields{kAskingOwn, {&kGeometryFields[found - names.begin()], &kPlaceFields}};
    const FieldReader reader(L, table.index, fields);
    read_geometry(L, reader, kind, {}, out.geometry);
    if (out.geometry.parts.size() > 1)
        call_error(L, "points: a polygon that asks must be convex and have at most 8 corners");
    const BodyPlace place = read_body_place(reader);
    out.pose = {place.position_m, physics::Rotation::from_angle(place.angle_rad)};
}

void set_number(lua_State* L, const char* name, double value) {
    lua_pushnumber(L, value);
    lua_setfield(L, -2, name);
}

void set_place(lua_State* L, Position point, Vec2 normal) {
    set_number(L, "x", point.x);
    set_number(L, "y", point.y);
    set_number(L, "nx", static_cast<double>(normal.x));
    set_number(L, "ny", static_cast<double>(normal.y));
}

void set_more(lua_State* L, const physics::RayHit& hit) {
    set_number(L, "fraction", static_cast<double>(hit.fraction));
}
void set_more(lua_State* L, const physics::ShapeHit& hit) {
    set_number(L, "fraction", static_cast<double>(hit.fraction));
    set_number(L, "overlap", static_cast<double>(hit.overlap_m));
}
void set_more(lua_State* L, const physics::SurfacePoint& point) {
    set_number(L, "distance", static_cast<double>(point.distance_m));
}
void set_more(lua_State* L, const physics::CollisionPlane& plane) {
    set_number(L, "separation", static_cast<double>(plane.separation_m));
    set_number(L, "nx_before", static_cast<double>(plane.normal_before.x));
    set_number(L, "ny_before", static_cast<double>(plane.normal_before.y));
    set_number(L, "nx_after", static_cast<double>(plane.normal_after.x));
    set_number(L, "ny_after", static_cast<double>(plane.normal_after.y));
    lua_pushboolean(L, plane.is_dynamic ? 1 : 0);
    lua_setfield(L, -2, "dynamic");
}

/// A list of tables with body, shape, x, y, nx, ny and what else there is.
template <class Hit>
Pushed push_hits(lua_State* L, WorldRef world, const std::vector<Hit>& hits) {
    lua_createtable(L, static_cast<int>(hits.size()), 0);
    lua_Integer count = 0;
    for (const Hit& hit : hits) {
        lua_createtable(L, 0, 8);
        push_body(L, world.index, hit.body);
        lua_setfield(L, -2, "body");
        push_shape(L, world.index, world.object, hit.shape);
        lua_setfield(L, -2, "shape");
        set_place(L, hit.point_m, hit.normal);
        set_more(L, hit);
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}

Pushed push_shapes(lua_State* L, WorldRef world, const std::vector<physics::ShapeId>& ids) {
    lua_createtable(L, static_cast<int>(ids.size()), 0);
    lua_Integer count = 0;
    for (const physics::ShapeId id : ids) {
        push_shape(L, world.index, world.object, id);
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}

void push_place(lua_State* L, WorldRef world, physics::BodyId body, Position point, Vec2 normal) {
    push_body(L, world.index, body);
    for (const double number :
         {point.x, point.y, static_cast<double>(normal.x), static_cast<double>(normal.y)})
        lua_pushnumber(L, number);
}

// ---- What acts on many bodies
constexpr Field kX = number_field("x", 0, "0", "m");
constexpr Field kY = number_field("y", 0, "0", "m");
constexpr Field kRadius = at_least(number_field("radius", 3, "3", "m; full strength up to here"), 0);
constexpr Field kFalloff =
    at_least(number_field("falloff", 2, "2", "m; from there on it fades to nothing over this distance"), 0);
constexpr Field kImpulse =
    number_field("impulse", 10, "10", "N s per metre of outline that faces the point; negative: inward");
constexpr Field kShelter = integer_field(
    "shelter", 0, "0", "bit set: shapes of these categories keep it from what lies behind them");
constexpr const Field* kExplosionOwn[] = {&kX, &kY, &kRadius, &kFalloff, &kImpulse, &kShelter};

constexpr Field kWindX = number_field("velocity_x", 0, "0", "m/s, of the air; (0, 0) slows bodies down");
constexpr Field kWindY = number_field("velocity_y", 0, "0", "m/s");
constexpr Field kAirDensity = at_least(number_field("density", 1.2, "1.2", "kg/m^2, of the air"), 0);
constexpr Field kDrag = at_least(number_field("drag", 1, "1", "1 suits most shapes"), 0);
constexpr Field kLift = at_least(number_field("lift", 0, "0", "1 suits flat plates"), 0);
constexpr const Field* kWindOwn[] = {&kWindX, &kWindY, &kAirDensity, &kDrag, &kLift};

physics::WindDef read_wind(const FieldReader& reader) {
    physics::WindDef def;
    def.velocity_m_s = {reader.real(kWindX), reader.real(kWindY)};
    def.density_kg_m2 = reader.real(kAirDensity);
    def.drag = reader.real(kDrag);
    def.lift = reader.real(kLift);
    return def;
}

// In the order of physics::Mixing.
constexpr std::string_view kMixings = "geometric_mean average minimum maximum multiply fixed";
constexpr Field kFriction = choice_field("friction", "geometric_mean", kMixings, "how the two values mix");
constexpr Field kFixedFriction = at_least(number_field("fixed_friction", 0, "0", "with \"fixed\""), 0);
constexpr Field kRestitution = choice_field("restitution", "maximum", kMixings, "how the two values mix");
constexpr Field kFixedRestitution = within(number_field("fixed_restitution", 0, "0", "with \"fixed\""), 0, 1);
constexpr const Field* kMaterialRuleOwn[] = {&kFriction, &kFixedFriction, &kRestitution, &kFixedRestitution};

void set_mixing(lua_State* L, const Field& field, const Field& fixed, const physics::MixRule& rule) {
    const std::string word = words_of(kMixings)[static_cast<std::size_t>(rule.mixing)];
    lua_pushlstring(L, word.data(), word.size());
    lua_setfield(L, -2, field.name);
    set_number(L, fixed.name, static_cast<double>(rule.fixed));
}

}  // namespace

const FieldSet kExplosionFields{kExplosionOwn, {&kSightFields}};
const FieldSet kWindFields{kWindOwn, {&kSightFields}};
const FieldSet kMaterialRuleFields{kMaterialRuleOwn};

Pushed body_at(lua_State* L, WorldRef self, double x, double y, Filter filter, Ignored ignored) {
    const auto found = value_or_raise(L, ask(Sight(L, self, filter, ignored), [&](const QueryFilter& seen) {
                                          return self.world.shape_at({x, y}, seen);
                                      }));
    if (!found) return lua_pushnil(L), Pushed{1};
    push_body(L, self.index, value_or_raise(L, self.world.shape(*found)).body());
    push_shape(L, self.index, self.object, *found);
    return {2};
}

Pushed cast_ray(lua_State* L, WorldRef self, double x1, double y1, double x2, double y2, Filter filter,
                Ignored ignored) {
    const Position origin{x1, y1};
    const auto hit = value_or_raise(L, ask(Sight(L, self, filter, ignored), [&](const QueryFilter& seen) {
                                        return self.world.cast_ray(origin, Position{x2, y2} - origin, seen);
                                    }));
    if (!hit) return lua_pushnil(L), Pushed{1};
    push_place(L, self, hit->body, hit->point_m, hit->normal);
    lua_pushnumber(L, static_cast<double>(hit->fraction));
    push_shape(L, self.index, self.object, hit->shape);
    return {7};
}

Pushed cast_ray_all(lua_State* L, WorldRef self, double x1, double y1, double x2, double y2, Filter filter,
                    Ignored ignored) {
    const Position origin{x1, y1};
    return push_hits(
        L, self, value_or_raise(L, ask(Sight(L, self, filter, ignored), [&](const QueryFilter& seen) {
                                    return self.world.cast_ray_all(origin, Position{x2, y2} - origin, seen);
                                })));
}

Pushed cast_shape(lua_State* L, WorldRef self, TableArgument shape, float dx, float dy, Filter filter,
                  Ignored ignored) {
    AskingShape asking;
    read_asking(L, shape, asking);
    const auto hit = value_or_raise(
        L, ask(Sight(L, self, filter, ignored), [&](const QueryFilter& seen) {
            return self.world.cast_shape(asking.geometry.parts.front(), asking.pose, {dx, dy}, seen);
        }));
    if (!hit) return lua_pushnil(L), Pushed{1};
    push_place(L, self, hit->body, hit->point_m, hit->normal);
    lua_pushnumber(L, static_cast<double>(hit->fraction));
    lua_pushnumber(L, static_cast<double>(hit->overlap_m));
    push_shape(L, self.index, self.object, hit->shape);
    return {8};
}

Pushed cast_shape_all(lua_State* L, WorldRef self, TableArgument shape, float dx, float dy, Filter filter,
                      Ignored ignored) {
    AskingShape asking;
    read_asking(L, shape, asking);
    return push_hits(
        L, self,
        value_or_raise(
            L, ask(Sight(L, self, filter, ignored), [&](const QueryFilter& seen) {
                return self.world.cast_shape_all(asking.geometry.parts.front(), asking.pose, {dx, dy}, seen);
            })));
}

Pushed shapes_overlapping(lua_State* L, WorldRef self, TableArgument shape, Filter filter, Ignored ignored) {
    AskingShape asking;
    read_asking(L, shape, asking);
    return push_shapes(L, self,
                       value_or_raise(L, ask(Sight(L, self, filter, ignored), [&](const QueryFilter& seen) {
                                          return self.world.shapes_overlapping(asking.geometry.parts.front(),
                                                                               asking.pose, seen);
                                      })));
}

Pushed shapes_in_box(lua_State* L, WorldRef self, double x1, double y1, double x2, double y2, Filter filter,
                     Ignored ignored) {
    const Position lower{std::min(x1, x2), std::min(y1, y2)};
    const Position upper{std::max(x1, x2), std::max(y1, y2)};
    return push_shapes(L, self,
                       value_or_raise(L, ask(Sight(L, self, filter, ignored), [&](const QueryFilter& seen) {
                                          return self.world.shapes_in_box(lower, upper, seen);
                                      })));
}

Pushed closest_point(lua_State* L, WorldRef self, double x, double y, NotNegative radius, Filter filter,
                     Ignored ignored) {
    const auto found = value_or_raise(L, ask(Sight(L, self, filter, ignored), [&](const QueryFilter& seen) {
                                          return self.world.closest_point({x, y}, radius, seen);
                                      }));
    if (!found) return lua_pushnil(L), Pushed{1};
    push_place(L, self, found->body, found->point_m, found->normal);
    lua_pushnumber(L, static_cast<double>(found->distance_m));
    push_shape(L, self.index, self.object, found->shape);
    return {7};
}

Pushed closest_points(lua_State* L, WorldRef self, double x, double y, NotNegative radius, Filter filter,
                      Ignored ignored) {
    return push_hits(L, self,
                     value_or_raise(L, ask(Sight(L, self, filter, ignored), [&](const QueryFilter& seen) {
                                        return self.world.closest_points({x, y}, radius, seen);
                                    })));
}

Pushed collision_planes(lua_State* L, WorldRef self, TableArgument shape, NotNegative reach, Filter filter,
                        Ignored ignored) {
    AskingShape asking;
    read_asking(L, shape, asking);
    return push_hits(L, self,
                     value_or_raise(L, ask(Sight(L, self, filter, ignored), [&](const QueryFilter& seen) {
                                        return self.world.collision_planes(asking.geometry.parts.front(),
                                                                           asking.pose, reach, seen);
                                    })));
}

physics::Result<void> explode(lua_State* L, WorldRef self, TableArgument fields) {
    const FieldReader reader(L, fields.index, kExplosionFields);
    physics::ExplosionDef def;
    def.center_m = {reader.number(kX), reader.number(kY)};
    def.radius_m = reader.real(kRadius);
    def.falloff_m = reader.real(kFalloff);
    def.impulse_ns_m = reader.real(kImpulse);
    def.shelter = static_cast<std::uint64_t>(reader.integer(kShelter));
    return ask(Sight(L, self, reader), [&](const QueryFilter& seen) {
        def.filter = seen;
        return self.world.explode(def);
    });
}

physics::Result<void> apply_wind(lua_State* L, WorldRef self, TableArgument fields, StepTime dt_s) {
    const FieldReader reader(L, fields.index, kWindFields);
    physics::WindDef def = read_wind(reader);
    return ask(Sight(L, self, reader), [&](const QueryFilter& seen) {
        def.filter = seen;
        return self.world.apply_wind(def, dt_s);
    });
}

physics::Result<void> apply_wind_to_body(lua_State* L, BodyRef self, TableArgument fields, StepTime dt_s) {
    const FieldReader reader(L, fields.index, kWindFields);
    physics::WindDef def = read_wind(reader);
    const physics::BodyId body = self.object.id;
    push_world_of(L, self.index);
    const WorldRef world = Argument<WorldRef>::get(L, lua_gettop(L));
    return ask(Sight(L, world, reader), [&](const QueryFilter& seen) {
        def.filter = seen;
        return world.world.apply_wind(body, def, dt_s);
    });
}

physics::Result<void> set_material_rule(lua_State* L, WorldRef self, MaterialKind kind_a, MaterialKind kind_b,
                                        TableArgument fields) {
    const FieldReader reader(L, fields.index, kMaterialRuleFields);
    const physics::MaterialRule rule{
        .friction = {static_cast<physics::Mixing>(reader.choice(kFriction)), reader.real(kFixedFriction)},
        .restitution = {static_cast<physics::Mixing>(reader.choice(kRestitution)),
                        reader.real(kFixedRestitution)}};
    return self.world.set_material_rule(static_cast<int>(kind_a.value), static_cast<int>(kind_b.value), rule);
}

Pushed material_rule(lua_State* L, WorldRef self, MaterialKind kind_a, MaterialKind kind_b) {
    const auto rule = value_or_raise(
        L, self.world.material_rule(static_cast<int>(kind_a.value), static_cast<int>(kind_b.value)));
    lua_createtable(L, 0, 4);
    set_mixing(L, kFriction, kFixedFriction, rule.friction);
    set_mixing(L, kRestitution, kFixedRestitution, rule.restitution);
    return {1};
}

}  // namespace cairn::scripting
