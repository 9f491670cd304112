// Cutting and breaking bodies from Lua. A piece is a new body; its data and that of its shapes are copies,
// field by field, of those of what it came from.
#pragma once

#include "bind/fields.h"
#include "bind/function.h"
#include "bind/physics_objects.h"
#include "bind/query_filter.h"

namespace cairn::scripting {

/// Of body:fracture, and with more of body:set_breakable.
extern const FieldSet kFractureFields;
extern const FieldSet kBreakableFields;

// Methods of bodies.

Pushed cut(lua_State* L, BodyRef self, double x1, double y1, double x2, double y2);
Pushed fracture(lua_State* L, BodyRef self, TableArgument fields);
physics::Result<void> set_breakable(lua_State* L, BodyRef self, TableArgument fields);
physics::Result<void> clear_breakable(BodyRef self);
bool is_breakable(lua_State* L, BodyRef self);
Pushed breakable(lua_State* L, BodyRef self);

// Of worlds.

Pushed cuts_along(lua_State* L, WorldRef self, double x1, double y1, double x2, double y2, Filter filter,
                  Ignored ignored);
/// After a step: Lua values for the pieces that it made.
void adopt_pieces(lua_State* L, WorldRef world);

}  // namespace cairn::scripting
