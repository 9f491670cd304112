// Between Lua values on the stack and plain data.
#pragma once

#include <lua.hpp>

#include <cairn/engine/result.h>

#include "data/value.h"

namespace cairn::scripting {

/// Copies the value at an index. Functions, objects and other things that are no data, keys that are neither
/// strings nor integers, and tables within themselves are errors that name the place ("t.pieces[3]"). Entries
/// are in sorted order.
engine::Result<Value> to_value(lua_State* L, int index);

void push_value(lua_State* L, const Value& value);

}  // namespace cairn::scripting
