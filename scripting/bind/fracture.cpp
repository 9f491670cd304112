// Fields of fractures, and the values of pieces.
#include "bind/fracture.h"

#include <array>
#include <limits>
#include <span>

#include "bind/object_data.h"
#include "data/nearest.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

using physics::BodyId;
using physics::Position;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Field kX = optional_field("x", FieldType::Number, "m, of the impact; absent: the centre of mass");
constexpr Field kY = optional_field("y", FieldType::Number, "m");
constexpr Field kPattern{"pattern", FieldType::String, "uniform",
                         "\"uniform\", pieces of about one size, or \"radial\", shards about the impact"};
constexpr Field kPieces =
    within(integer_field("pieces", 12, "12", "about how many"), 2, physics::kMaxFracturePieces);
constexpr Field kSeed = integer_field("seed", 0, "0", "the same seed, body and impact give the same pieces");
constexpr Field kMinWidth = at_least(number_field("min_width", 0.05, "0.05", "m, of a piece"), 0.01);
constexpr Field kRadius =
    above(number_field("radius", kInfinity, "math.huge", "m; what is farther from the impact stays whole"), 0,
          kInfinity);
constexpr Field kGrainX = number_field("grain_x", 0, "0", "pieces are longer along the grain, 1 to 16 times");
constexpr Field kGrainY = number_field("grain_y", 0, "0", "");
constexpr Field kRelease =
    boolean_field("release", false, "pieces of a static or kinematic body become dynamic");
constexpr const Field* kFractureOwn[] = {&kPattern, &kPieces, &kSeed,   &kMinWidth,
                                         &kRadius,  &kGrainX, &kGrainY, &kRelease};
const FieldSet kHowFields = {kFractureOwn, {}};
constexpr const Field* kImpactOwn[] = {&kX, &kY};

constexpr Field kStrength =
    above(number_field("strength", 10, "10", "N s, the impulse of a contact in a step that it withstands"), 0,
          kInfinity);
constexpr Field kGenerations =
    within(integer_field("generations", 1, "1", "how often; pieces break one time less often"), 1, 16);
constexpr Field kAutomatic = boolean_field(
    "automatic", true, "the step breaks it; otherwise the script does, when it reads world:breaks()");
constexpr Field kGivesBack =
    boolean_field("gives_back", true, "what broke it keeps the momentum that it did not withstand");
constexpr const Field* kBreakableOwn[] = {&kStrength, &kGenerations, &kAutomatic, &kGivesBack};

// What is absent stays as it is.
void read_fracture(const FieldReader& reader, physics::FractureDef& def) {
    if (reader.has(kPattern)) {
        const std::string_view name = reader.text(kPattern);
        static const std::vector<std::string> names = {"uniform", "radial"};
        if (name != names[0] && name != names[1])
            reader.fail(kPattern, "no such pattern" + suggestion(name, names));
        def.pattern = name == names[0] ? physics::FracturePattern::Uniform : physics::FracturePattern::Radial;
    }
    if (reader.has(kPieces)) def.pieces = static_cast<int>(reader.integer(kPieces));
    if (reader.has(kSeed)) def.seed = static_cast<std::uint64_t>(reader.integer(kSeed));
    if (reader.has(kMinWidth)) def.min_width_m = reader.real(kMinWidth);
    if (reader.has(kRadius)) def.radius_m = reader.real(kRadius);
    if (reader.has(kGrainX)) def.grain.x = reader.real(kGrainX);
    if (reader.has(kGrainY)) def.grain.y = reader.real(kGrainY);
    if (reader.has(kRelease)) def.release = reader.boolean(kRelease);
}

// Replaces the table on top of the stack by a copy.
void copy_table(lua_State* L) {
    const int from = lua_gettop(L);
    lua_newtable(L);
    lua_pushnil(L);
    while (lua_next(L, from) != 0) {
        lua_pushvalue(L, -2);
        lua_insert(L, -2);  // the key stays for lua_next
        lua_rawset(L, from + 1);
    }
    lua_remove(L, from);
}

