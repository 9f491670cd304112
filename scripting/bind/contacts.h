// What a world looks like inside, as Lua tables: contacts, islands, boxes of the broad phase.
#pragma once

#include "bind/physics_objects.h"

namespace cairn::scripting {

Pushed joints_of_world(lua_State* L, WorldRef self);
Pushed contacts_of_world(lua_State* L, WorldRef self);
Pushed contacts_of_body(lua_State* L, BodyRef self);
Pushed islands_of_world(lua_State* L, WorldRef self);
Pushed boxes_of_world(lua_State* L, WorldRef self);

}  // namespace cairn::scripting
