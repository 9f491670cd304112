// The libraries that a script may use. Left out: io, os, package, debug and every function that loads
// bytecode, reads files, shows addresses or drives the garbage collector.
#pragma once

#include <lua.hpp>

namespace cairn::scripting {

void open_safe_libraries(lua_State* L);

/// Pushes what `tostring` gives: as Lua's own, but without addresses, which differ from run to run (a replay
/// must not see them) and help an attacker.
void push_text(lua_State* L, int index);

}  // namespace cairn::scripting
