// What shows only when a level is built. Invariant: nothing is told that another value of a faulty field,
// which is told already, could put right.
#pragma once

#include <lua.hpp>
#include <string>
#include <vector>

#include "level/reader.h"

namespace cairn::scripting {

/// Faults found by building in a world for trying out: the parts that are not known to be faulty, the forms
/// of shapes that are faulty elsewhere, and the rules over several fields where those fields are sound.
std::vector<std::string> faults_of_building(lua_State* L, const Level& level);

}  // namespace cairn::scripting
