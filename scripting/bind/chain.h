// Chains as Lua values: how worlds and bodies get them.
#pragma once

#include <lua.hpp>

#include "bind/function.h"
#include "bind/physics_objects.h"

namespace cairn::scripting {

/// `body:add_chain`.
Pushed add_chain(lua_State* L, BodyRef self, TableArgument description);
/// `world:add_chain`: a body with a chain.
Pushed add_chain_body(lua_State* L, WorldRef self, TableArgument description);

}  // namespace cairn::scripting
