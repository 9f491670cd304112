// Running a game's scripts again in the state that they have made. What the game wants to keep goes from
// cairn.before_reload to cairn.after_reload; its callbacks, modules, timers, tweens and scenes are those of
// the new scripts alone.
#include <utility>

#include <cairn/engine/log.h>

#include "bind/callbacks.h"
#include "bind/core.h"
#include "bind/fields.h"
#include "bridge/game.h"

namespace cairn::scripting {
namespace {

/// The callbacks, and what functions else scripts have put into `cairn`, a table at an index; the API's own
/// are in C.
void forget_functions(lua_State* L, int table) {
    clear_callbacks(L);
    lua_pushnil(L);
    while (lua_next(L, table) != 0) {
        if (lua_isfunction(L, -1) && lua_iscfunction(L, -1) == 0) {
            lua_pushvalue(L, -2);
            lua_pushnil(L);
            lua_rawset(L, table);  // removing during a walk is allowed
        }
        lua_pop(L, 1);
    }
}

void unref_all(lua_State* L, Context& context) {
    for (const int reference : context.timers.take_all()) luaL_unref(L, LUA_REGISTRYINDEX, reference);
    for (const auto& [number, tween] : context.tweens.running) {
        luaL_unref(L, LUA_REGISTRYINDEX, tween.target);
        luaL_unref(L, LUA_REGISTRYINDEX, tween.done);
    }
    context.tweens.running.clear();
    for (const Scene& scene : context.scenes) luaL_unref(L, LUA_REGISTRYINDEX, scene.reference);
    context.scenes.clear();
    luaL_unref(L, LUA_REGISTRYINDEX, context.listener);
    context.listener = LUA_NOREF;
}

}  // namespace

bool Game::can_reload() const {
    if (waits_for_scripts()) return true;
    lua_State* L = state_.get();
    const bool can = push_callback(L, "before_reload");
    if (can) lua_pop(L, 1);
    return can;
}

Game::Reloaded Game::reload(const std::string& main_path, const std::vector<std::string>& arguments) {
    lua_State* L = state_.get();
    const int top = lua_gettop(L);
    // The scripts of now may be ones that failed before they had what was kept: theirs is not asked for.
    if (!waits_for_scripts()) {
        if (!push_callback(L, "before_reload")) return {load(main_path, arguments)};
        if (auto error = protected_call(L, 0, 1)) {
            lua_settop(L, top);
            return {std::move(error), true};
        }
        kept_ = luaL_ref(L, LUA_REGISTRYINDEX);  // of nil too
    }
    lua_rawgeti(L, LUA_REGISTRYINDEX, cairn_);
    forget_functions(L, lua_gettop(L));
    forget_modules(L);
    unref_all(L, context_);
    auto error = run_file(main_path);
    if (!error) {
        hint_at_slips();
        if (push_callback(L, "after_reload")) {
            lua_rawgeti(L, LUA_REGISTRYINDEX, kept_);
            error = protected_call(L, 1, 0);
        } else {
            lua_rawgeti(L, LUA_REGISTRYINDEX, kept_);
            if (!lua_isnil(L, -1)) {
                engine::log(engine::LogLevel::Warning,
                            "what cairn.before_reload returned, " + describe_value(L, -1) +
                                ", is lost: the new scripts have no cairn.after_reload(kept)");
            }
            error = call_load(arguments);
        }
    }
    if (!error) luaL_unref(L, LUA_REGISTRYINDEX, std::exchange(kept_, LUA_NOREF));
    lua_settop(L, top);
    return {std::move(error)};
}

}  // namespace cairn::scripting
