// The methods of Shape.
#include "bind/modules.h"
#include "bind/pair_filter.h"
#include "bind/physics_fields.h"
#include "bind/physics_names.h"
#include "bind/physics_objects.h"

namespace cairn::scripting {
namespace {

using Change = physics::Result<void>;

Pushed body(lua_State* L, ShapeRef self) {
    push_world_of(L, self.index);
    push_body(L, -1, self.shape.body());
    return {1};
}

Pushed chain(lua_State* L, ShapeRef self) {
    const physics::ChainId id = self.shape.chain();
    if (!id) return lua_pushnil(L), Pushed{1};
    push_world_of(L, self.index);
    push_chain(L, -1, *self.object.world, id);
    return {1};
}

std::string_view kind(ShapeRef self) {
    return name_of(self.shape.outline().kind);
}

Pushed points(lua_State* L, ShapeRef self) {
    const physics::Outline& outline = self.shape.outline();
    luaL_checkstack(L, 2 * physics::kMaxPolygonVertices, "points of a shape");
    for (std::size_t i = 0; i < outline.count; ++i) {
        lua_pushnumber(L, static_cast<double>(outline.points_m[i].x));
        lua_pushnumber(L, static_cast<double>(outline.points_m[i].y));
    }
    return {2 * outline.count};
}

float radius(ShapeRef self) {
    return self.shape.outline().radius_m;
}
float density(ShapeRef self) {
    return self.shape.density();
}
Change set_density(ShapeRef self, NotNegative density) {
    return self.shape.set_density(density);
}
float friction(ShapeRef self) {
    return self.shape.material().friction;
}
Change set_friction(ShapeRef self, NotNegative friction) {
    physics::Material material = self.shape.material();
    material.friction = friction;
    return self.shape.set_material(material);
}
float restitution(ShapeRef self) {
    return self.shape.material().restitution;
}
Change set_restitution(ShapeRef self, Share restitution) {
    physics::Material material = self.shape.material();
    material.restitution = restitution;
    return self.shape.set_material(material);
}

std::tuple<std::int64_t, std::int64_t, std::int64_t> filter(ShapeRef self) {
    const physics::Filter filter = self.shape.filter();
    return {static_cast<std::int64_t>(filter.categories), static_cast<std::int64_t>(filter.mask),
            filter.group};
}
void set_filter(ShapeRef self, std::int64_t categories, std::int64_t mask,
                Ranged<kGroups, std::int64_t> group) {
    self.shape.set_filter({.categories = static_cast<std::uint64_t>(categories),
                           .mask = static_cast<std::uint64_t>(mask),
                           .group = static_cast<std::int32_t>(group.value)});
}

Pushed material(lua_State* L, ShapeRef self) {
    push_material(L, self.shape.material());
    return {1};
}
Change set_material(lua_State* L, ShapeRef self, TableArgument fields) {
    return self.shape.set_material(read_material(FieldReader(L, fields.index, kMaterialFields)));
}

std::tuple<float, float> one_way(ShapeRef self) {
    const physics::Vec2 normal = self.shape.one_way_normal();
    return {normal.x, normal.y};
}
Change set_one_way(ShapeRef self, float x, float y) {
    return self.shape.set_one_way_normal({x, y});
}
bool is_sensor(ShapeRef self) {
    return self.shape.is_sensor();
}
Pushed overlaps(lua_State* L, ShapeRef self) {
    const auto found = value_or_raise(L, self.object.world->world->sensor_overlaps(self.object.id));
    push_world_of(L, self.index);
    const int world = lua_gettop(L);
    lua_newtable(L);
    lua_Integer count = 0;
    for (const physics::ShapeId id : found) {
        if (!self.object.world->world->contains(id)) continue;
        push_shape(L, world, *self.object.world, id);
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}
bool is_seen_by_sensors(ShapeRef self) {
    return self.shape.is_seen_by_sensors();
}
void set_seen_by_sensors(ShapeRef self, bool seen) {
    self.shape.set_seen_by_sensors(seen);
}

Change destroy(ShapeRef self) {
    return self.object.world->world->destroy_shape(self.object.id);
}
bool is_valid(Maybe<ShapeObject> self) {
    const physics::World* world = readable_world(*self.object.world);
    return world != nullptr && world->contains(self.object.id);
}

constexpr std::array<std::string_view, 1> kReturnsBody = {"Body"};
constexpr std::array<std::string_view, 1> kReturnsChain = {"Chain?"};
constexpr std::array<std::string_view, 1> kReturnsTable = {"table"};
constexpr std::array<std::string_view, 1> kReturnsNumbers = {"number"};

constexpr Function kFunctions[] = {
    function_pushing<&body>("body", "", "body", kReturnsBody, ""),
    function_pushing<&chain>("chain", "", "chain", kReturnsChain, "nil unless it is a segment of a chain."),
    function<&kind>(
        "kind", "", "kind",
        "\"circle\", \"capsule\", \"polygon\" (boxes are polygons), \"segment\" or \"chain_segment\"."),
    function_pushing<&points>(
        "points", "", "x1 [m]", kReturnsNumbers,
        "x1, y1, x2, y2, ...: the centre of a circle, the two ends of a capsule, or the corners of "
        "a polygon anticlockwise, in the body's frame."),
    function<&radius>("radius", "", "radius [m]",
                      "Of the circle or capsule; of a polygon how far its corners are rounded."),
    function<&density>("density", "", "density [kg/m^2]", ""),
    function<&set_density>("set_density", "density [kg/m^2]", "",
                           "The mass of the body follows, and the body wakes."),
    function<&friction>("friction", "", "friction", ""),
    function<&set_friction>("set_friction", "friction", "", ""),
    function<&restitution>("restitution", "", "restitution", ""),
    function<&set_restitution>("set_restitution", "restitution", "", ""),
    function<&filter>("filter", "", "categories, mask, group", ""),
    function<&set_filter>("set_filter", "categories, mask, group", "",
                          "Ends touching that the new filter forbids."),
    function_pushing<&material>("material", "", "material", kReturnsTable,
                                "A new table with the fields that `set_material` takes."),
    function<&set_material>("set_material", "fields", "", "What is not given is as by default.",
                            &kMaterialFields),
    function<&one_way>("one_way", "", "x, y", "In the body's frame; (0, 0): solid from all sides."),
    function<&set_one_way>("set_one_way", "x, y", "",
                           "Solid only for what comes from that side; (0, 0): from all sides."),
    function<&is_sensor>("is_sensor", "", "sensor", ""),
    function_pushing<&overlaps>("overlaps", "", "shapes", kReturnsTable,
                                "Of a sensor: a new list of what overlapped it at the end of the last step, "
                                "or passed through it within that step."),
    function<&is_seen_by_sensors>("is_seen_by_sensors", "", "seen", ""),
    function<&set_seen_by_sensors>("set_seen_by_sensors", "seen", "", ""),
    function<&destroy>("destroy", "", "", "Removes the shape from its body."),
    function<&is_valid>("is_valid", "", "valid", "Whether the shape was not destroyed."),
};

}  // namespace

const Module kShapeMethods = {"Shape",
                              "What a body is made of. `shape.data` is a table of your own that is kept as "
                              "long as the shape and may be "
                              "replaced; pieces of a broken body have empty ones.",
                              kFunctions, true};

}  // namespace cairn::scripting
