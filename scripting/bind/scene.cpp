// cairn.scene: a stack of scenes, of which the top one gets the callbacks.
#include "bind/callbacks.h"
#include "bind/context.h"
#include "bind/fields.h"
#include "bind/modules.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

/// Deeper than any menu over a menu; a push without its pop meets it.
constexpr std::size_t kMaxScenes = 64;

[[noreturn]] void refuse_method(lua_State* L, const char* name, int value) {
    call_error(
        L, std::string("the scene's ") + name + " is " + describe_value(L, value) + "; expected a function");
}

/// Told where the scene is given, because a call by the program has no place in a script.
void check_methods(lua_State* L, int scene) {
    const auto check = [&](const char* name) {
        lua_getfield(L, scene, name);
        if (!lua_isnil(L, -1) && !lua_isfunction(L, -1)) refuse_method(L, name, -1);
        lua_pop(L, 1);
    };
    for (const char* name : {"enter", "leave", "pause", "resume"}) check(name);
    for (const Callback& callback : callbacks())
        if (std::string_view(callback.name) != "load") check(callback.name);
}

/// Calls scene:name(...) with the values from `first` to the top of the stack, if the scene has such a
/// method. The values stay.
void call_method(lua_State* L, int scene, const char* name, int first, int count) {
    lua_getfield(L, scene, name);
    if (lua_isnil(L, -1)) return lua_pop(L, 1);
    if (!lua_isfunction(L, -1)) refuse_method(L, name, -1);  // since it was given
    lua_pushvalue(L, scene);
    luaL_checkstack(L, count, "arguments of a scene");
    for (int i = 0; i < count; ++i) lua_pushvalue(L, first + i);
    lua_call(L, 1 + count, 0);
}

/// Pushes the top scene and gives its place, or 0 when there is none.
int push_top(lua_State* L) {
    const std::vector<Scene>& scenes = context_of(L).scenes;
    if (scenes.empty()) return 0;
    lua_rawgeti(L, LUA_REGISTRYINDEX, scenes.back().reference);
    return lua_gettop(L);
}

void check_not_there(lua_State* L, int scene) {
    for (const Scene& other : context_of(L).scenes) {
        lua_rawgeti(L, LUA_REGISTRYINDEX, other.reference);
        if (lua_rawequal(L, -1, scene) != 0) call_error(L, "that scene is on the stack already");
        lua_pop(L, 1);
    }
}

void add(lua_State* L, int scene) {
    warn_of_slips(L, scene, "the scene's ");
    luaL_where(L, 1);
    std::string place = lua_tostring(L, -1);
    lua_pop(L, 1);
    lua_pushvalue(L, scene);
    context_of(L).scenes.push_back({luaL_ref(L, LUA_REGISTRYINDEX), std::move(place)});
}

/// Takes the top scene off the stack and pushes it.
int take_top(lua_State* L) {
    std::vector<Scene>& scenes = context_of(L).scenes;
    const int place = push_top(L);
    luaL_unref(L, LUA_REGISTRYINDEX, scenes.back().reference);
    scenes.pop_back();
    return place;
}

/// __close of the table that stands for an `enter` that runs: its field is the scene. One that did not enter
/// does not stay, or every picture would meet it half made.
int end_enter(lua_State* L) {
    if (lua_isnil(L, 2)) return 0;  // no error
    lua_settop(L, 1);
    lua_rawgeti(L, 1, 1);
    std::vector<Scene>& scenes = context_of(L).scenes;
    for (auto place = scenes.begin(); place != scenes.end(); ++place) {
        lua_rawgeti(L, LUA_REGISTRYINDEX, place->reference);
        const bool is_it = lua_rawequal(L, -1, 2) != 0;
        lua_pop(L, 1);
        if (!is_it) continue;
        luaL_unref(L, LUA_REGISTRYINDEX, place->reference);
        scenes.erase(place);
        break;
    }
    return 0;
}

/// Puts the scene on top and calls its `enter`.
void enter(lua_State* L, int scene, const FurtherArguments& more) {
    lua_createtable(L, 1, 0);
    lua_pushvalue(L, scene);
    lua_rawseti(L, -2, 1);
    lua_createtable(L, 0, 1);
    lua_pushcfunction(L, end_enter);
    lua_setfield(L, -2, "__close");
    lua_setmetatable(L, -2);
    const int entering = lua_gettop(L);
    lua_toclose(L, entering);
    add(L, scene);
    call_method(L, scene, "enter", more.first, more.count);
    lua_closeslot(L, entering);
}

void push(lua_State* L, TableArgument scene, FurtherArguments more) {
    check_not_there(L, scene.index);
    check_methods(L, scene.index);
    if (context_of(L).scenes.size() >= kMaxScenes)
        call_error(L, std::to_string(kMaxScenes) + " scenes are on the stack already; is a pop missing?");
    if (const int below = push_top(L); below != 0) call_method(L, below, "pause", 0, 0);
    enter(L, scene.index, more);
}

void pop(lua_State* L, FurtherArguments more) {
    if (context_of(L).scenes.empty()) call_error(L, "there is no scene to leave");
    call_method(L, take_top(L), "leave", 0, 0);
    if (const int below = push_top(L); below != 0) call_method(L, below, "resume", more.first, more.count);
}

void switch_to(lua_State* L, TableArgument scene, FurtherArguments more) {
    check_methods(L, scene.index);
    if (!context_of(L).scenes.empty()) call_method(L, take_top(L), "leave", 0, 0);
    check_not_there(L, scene.index);
    enter(L, scene.index, more);
}

Pushed current(lua_State* L) {
    if (push_top(L) == 0) lua_pushnil(L);
    return {1};
}

std::int64_t count(lua_State* L) {
    return static_cast<std::int64_t>(context_of(L).scenes.size());
}

constexpr std::array<std::string_view, 1> kReturnsScene = {"table?"};

constexpr Function kFunctions[] = {
    function<&push>("push", "scene, ... = nil", "",
                    "Puts a scene on top: `pause()` of the one below, then `enter(...)` of the new one."),
    function<&pop>(
        "pop", "... = nil", "",
        "Leaves the top scene: its `leave()`, then `resume(...)` of the one below, if there is one."),
    function<&switch_to>(
        "switch", "scene, ... = nil", "",
        "Puts a scene in the place of the top one: `leave()` of the old, `enter(...)` of the new."),
    function_pushing<&current>("current", "", "scene", kReturnsScene, "The top scene, or nil."),
    function<&count>("count", "", "count", "How many scenes are on the stack."),
};

}  // namespace

const Module kSceneModule = {"cairn.scene",
                             "Title, game, pause, credits: each a table with the callbacks as methods, "
                             "`function pause:key_pressed(key)`. The "
                             "scene on top of the stack gets every callback but `load`, after the function "
                             "of `cairn` with that name. One with "
                             "`overlay = true` is drawn over the scene below it, which is drawn but not "
                             "updated. A change takes effect at once; "
                             "the callback that makes it runs on to its end. A scene whose `enter` raises an "
                             "error does not stay on the stack.",
                             kFunctions};

}  // namespace cairn::scripting
