// Snapshots of worlds from Lua: tables with the bytes, to be kept or saved, and the values of the bodies.
#pragma once

#include "bind/function.h"
#include "bind/physics_objects.h"

namespace cairn::scripting {

Pushed snapshot(lua_State* L, WorldRef self);
/// Of such a table, or of the bytes alone.
void restore(lua_State* L, WorldRef self, AnyArgument snapshot);

/// Behind a restore: the values of the bodies that there are now. `values` is where the list of those that
/// the snapshot was taken with stands, or 0.
void adopt_state(lua_State* L, WorldRef self, int values);

}  // namespace cairn::scripting
