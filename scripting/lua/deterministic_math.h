// math functions that give the same bits on every machine.
#pragma once

#include <lua.hpp>

namespace cairn::scripting {

/// Replaces sin, cos, tan, asin, acos, atan, exp and log of the table on top of the stack, and adds pow. The
/// C library's functions differ in the last bit between versions and processors, which a replay would not
/// survive.
void install_deterministic_math(lua_State* L);

}  // namespace cairn::scripting
