// What a script knows at the moment, as plain text for tools: the globals that the game made, and the local
// variables that its callbacks use.
#pragma once

#include <lua.hpp>
#include <string>
#include <vector>

namespace cairn::scripting {

struct LuaValue {
    std::string name;
    std::string text;               ///< 12, "text", a table ...
    std::vector<LuaValue> members;  ///< of a table, by name; down to some depth
    bool is_cut = false;            ///< there are more members, or deeper ones
};

/// Sorted by name. Functions and what Cairn and Lua bring along are left out. Empty when memory is short.
std::vector<LuaValue> values_of_game(lua_State* L);

}  // namespace cairn::scripting