/// Pushes a list with copies of the data of the shapes that pieces were cut from, and gives the shapes of the
/// pieces to which they belong, in the same order. Before any of these has a value: it may have the slot of
/// one that is gone.
std::vector<physics::ShapeId> push_data_of_shapes(lua_State* L, int world_index, const physics::World& world,
                                                  std::span<const BodyId> pieces) {
    std::vector<physics::ShapeId> heirs;
    lua_newtable(L);
    const int list = lua_gettop(L);
    lua_getiuservalue(L, world_index, static_cast<int>(WorldTable::Shapes));
    const int shapes = lua_gettop(L);
    for (const BodyId piece : pieces) {
        for (const physics::ShapeId id : value_or_raise(L, world.body(piece)).shapes()) {
            const std::uint64_t mark = value_or_raise(L, world.shape(id)).user_data();
            lua_rawgeti(L, shapes, static_cast<lua_Integer>(physics::ShapeId::from_bits(mark).index1));
            const auto* from = object_at<ShapeObject>(L, -1);
            if (from != nullptr && mark_of(from->id) == mark &&
                lua_getiuservalue(L, -1, kDataValue) == LUA_TTABLE) {
                copy_table(L);
                heirs.push_back(id);
                lua_rawseti(L, list, static_cast<lua_Integer>(heirs.size()));
            }
            lua_settop(L, shapes);
        }
    }
    lua_settop(L, list);
    return heirs;
}

// The pieces get values, the body loses its own.
void adopt(lua_State* L, int world_index, WorldObject& world, BodyId body, std::span<const BodyId> pieces) {
    if (pieces.empty()) return;
    world_index = lua_absindex(L, world_index);
    const std::vector<physics::ShapeId> heirs = push_data_of_shapes(L, world_index, *world.world, pieces);
    const int list = lua_gettop(L);
    push_body(L, world_index, body);
    const int from = lua_gettop(L);
    for (const BodyId piece : pieces) {
        if (lua_isnil(L, from) || lua_getfield(L, from, "data") != LUA_TTABLE) {
            lua_settop(L, from);
            lua_newtable(L);
        } else {
            copy_table(L);
        }
        push_new_body(L, world_index, world, piece);
        lua_pop(L, 1);
    }
    lua_Integer number = 0;
    for (const physics::ShapeId heir : heirs) {
        push_shape(L, world_index, world, heir);
        lua_rawgeti(L, list, ++number);
        set_data(L);
        lua_pop(L, 1);
    }
    lua_settop(L, list - 1);
    retire_body(L, world_index, world, body);
}

Pushed push_pieces(lua_State* L, BodyRef self, const std::vector<BodyId>& pieces) {
    const BodyId body = self.object.id;
    WorldObject& world = *self.object.world;
    push_world_of(L, self.index);
    const int world_index = lua_gettop(L);
    adopt(L, world_index, world, body, pieces);
    lua_createtable(L, static_cast<int>(pieces.size()), 0);
    lua_Integer count = 0;
    for (const BodyId piece : pieces) {
        push_body(L, world_index, piece);
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}

void set_number(lua_State* L, const char* name, double value) {
    lua_pushnumber(L, value);
    lua_setfield(L, -2, name);
}

}  // namespace

const FieldSet kFractureFields = {kImpactOwn, {&kHowFields}};
const FieldSet kBreakableFields = {kBreakableOwn, {&kHowFields}};

Pushed cut(lua_State* L, BodyRef self, double x1, double y1, double x2, double y2) {
    const auto pieces =
        value_or_raise(L, self.object.world->world->cut_body(self.object.id, {x1, y1}, {x2, y2}));
    return push_pieces(L, self, pieces);
}

