// Levels as Lua values, and what the program needs of them without a script.
#pragma once

#include <lua.hpp>
#include <string>
#include <vector>

#include "level/reader.h"

namespace cairn::scripting {

/// Everything that is wrong with a level file, also what shows only when it is built: each fault one text.
std::vector<std::string> faults_of_level(lua_State* L, const std::string& path,
                                         const TiledImport& import = {});

}  // namespace cairn::scripting
