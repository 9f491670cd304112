// cairn.level and the methods of Level. Invariant: when building fails, nothing of the level is left in the
// world.
#include "bind/level.h"

#include <algorithm>

#include "bind/callbacks.h"
#include "bind/context.h"
#include "bind/data_values.h"
#include "bind/fields.h"
#include "bind/graphics_objects.h"
#include "bind/level_parts.h"
#include "bind/level_trial.h"
#include "bind/modules.h"
#include "bind/physics_objects.h"
#include "data/nearest.h"
#include "data/table_writer.h"
#include "level/match.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

struct DecorationImage {
    engine::TextureId texture;
    engine::ImageDraw draw;
    bool is_front;
};

/// User value 1 is the world in which the level is built, or nil; user value 2 the list of what was made:
/// part number -> Body, Joint or Prefab.
struct LevelObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Level;
    Level level;
    TiledImport import;
    std::vector<DecorationImage> images;
    bool has_images = false;
};
constexpr int kWorldValue = 1;
constexpr int kObjectsValue = 2;

constexpr Field kScale =
    at_least(optional_field("scale", FieldType::Number,
                            "m per pixel, of maps of Tiled; absent: one tile is one metre wide"),
             0);
constexpr const Field* kLoadOwn[] = {&kScale};
constexpr FieldSet kLoadFields{kLoadOwn};

LevelReading read_and_try(lua_State* L, const std::string& path, const TiledImport& import) {
    LevelReading reading = read_level(context_of(L).services.files, path, import);
    for (std::string& fault : faults_of_building(L, reading.level)) {
        // Parts of one template share its faults.
        const bool is_told =
            std::find(reading.faults.begin(), reading.faults.end(), fault) != reading.faults.end();
        if (!is_told) reading.faults.push_back(std::move(fault));
    }
    return reading;
}

TiledImport read_import(lua_State* L, const std::optional<TableArgument>& fields) {
    if (!fields) return {};
    return {.scale = FieldReader(L, fields->index, kLoadFields).optional_number(kScale).value_or(0)};
}

/// All faults are one error; each begins with its place in the file, which helps more than that of the call.
[[noreturn]] void raise_faults(lua_State* L, const std::vector<std::string>& faults) {
    std::string message;
    for (const std::string& fault : faults) message += (message.empty() ? "" : "\n") + fault;
    lua_pushlstring(L, message.data(), message.size());
    lua_error(L);
    std::abort();  // lua_error never returns; its declaration does not say so
}

/// Number -> Level, weak: what hot reload walks over.
void push_living_levels(lua_State* L) {
    constexpr const char* kLevels = "cairn.levels";
    if (lua_getfield(L, LUA_REGISTRYINDEX, kLevels) == LUA_TTABLE) return;
    lua_pop(L, 1);
    lua_newtable(L);
    lua_createtable(L, 0, 1);
    lua_pushliteral(L, "v");
    lua_setfield(L, -2, "__mode");
    lua_setmetatable(L, -2);
    lua_pushvalue(L, -1);
    lua_setfield(L, LUA_REGISTRYINDEX, kLevels);
}

Pushed load(lua_State* L, std::string_view path, std::optional<TableArgument> fields) {
    const TiledImport import = read_import(L, fields);
    const auto kind = context_of(L).services.files.kind(path);
    if (!kind || *kind != engine::FileKind::File)
        call_error(L, "path is " + quote_text(path) + ": there is no such file");
    LevelReading reading = read_and_try(L, std::string(path), import);
    if (!reading.faults.empty()) raise_faults(L, reading.faults);
    new_object<LevelObject>(L, 2, std::move(reading.level), import, std::vector<DecorationImage>{});
    push_living_levels(L);
    lua_pushvalue(L, -2);
    lua_rawseti(L, -2, context_of(L).levels_loaded++);
    lua_pop(L, 1);
    return {1};
}

