// How a world is doing, for Lua: `world:report()`.
#pragma once

#include "bind/function.h"
#include "bind/physics_objects.h"

namespace cairn::scripting {

Pushed report(lua_State* L, WorldRef self);
void set_profiling(WorldRef self, bool enabled);

}  // namespace cairn::scripting
