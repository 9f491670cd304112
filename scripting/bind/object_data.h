// `shape.data`, `joint.data`, `chain.data`: a table of the script's own, kept as long as what it belongs to.
// Bodies, which are asked far more often, have theirs without a function (physics_objects.cpp).
#pragma once

#include <lua.hpp>

#include "bind/module.h"
#include "bind/object.h"

namespace cairn::scripting {

/// The user value of such objects that holds the table; made when it is first asked for.
inline constexpr int kDataValue = 2;

/// As register_type, for objects with `data`. They are made with at least kDataValue user values.
void register_type_with_data(lua_State* L, ObjectTag tag, const Module& methods,
                             lua_CFunction finalize = nullptr);

/// Makes the table on top of the stack, which is popped, the data of the object below it.
void set_data(lua_State* L);

}  // namespace cairn::scripting
