// cairn.physics: what makes worlds, and what stands beside them.
#include <cairn/physics/features.h>

#include "bind/context.h"
#include "bind/materials.h"
#include "bind/modules.h"
#include "bind/mover.h"
#include "bind/physics_fields.h"
#include "bind/physics_objects.h"
#include "bind/recording.h"
#include "bind/snapshot.h"
#include "bind/transforms.h"
#include "bind/world_queries.h"
#include "data/nearest.h"
#include "data/table_writer.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

/// More living worlds than any game needs are worlds that somebody forgot to destroy.
constexpr std::size_t kMaxWorlds = 64;

Pushed new_world(lua_State* L, std::optional<TableArgument> description) {
    Context& context = context_of(L);
    if (context.worlds.size() >= kMaxWorlds) {
        call_error(L, "there are " + std::to_string(kMaxWorlds) +
                          " worlds already; free those that are no longer used with world:destroy()");
    }
    if (!description) lua_newtable(L);
    const FieldReader reader(L, description ? description->index : -1, kWorldFields);
    auto created = physics::World::create(read_world_def(reader));
    if (!created) call_error(L, created.error());
    auto& object = new_object<WorldObject>(L, kPairFilterValue, std::nullopt, 0, 0);
    object.world.emplace(*std::move(created));
    for (int table = 1; table <= kWorldTableCount; ++table) {
        lua_newtable(L);
        lua_setiuservalue(L, -2, table);
    }
    lua_getiuservalue(L, -1, static_cast<int>(WorldTable::Known));
    lua_newtable(L);
    lua_pushliteral(L, "v");
    lua_setfield(L, -2, "__mode");
    lua_setmetatable(L, -2);
    lua_pop(L, 1);
    lua_pushvalue(L, -1);
    object.reference = luaL_ref(L, LUA_REGISTRYINDEX);
    context.worlds.push_back(&object);
    return {1};
}

bool is_built_in(lua_State* L, std::string_view feature) {
    std::vector<std::string> names;
    for (const physics::Feature candidate : physics::kFeatures) {
        if (physics::name(candidate) == feature) return physics::is_built_in(candidate);
        names.emplace_back(physics::name(candidate));
    }
    call_error(L, "feature is " + quote_text(feature) + ": no such feature" + suggestion(feature, names));
}

constexpr std::array<std::string_view, 1> kReturnsWorld = {"World"};
constexpr std::array<std::string_view, 1> kReturnsTransforms = {"Transforms"};
constexpr std::array<std::string_view, 1> kReturnsMover = {"Mover"};
constexpr std::array<std::string_view, 1> kReturnsRecording = {"Recording"};
constexpr std::array<std::string_view, 1> kReturnsBytes = {"string"};
constexpr std::array<std::string_view, 1> kReturnsTable = {"table"};

constexpr Function kPhysicsFunctions[] = {
    function_pushing<&new_world>("new_world", "fields = {}", "world", kReturnsWorld,
                                 "Makes an empty world. It lives until `world:destroy()`.", &kWorldFields),
    function<&define_material>(
        "define_material", "name, fields", "",
        "Gives what shapes are made of a name: after `cairn.physics.define_material(\"wood\", { density = "
        "0.7, "
        "friction = 0.6 })` the field `material = \"wood\"` stands for these, wherever a shape is made or "
        "its "
        "material set. Fields that stand beside it go before. Where two shapes touch their values mix as "
        "ever. "
        "Naming it again is for shapes that are made from then on. Levels have materials of their own; a "
        "file of "
        "materials can be included by levels and named here: `for name, fields in "
        "pairs(require(\"materials\").materials) do cairn.physics.define_material(name, fields) end`.",
        &kMatterFields),
    function_pushing<&materials>("materials", "", "materials", kReturnsTable,
                                 "A new table of those that have names: name -> all their fields."),
    function_pushing<&new_transforms>("new_transforms", "", "transforms", kReturnsTransforms,
                                      "Makes an empty list of places for `world:read_transforms`."),
    function_pushing<&new_recording>("new_recording", "fields = {}", "recording", kReturnsRecording,
                                     "Makes an empty recording, for the states of a world.",
                                     &kRecordingFields),
    function_pushing<&make_delta>("make_delta", "base, target", "delta", kReturnsBytes,
                                  "What turns the bytes of one snapshot into those of another, as a string: "
                                  "small when little differs, as "
                                  "from step to step. To be sent or saved."),
    function_pushing<&apply_delta>(
        "apply_delta", "base, delta", "target", kReturnsBytes,
        "The bytes of a snapshot from those of the one before it and what `make_delta` gave; "
        "an error when `base` is another one."),
    function<&is_built_in>(
        "is_built_in", "feature", "built_in",
        "Whether this build of Cairn has a part of the physics that can be left out: \"joints\", "
        "\"sensors\", \"chains\", \"fracture\" and so on. Using one that is left out is an error "
        "that names it."),
    function<&solve_planes>(
        "solve_planes", "dx [m], dy [m], planes, gap [m]", "dx [m], dy [m]",
        "The way nearest to a wanted one that stays `gap` in front of every plane that "
        "`world:collision_planes` told: "
        "for characters of your own. Where there is none, planes of dynamic bodies give way first."),
    function_pushing<&new_mover>("new_mover", "fields = {}", "mover", kReturnsMover,
                                 "Makes a character that walks.", &kMoverFields),
};

}  // namespace

const Module kPhysicsModule = {
    "cairn.physics",
    "Worlds of rigid bodies. Metres, kilograms, seconds, radians; y points up. No world is ever locked: "
    "bodies may be made, "
    "moved and destroyed at any time, also while events are read.",
    kPhysicsFunctions,
};

}  // namespace cairn::scripting