Pushed check(lua_State* L, std::string_view path, std::optional<TableArgument> fields) {
    const std::vector<std::string> faults = faults_of_level(L, std::string(path), read_import(L, fields));
    lua_createtable(L, static_cast<int>(faults.size()), 0);
    for (std::size_t i = 0; i < faults.size(); ++i) {
        lua_pushlstring(L, faults[i].data(), faults[i].size());
        lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
    }
    return {1};
}

}  // namespace

template <>
struct Argument<LevelObject*> {
    static constexpr std::string_view kType = "Level";
    static LevelObject* get(lua_State* L, int index) {
        auto* level = object_at<LevelObject>(L, index);
        if (level == nullptr) argument_error(L, index, "a Level");
        return level;
    }
};

namespace {

// ---- Building

/// Whether the world in which the level was built lives; it and the list of what was made are pushed then.
bool push_build(lua_State* L, int level) {
    lua_getiuservalue(L, level, kWorldValue);
    const auto* world = object_at<WorldObject>(L, -1);
    if (world == nullptr || !world->world) {
        lua_pop(L, 1);
        return false;
    }
    lua_getiuservalue(L, level, kObjectsValue);
    return true;
}

void clear(lua_State* L, LevelObject* self) {
    if (!push_build(L, 1)) return;
    unmake_parts(L, self->level, -1);
    lua_pushnil(L);
    lua_setiuservalue(L, 1, kWorldValue);
}

void set_gravity(WorldRef world, const Level& level) {
    physics::Vec2 gravity = world.world.gravity();
    if (level.gravity_x) gravity.x = static_cast<float>(*level.gravity_x);
    if (level.gravity_y) gravity.y = static_cast<float>(*level.gravity_y);
    // A level whose gravity is not finite was refused when it was read.
    if (level.gravity_x || level.gravity_y) static_cast<void>(world.world.set_gravity(gravity));
}

/// Makes the parts that the list lacks. After a failure all that it made is gone again, and the error raised.
void make_missing(lua_State* L, const Level& level, int world, int objects,
                  const std::vector<bool>& is_wanted) {
    for (std::size_t part = 0; part < level.parts.size(); ++part) {
        if (!is_wanted[part]) continue;
        const std::vector<std::string> faults = make_part(L, level, part, world, objects);
        if (faults.empty()) continue;
        unmake_parts(L, level, objects);
        call_error(L, faults.front());
    }
}

void build(lua_State* L, LevelObject* self, WorldRef world) {
    clear(L, self);
    lua_settop(L, 2);
    lua_createtable(L, static_cast<int>(self->level.parts.size()), 0);
    make_missing(L, self->level, world.index, 3, std::vector<bool>(self->level.parts.size(), true));
    set_gravity(world, self->level);
    lua_setiuservalue(L, 1, kObjectsValue);
    lua_pushvalue(L, world.index);
    lua_setiuservalue(L, 1, kWorldValue);
}

bool is_built(lua_State* L, LevelObject*) {
    return push_build(L, 1);
}

// ---- Reloading

std::tuple<std::int64_t, std::int64_t> reload(lua_State* L, LevelObject* self) {
    LevelReading reading = read_and_try(L, self->level.path, self->import);
    if (!reading.faults.empty()) raise_faults(L, reading.faults);
    self->has_images = false;
    lua_settop(L, 1);
    if (!push_build(L, 1)) {
        self->level = std::move(reading.level);
        return {0, 0};
    }
    const auto count = static_cast<std::int64_t>(reading.level.parts.size());
    constexpr int kWorld = 2;
    constexpr int kOld = 3;
    constexpr int kNew = 4;
    const std::vector<std::size_t> matches = match_parts(self->level, reading.level);
    lua_createtable(L, static_cast<int>(matches.size()), 0);
    std::vector<bool> is_new(matches.size());
    std::int64_t kept = 0;
    for (std::size_t i = 0; i < matches.size(); ++i) {
        is_new[i] = matches[i] == kNoPart;
        if (is_new[i]) continue;
        ++kept;
        // Moved from one list to the other, so that what is left in the old one is what goes.
        lua_rawgeti(L, kOld, static_cast<lua_Integer>(matches[i] + 1));
        lua_rawseti(L, kNew, static_cast<lua_Integer>(i + 1));
        lua_pushnil(L);
        lua_rawseti(L, kOld, static_cast<lua_Integer>(matches[i] + 1));
    }
    unmake_parts(L, self->level, kOld);
    self->level = std::move(reading.level);
    lua_pushvalue(L, kNew);
    lua_setiuservalue(L, 1, kObjectsValue);
    make_missing(L, self->level, kWorld, kNew, is_new);
    const WorldRef world = Argument<WorldRef>::get(L, kWorld);
    set_gravity(world, self->level);
    return {kept, count - kept};
}

// ---- What it holds

/// Pushes what was made of the part of that name.
Pushed push_named(lua_State* L, LevelObject* self, PartKind kind, std::string_view name) {
    const auto part = self->level.find(kind, name);
    if (!part) {
        call_error(L, "name is " + quote_text(name) + ": the level has no such " + section_of(kind).one +
                          suggestion(name, self->level.names(kind)));
    }
    if (!push_build(L, 1)) call_error(L, "the level is not built; level:build(world) does");
    lua_rawgeti(L, -1, static_cast<lua_Integer>(*part + 1));
    return {1};
}

template <PartKind kKind>
Pushed named(lua_State* L, LevelObject* self, std::string_view name) {
    return push_named(L, self, kKind, name);
}

Pushed bodies(lua_State* L, LevelObject* self) {
    if (!push_build(L, 1)) call_error(L, "the level is not built; level:build(world) does");
    const int objects = lua_gettop(L);
    lua_newtable(L);
    lua_Integer count = 0;
    for (std::size_t i = 0; i < self->level.parts.size(); ++i) {
        if (self->level.parts[i].kind != PartKind::Body) continue;
        lua_rawgeti(L, objects, static_cast<lua_Integer>(i + 1));
        if (living_body_at(L, -1)) {
            lua_rawseti(L, -2, ++count);
        } else {
            lua_pop(L, 1);
        }
    }
    return {1};
}

std::string_view name(LevelObject* self) {
    return self->level.name;
}
std::string_view path(LevelObject* self) {
    return self->level.path;
}

double number_in(const Value& table, std::string_view field, double fallback = 0) {
    const Value* value = table.find(field);
    return value == nullptr || !value->is_number() ? fallback : value->number();
}

std::tuple<double, double, double> spawn(lua_State* L, LevelObject* self, std::string_view wanted) {
    std::vector<std::string> names;
    if (const Value* list = self->level.section("spawns")) {
        for (const Entry& entry : list->entries()) {
            const Value& place = entry.value;
            names.push_back(place.find("name")->text());
            if (names.back() == wanted)
                return {number_in(place, "x"), number_in(place, "y"), number_in(place, "angle")};
        }
    }
    call_error(L,
               "name is " + quote_text(wanted) + ": the level has no such spawn" + suggestion(wanted, names));
}

Pushed push_section(lua_State* L, LevelObject* self, std::initializer_list<const char*> fields,
                    const char* section) {
    const Value* table = self->level.section(section);
    if (table == nullptr) return lua_pushnil(L), Pushed{1};
    for (const char* field : fields) lua_pushnumber(L, number_in(*table, field));
    return {static_cast<int>(fields.size())};
}
Pushed camera(lua_State* L, LevelObject* self) {
    return push_section(L, self, {"x", "y", "height"}, "camera");
}
Pushed bounds(lua_State* L, LevelObject* self) {
    return push_section(L, self, {"left", "bottom", "right", "top"}, "bounds");
}

Pushed data(lua_State* L, LevelObject* self) {
    const Value* table = self->level.section("data");
    if (table == nullptr) {
        lua_newtable(L);
    } else {
        push_value(L, *table);
    }
    return {1};
}
Pushed table(lua_State* L, LevelObject* self) {
    push_value(L, self->level.table);
    return {1};
}
Pushed files(lua_State* L, LevelObject* self) {
    lua_newtable(L);
    lua_Integer count = 0;
    for (const std::string& file : self->level.files) {
        lua_pushlstring(L, file.data(), file.size());
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}

// ---- Drawing

void load_images(lua_State* L, LevelObject& self) {
    self.images.clear();
    self.has_images = true;
    const Value* list = self.level.section("decorations");
    if (list == nullptr) return;
    engine::Renderer& renderer = context_of(L).services.renderer;
    for (const Entry& entry : list->entries()) {
        const Value& item = entry.value;
        const engine::TextureId texture =
            value_or_raise(L, renderer.load_texture(item.find("image")->text()));
        const engine::Size size = renderer.texture_size(texture);
        const auto width = static_cast<float>(size.width);
        const auto height = static_cast<float>(size.height);
        const double scale = number_in(item, "width") / size.width;
        const double scale_y = number_in(item, "height", scale * size.height) / size.height;
        const Value* layer = item.find("layer");
        self.images.push_back({texture,
                               {.position = {static_cast<float>(number_in(item, "x")),
                                             static_cast<float>(number_in(item, "y"))},
                                .rotation_rad = static_cast<float>(number_in(item, "angle")),
                                .scale = {static_cast<float>(scale), static_cast<float>(scale_y)},
                                .origin = {width / 2, height / 2},
                                .tint = {1, 1, 1, static_cast<float>(number_in(item, "opacity", 1))}},
                               layer != nullptr && layer->text() == "front"});
    }
}

void draw(lua_State* L, LevelObject* self, std::optional<std::string_view> layer) {
    if (layer && *layer != "back" && *layer != "front")
        call_error(L, "layer is " + quote_text(*layer) + "; expected \"back\" or \"front\"");
    engine::Renderer& renderer = drawing_context(L).services.renderer;
    if (!self->has_images) load_images(L, *self);
    const float upright = renderer.is_y_up() ? -1.0f : 1.0f;
    for (const DecorationImage& image : self->images) {
        if (image.is_front != (layer == "front")) continue;
        engine::ImageDraw sprite = image.draw;
        sprite.scale.y *= upright;
        renderer.draw_image(image.texture, sprite);
    }
}

constexpr std::array<std::string_view, 1> kReturnsLevel = {"Level"};
constexpr std::array<std::string_view, 1> kReturnsTable = {"table"};
constexpr std::array<std::string_view, 1> kReturnsNames = {"string[]"};
constexpr std::array<std::string_view, 1> kReturnsBody = {"Body"};
constexpr std::array<std::string_view, 1> kReturnsJoint = {"Joint"};
constexpr std::array<std::string_view, 1> kReturnsPrefab = {"Prefab"};
constexpr std::array<std::string_view, 3> kReturnsCamera = {"number?", "number", "number"};
constexpr std::array<std::string_view, 4> kReturnsBounds = {"number?", "number", "number", "number"};

constexpr Function kModuleFunctions[] = {
    function_pushing<&load>(
        "load", "path, fields = {}", "level", kReturnsLevel,
        "Reads a level, or a map of Tiled, as data: nothing in it is run. Faults are an error with a line "
        "for "
        "each, such as `levels/one.lua:14:9: bodies[3].radius = -1: must be above 0 and at most 1000000`.",
        &kLoadFields),
    function_pushing<&check>("check", "path, fields = {}", "faults", kReturnsNames,
                             "A list of all that is wrong with a level; empty when it is good.",
                             &kLoadFields),
};
constexpr Function kMethods[] = {
    function<&build>("build", "world", "",
                     "Makes its bodies, triggers, prefabs and joints, in the order of the file. What it made "
                     "before goes: calling it again starts the level anew."),
    function<&clear>("clear", "", "", "Destroys what `build` made and still lives."),
    function<&is_built>("is_built", "", "built", ""),
    function<&reload>(
        "reload", "", "kept, made",
        "Reads the file again. Parts that say what they said keep their state, the others are "
        "made anew, and with a joint the bodies that it holds. A level that is not built is only read: "
        "0, 0. With a fault in the file nothing changes but that the error is raised."),
    function_pushing<&named<PartKind::Body>>(
        "body", "name", "body", kReturnsBody,
        "An unknown name is an error. The body may be destroyed by now."),
    function_pushing<&named<PartKind::Trigger>>("trigger", "name", "body", kReturnsBody,
                                                "The static body whose sensor it is: `sensor` in "
                                                "`world:sensor_events()`."),
    function_pushing<&named<PartKind::Prefab>>("prefab", "name", "prefab", kReturnsPrefab, ""),
    function_pushing<&named<PartKind::Joint>>("joint", "name", "joint", kReturnsJoint, ""),
    function_pushing<&bodies>("bodies", "", "bodies", kReturnsTable,
                              "A new list of those of `bodies` that live, in the order of the file."),
    function<&spawn>("spawn", "name", "x [m], y [m], angle [rad]", "A place by its name."),
    function_pushing<&camera>("camera", "", "x [m], y [m], height [m]", kReturnsCamera,
                              "nil when the level has none."),
    function_pushing<&bounds>("bounds", "", "left [m], bottom [m], right [m], top [m]", kReturnsBounds,
                              "nil when the level has none."),
    function<&name>("name", "", "name", "What players call it; may be empty."),
    function<&path>("path", "", "path", ""),
    function_pushing<&data>("data", "", "data", kReturnsTable,
                            "A new table: the level's `data`, or an empty one."),
    function_pushing<&table>("table", "", "table", kReturnsTable, "A new table with all that the file says."),
    function_pushing<&files>("files", "", "paths", kReturnsNames,
                             "The level's file and those that it includes."),
    function<&draw>("draw", "layer = \"back\"", "",
                    "Draws the decorations of a layer, \"back\" or \"front\"; only in `cairn.draw`, under a "
                    "camera."),
};

}  // namespace

std::vector<std::string> faults_of_level(lua_State* L, const std::string& path, const TiledImport& import) {
    return read_and_try(L, path, import).faults;
}

namespace {

/// (level) Reloads it and tells the game.
int reload_one(lua_State* L) {
    push_function(L, kLevelMethods, "reload");
    lua_pushvalue(L, 1);
    lua_call(L, 1, 0);
    if (push_callback(L, "level_reloaded")) {
        lua_pushvalue(L, 1);
        lua_call(L, 1, 0);
    }
    return 0;
}

}  // namespace

std::optional<ScriptError> reload_levels(lua_State* L, const std::set<std::string>& changed,
                                         std::set<std::string>& taken) {
    const int top = lua_gettop(L);
    push_living_levels(L);
    for (lua_Integer i = 0; i < context_of(L).levels_loaded; ++i) {
        lua_settop(L, top + 1);
        lua_rawgeti(L, top + 1, i);
        const auto* object = object_at<LevelObject>(L, -1);
        if (object == nullptr) continue;
        bool has_changed = false;
        for (const std::string& file : object->level.files) {
            if (!changed.contains(file)) continue;
            has_changed = true;
            taken.insert(file);
        }
        if (!has_changed) continue;
        lua_pushcfunction(L, reload_one);
        lua_insert(L, -2);
        if (auto error = protected_call(L, 1, 0)) {
            lua_settop(L, top);
            return error;
        }
    }
    lua_settop(L, top);
    return std::nullopt;
}

int finalize_level(lua_State* L) {
    object_at<LevelObject>(L, 1)->~LevelObject();
    return 0;
}

const Module kLevelModule = {"cairn.level",
                             "Levels as data. [The format of levels](levels.md) says what a file may hold.",
                             kModuleFunctions};
const Module kLevelMethods = {"Level", "What a level file says, and what was made of it in a world.",
                              kMethods, true};

}  // namespace cairn::scripting
