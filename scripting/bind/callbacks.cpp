// The callbacks, and slips in their names.
#include "bind/callbacks.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include <cairn/engine/log.h>

#include "bind/context.h"
#include "bind/modules.h"
#include "data/nearest.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

constexpr Callback kCallbacks[] = {
    {"load", "args", "once, before the first frame; `args` is the list of the command line's arguments"},
    {"update", "dt",
     "once per frame of game time; `dt` is always the same, 1/60 unless `conf.lua` says otherwise"},
    {"draw", "alpha",
     "once per picture; `alpha`, 0 to 1, is how far it lies between the last two updates (`draw_world` knows "
     "it by itself)"},
    {"key_pressed", "key, is_repeat", "a key went down; names of keys: see `cairn.input.is_down`"},
    {"key_released", "key", "a key went up"},
    {"text_input", "text", "typed text, UTF-8"},
    {"mouse_pressed", "x, y, button", "logical pixels; \"left\", \"middle\", \"right\", \"x1\", \"x2\""},
    {"mouse_released", "x, y, button", "logical pixels"},
    {"mouse_moved", "x, y, dx, dy", "logical pixels, from where it was too"},
    {"wheel", "dx, dy", "the mouse's wheel, in notches; dy > 0 is away from the user"},
    {"action_pressed", "action", "an action of `cairn.input.bind`"},
    {"action_released", "action", "an action of `cairn.input.bind`"},
    {"gamepad_connected", "gamepad, name", "gamepads are numbered from 1"},
    {"gamepad_disconnected", "gamepad", "its number is free for the next"},
    {"gamepad_pressed", "gamepad, button", "buttons: see `cairn.input.is_gamepad_down`"},
    {"gamepad_released", "gamepad, button", "buttons: see `cairn.input.is_gamepad_down`"},
    {"gamepad_moved", "gamepad, axis, value", "a stick or a trigger; see `cairn.input.gamepad_axis`"},
    {"touch_pressed", "touch, x, y", "fingers are numbered from 1; the first is the left mouse button too"},
    {"touch_released", "touch, x, y", "the finger was lifted"},
    {"touch_moved", "touch, x, y, dx, dy", "logical pixels, from where it was too"},
    {"before_reload", "",
     "a script was saved; what it returns is kept for `after_reload`. See [While you "
     "work](games.md#while-you-work)"},
    {"after_reload", "kept", "instead of `load`, when a game with `before_reload` goes on with new scripts"},
    {"level_reloaded", "level", "a file of a level was saved, and the level has changed in place"},
    {"focus", "has_focus", "the window got or lost the keyboard"},
    {"window_resized", "width, height",
     "with `scaling = \"follow\"`, or in a replay of it: the picture has this logical size now"},
    {"save_state", "",
     "after each update, for going back in time with F4; see [Tools](games.md#tools-in-every-game)"},
    {"load_state", "state", "time went back; `state` is what `save_state` returned then"},
    {"quit_requested", "",
     "the window is being closed; return true to go on. SIGTERM and SIGINT call it too, and end the game "
     "whatever it returns; see [Running games](games.md#running-games)"},
};

/// "keyPressed", "KEY_PRESSED" and "keypressed" are one name.
std::string plain(std::string_view name) {
    std::string text;
    for (const char c : name) {
        if (c != '_') text += c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
    }
    return text;
}

bool is_api_function(std::string_view name) {
    const auto functions = kCoreModule.functions;
    return std::any_of(functions.begin(), functions.end(), [&](const Function& f) { return name == f.name; });
}

}  // namespace

std::span<const Callback> callbacks() {
    return kCallbacks;
}

bool is_callback(std::string_view name) {
    return std::any_of(std::begin(kCallbacks), std::end(kCallbacks),
                       [&](const Callback& callback) { return callback.name == name; });
}

namespace {
const char callbacks_key = 0;  // its address is the key in the registry
}

void clear_callbacks(lua_State* L) {
    lua_newtable(L);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &callbacks_key);
}

void push_callbacks(lua_State* L) {
    lua_rawgetp(L, LUA_REGISTRYINDEX, &callbacks_key);
}

bool push_callback(lua_State* L, std::string_view name) {
    push_callbacks(L);
    lua_pushlstring(L, name.data(), name.size());
    lua_rawget(L, -2);
    lua_remove(L, -2);
    if (lua_isfunction(L, -1)) return true;
    lua_pop(L, 1);
    return false;
}

std::string_view meant_callback(std::string_view name) {
    constexpr std::size_t kLongest = 40;  // no slip of a name that has 20
    if (name.size() > kLongest || is_callback(name)) return {};
    const std::string wanted = plain(name);
    std::string_view best;
    int best_distance = 3;
    for (const Callback& callback : kCallbacks) {
        const std::string candidate = plain(callback.name);
        const int most = candidate.size() <= 5 ? 1 : 2;  // of short names too many words are near
        const int distance = edit_distance(wanted, candidate);
        if (distance > most || distance >= best_distance) continue;
        best = callback.name;
        best_distance = distance;
    }
    return best;
}

void warn_of_slips(lua_State* L, int table, const std::string& owner) {
    table = lua_absindex(L, table);
    std::vector<std::string> hints;
    lua_pushnil(L);
    while (lua_next(L, table) != 0) {
        const bool is_own = lua_isfunction(L, -1) && lua_iscfunction(L, -1) == 0;
        lua_pop(L, 1);
        if (!is_own || lua_type(L, -1) != LUA_TSTRING) continue;
        const std::string name = lua_tostring(L, -1);
        if (is_api_function(name)) {
            if (owner == "cairn.")
                hints.push_back(owner + name + " is a function of Cairn, which the game has replaced");
        } else if (const std::string_view meant = meant_callback(name); !meant.empty()) {
            hints.push_back(owner + name + " is never called: there is no such callback; did you mean \"" +
                            std::string(meant) + "\"?");
        }
    }
    std::sort(hints.begin(), hints.end());  // the order of a table's keys differs from run to run
    for (const std::string& hint : hints) {
        if (context_of(L).hints_told.insert(hint).second) engine::log(engine::LogLevel::Warning, hint);
    }
}

}  // namespace cairn::scripting
