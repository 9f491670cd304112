// Characters that walk, as Lua values.
#pragma once

#include <lua.hpp>

#include "bind/fields.h"
#include "bind/function.h"

namespace cairn::scripting {

extern const FieldSet kMoverFields;

/// `cairn.physics.new_mover`.
/// `cairn.physics.solve_planes`.
std::tuple<float, float> solve_planes(lua_State* L, float dx, float dy, TableArgument planes,
                                      NotNegative gap);

Pushed new_mover(lua_State* L, std::optional<TableArgument> fields);

}  // namespace cairn::scripting
