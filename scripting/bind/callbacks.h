// The functions of a game that Cairn calls by their names, and the search for those that it never will
// because their names are slips: a misspelt callback is no error in Lua, it is just never called.
// Invariant: callbacks stand in a table of their own behind `cairn`, so that each assignment passes
// set_member of `guard_members`, and what is no function is told with the place of the assignment.
#pragma once

#include <lua.hpp>
#include <span>
#include <string>
#include <string_view>

namespace cairn::scripting {

/// What the game may put into `cairn`; scenes have them too.
struct Callback {
    const char* name;
    const char* parameters;  ///< "key, is_repeat"
    const char* doc;         ///< when it is called, or what it is told
};
std::span<const Callback> callbacks();
bool is_callback(std::string_view name);

/// Makes the table of callbacks, or empties it.
void clear_callbacks(lua_State* L);
/// Pushes the table of callbacks, by name.
void push_callbacks(lua_State* L);
/// Pushes a callback of `cairn`; false when the game has none, with nothing pushed.
bool push_callback(lua_State* L, std::string_view name);

/// The callback that was meant by a name that is none; empty when the name is not near any.
std::string_view meant_callback(std::string_view name);

/// Logs a warning for each function of the table at an index whose name is nearly that of a callback, and for
/// each function of the API that the script has replaced. Once for each name. `owner` is what the table is
/// called: "cairn.", "the scene's ".
void warn_of_slips(lua_State* L, int table, const std::string& owner);

}  // namespace cairn::scripting
