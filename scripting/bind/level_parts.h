// Makes the parts of a level through the same functions that scripts call, so that it can do what they can,
// and so that their checks are its checks. What was made stands in a list of Lua: part number, from 1 ->
// Body, Joint or Prefab.
#pragma once

#include <cstddef>
#include <lua.hpp>
#include <string>
#include <vector>

#include "level/reader.h"

namespace cairn::scripting {

/// Makes a part in the world at a stack index and keeps it in the list at another. Gives what went wrong,
/// each fault with its place; of a body's several shapes each may have one, and the body is kept without
/// those.
std::vector<std::string> make_part(lua_State* L, const Level& level, std::size_t number, int world,
                                   int objects);

/// Destroys what lives of all parts, and empties the list. The world must live.
void unmake_parts(lua_State* L, const Level& level, int objects);

}  // namespace cairn::scripting
