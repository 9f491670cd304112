// Reads without calling anything of the script: no metamethod runs, and nothing changes.
#include "debug/lua_values.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "bind/callbacks.h"
#include "bind/fields.h"
#include "lua/errors.h"

namespace cairn::scripting {
namespace {

constexpr int kDepth = 3;
constexpr std::size_t kMostMembers = 200;

/// Globals that each state begins with.
constexpr std::array<std::string_view, 10> kLibraries{"_G",    "cairn",  "coroutine", "math", "os",
                                                      "debug", "string", "table",     "utf8", "_VERSION"};

std::string name_of_key(lua_State* L, int index) {
    if (lua_type(L, index) == LUA_TSTRING) return lua_tostring(L, index);
    return '[' + describe_value(L, index) + ']';
}

/// The value on top of the stack, which stays.
LuaValue read_value(lua_State* L, std::string name, int depth) {
    LuaValue value{.name = std::move(name), .text = describe_value(L, -1)};
    if (!lua_istable(L, -1)) return value;
    const lua_Unsigned length = lua_rawlen(L, -1);
    if (length > 0) value.text = "a list of " + std::to_string(length);
    if (depth == 0) {
        value.is_cut = true;
        return value;
    }
    luaL_checkstack(L, 4, "values");
    std::map<std::pair<lua_Integer, std::string>, LuaValue> members;  // members of lists in their order
    for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
        if (lua_isfunction(L, -1)) continue;
        if (members.size() == kMostMembers) {
            value.is_cut = true;
            lua_pop(L, 2);
            break;
        }
        const std::string member = name_of_key(L, -2);
        const lua_Integer place = lua_isinteger(L, -2) ? lua_tointeger(L, -2) : 0;
        members.emplace(std::pair(place, member), read_value(L, member, depth - 1));
    }
    for (auto& [key, member] : members) value.members.push_back(std::move(member));
    return value;
}

using Values = std::map<std::string, LuaValue>;

void read_globals(lua_State* L, Values& values) {
    lua_pushglobaltable(L);
    for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
        const std::string name = name_of_key(L, -2);
        const bool is_own = !lua_isfunction(L, -1) &&
                            std::find(kLibraries.begin(), kLibraries.end(), name) == kLibraries.end();
        if (is_own) values.insert_or_assign(name, read_value(L, name, kDepth));
    }
    lua_pop(L, 1);
}

/// Of the functions in the table `cairn`, and of the functions which those use.
void read_locals(lua_State* L, Values& values, int depth) {
    for (int i = 1;; ++i) {
        const char* name = lua_getupvalue(L, -1, i);
        if (name == nullptr) return;
        if (lua_isfunction(L, -1) && !lua_iscfunction(L, -1)) {
            if (depth > 0) read_locals(L, values, depth - 1);
        } else if (!lua_isfunction(L, -1) && std::string_view(name) != "_ENV" && *name != '\0') {
            if (!values.contains(name)) values.emplace(name, read_value(L, name, kDepth));
        }
        lua_pop(L, 1);
    }
}

int read_all(lua_State* L) {
    auto& values = *static_cast<Values*>(lua_touserdata(L, 1));
    read_globals(L, values);
    const auto read_functions = [&] {  // of the table on top of the stack
        constexpr int kCallsDeep = 2;
        for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1))
            if (lua_isfunction(L, -1) && !lua_iscfunction(L, -1)) read_locals(L, values, kCallsDeep);
    };
    push_callbacks(L);
    read_functions();
    lua_getglobal(L, "cairn");
    if (lua_istable(L, -1)) read_functions();
    return 0;
}

}  // namespace

std::vector<LuaValue> values_of_game(lua_State* L) {
    Values values;
    lua_pushcfunction(L, read_all);
    lua_pushlightuserdata(L, &values);
    if (protected_call(L, 1, 0)) return {};
    std::vector<LuaValue> list;
    for (auto& [name, value] : values) list.push_back(std::move(value));
    return list;
}

}  // namespace cairn::scripting
