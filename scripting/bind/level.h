// Levels as Lua values, and what the program needs of them without a script.
#pragma once

#include <lua.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "level/reader.h"
#include "lua/errors.h"

namespace cairn::scripting {

/// Everything that is wrong with a level file, also what shows only when it is built: each fault one text.
std::vector<std::string> faults_of_level(lua_State* L, const std::string& path,
                                         const TiledImport& import = {});

/// Reloads the levels of the state that were read from one of the files, and tells cairn.level_reloaded of
/// each. `taken` receives the files of levels among `changed`. With a fault nothing more is reloaded.
std::optional<ScriptError> reload_levels(lua_State* L, const std::set<std::string>& changed,
                                         std::set<std::string>& taken);

}  // namespace cairn::scripting
