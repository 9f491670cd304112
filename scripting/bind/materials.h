// Materials by name. Invariant: a shape takes the numbers when it is made or changed; giving the name another
// meaning later does not reach it.
#pragma once

#include "bind/function.h"

namespace cairn::scripting {

/// `cairn.physics.define_material` and `cairn.physics.materials`.
void define_material(lua_State* L, std::string_view name, TableArgument fields);
Pushed materials(lua_State* L);

}  // namespace cairn::scripting
