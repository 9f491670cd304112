// Snapshots of worlds from Lua: tables with the bytes, to be kept or saved, and the values of the bodies.
#pragma once

#include "bind/function.h"
#include "bind/physics_objects.h"

namespace cairn::scripting {

Pushed snapshot(lua_State* L, WorldRef self);
/// Of such a table, or of the bytes alone.
void restore(lua_State* L, WorldRef self, AnyArgument snapshot);

}  // namespace cairn::scripting
