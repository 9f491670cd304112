// What the program needs of `require`.
#pragma once

#include <lua.hpp>

namespace cairn::scripting {

/// `require` runs every module anew from now on.
void forget_modules(lua_State* L);

}  // namespace cairn::scripting
