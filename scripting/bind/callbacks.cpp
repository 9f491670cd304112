// Names of callbacks.
#include "bind/callbacks.h"

#include <algorithm>
#include <array>
#include <vector>

#include <cairn/engine/log.h>

#include "bind/context.h"
#include "bind/modules.h"
#include "data/nearest.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

constexpr std::array<std::string_view, 28> kCallbacks = {"load",
                                                         "update",
                                                         "draw",
                                                         "key_pressed",
                                                         "key_released",
                                                         "text_input",
                                                         "mouse_pressed",
                                                         "mouse_released",
                                                         "mouse_moved",
                                                         "wheel",
                                                         "action_pressed",
                                                         "action_released",
                                                         "gamepad_connected",
                                                         "gamepad_disconnected",
                                                         "gamepad_pressed",
                                                         "gamepad_released",
                                                         "gamepad_moved",
                                                         "touch_pressed",
                                                         "touch_released",
                                                         "touch_moved",
                                                         "before_reload",
                                                         "after_reload",
                                                         "level_reloaded",
                                                         "focus",
                                                         "window_resized",
                                                         "save_state",
                                                         "load_state",
                                                         "quit_requested"};

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

std::span<const std::string_view> callback_names() {
    return kCallbacks;
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
    if (name.size() > kLongest || std::find(kCallbacks.begin(), kCallbacks.end(), name) != kCallbacks.end())
        return {};
    const std::string wanted = plain(name);
    std::string_view best;
    int best_distance = 3;
    for (const std::string_view callback : kCallbacks) {
        const std::string candidate = plain(callback);
        const int most = candidate.size() <= 5 ? 1 : 2;  // of short names too many words are near
        const int distance = edit_distance(wanted, candidate);
        if (distance > most || distance >= best_distance) continue;
        best = callback;
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