Pushed fracture(lua_State* L, BodyRef self, TableArgument fields) {
    const FieldReader reader(L, fields.index, kFractureFields);
    physics::World& world = *self.object.world->world;
    const auto breakable = value_or_raise(L, world.breakable(self.object.id));
    physics::FractureDef def = breakable ? breakable->fracture : physics::FractureDef{};
    read_fracture(reader, def);
    Position impact = self.body.world_center();
    if (const auto x = reader.optional_number(kX)) impact.x = *x;
    if (const auto y = reader.optional_number(kY)) impact.y = *y;
    const auto pieces = value_or_raise(L, world.break_body(self.object.id, impact, def));
    return push_pieces(L, self, pieces);
}

physics::Result<void> set_breakable(lua_State* L, BodyRef self, TableArgument fields) {
    const FieldReader reader(L, fields.index, kBreakableFields);
    physics::BreakableDef def;
    read_fracture(reader, def.fracture);
    def.strength_ns = reader.real(kStrength);
    def.generations = static_cast<int>(reader.integer(kGenerations));
    def.automatic = reader.boolean(kAutomatic);
    def.gives_back = reader.boolean(kGivesBack);
    return self.object.world->world->set_breakable(self.object.id, def);
}

physics::Result<void> clear_breakable(BodyRef self) {
    return self.object.world->world->clear_breakable(self.object.id);
}

bool is_breakable(lua_State* L, BodyRef self) {
    return value_or_raise(L, self.object.world->world->breakable(self.object.id)).has_value();
}

Pushed breakable(lua_State* L, BodyRef self) {
    const auto def = value_or_raise(L, self.object.world->world->breakable(self.object.id));
    if (!def) return lua_pushnil(L), Pushed{1};
    const physics::FractureDef& fracture = def->fracture;
    lua_createtable(L, 0, 11);
    set_number(L, kStrength.name, static_cast<double>(def->strength_ns));
    set_number(L, kMinWidth.name, static_cast<double>(fracture.min_width_m));
    set_number(L, kRadius.name, static_cast<double>(fracture.radius_m));
    set_number(L, kGrainX.name, static_cast<double>(fracture.grain.x));
    set_number(L, kGrainY.name, static_cast<double>(fracture.grain.y));
    lua_pushstring(L, fracture.pattern == physics::FracturePattern::Uniform ? "uniform" : "radial");
    lua_setfield(L, -2, kPattern.name);
    const std::pair<const Field&, lua_Integer> integers[] = {{kPieces, fracture.pieces},
                                                             {kSeed, static_cast<lua_Integer>(fracture.seed)},
                                                             {kGenerations, def->generations}};
    for (const auto& [field, value] : integers) {
        lua_pushinteger(L, value);
        lua_setfield(L, -2, field.name);
    }
    const std::pair<const Field&, bool> booleans[] = {
        {kRelease, fracture.release}, {kAutomatic, def->automatic}, {kGivesBack, def->gives_back}};
    for (const auto& [field, value] : booleans) {
        lua_pushboolean(L, value ? 1 : 0);
        lua_setfield(L, -2, field.name);
    }
    return {1};
}

Pushed cuts_along(lua_State* L, WorldRef self, double x1, double y1, double x2, double y2, Filter filter,
                  Ignored ignored) {
    const auto hits =
        value_or_raise(L, ask(Sight(L, self, filter, ignored), [&](const physics::QueryFilter& seen) {
                           return self.world.cuts_along({x1, y1}, {x2, y2}, seen);
                       }));
    lua_createtable(L, static_cast<int>(hits.size()), 0);
    lua_Integer count = 0;
    for (const physics::CutHit& hit : hits) {
        lua_createtable(L, 0, 6);
        push_body(L, self.index, hit.body);
        lua_setfield(L, -2, "body");
        set_number(L, "x1", hit.enter_m.x);
        set_number(L, "y1", hit.enter_m.y);
        set_number(L, "x2", hit.exit_m.x);
        set_number(L, "y2", hit.exit_m.y);
        lua_pushinteger(L, hit.pieces);
        lua_setfield(L, -2, "pieces");
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}

void adopt_pieces(lua_State* L, WorldRef world) {
    for (const physics::BodyBreak& event : world.world.body_breaks())
        adopt(L, world.index, world.object, event.body, event.pieces);
}

}  // namespace cairn::scripting
