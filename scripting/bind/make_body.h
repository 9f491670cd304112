// Bodies from tables: one with its shape, and many at once.
#pragma once

#include "bind/physics_fields.h"
#include "bind/physics_objects.h"

namespace cairn::scripting {

/// Makes the body that a reader's table describes, with its shape, and pushes it. The fields are those of
/// fields_of_world_add(kind), and whatever else the reader knows.
void push_described_body(lua_State* L, WorldRef world, const FieldReader& reader, GeometryKind kind);

/// The same without a shape; the fields are kNewBodyFields.
void push_bare_body(lua_State* L, WorldRef world, const FieldReader& reader);

/// `world:add_bodies` and `world:destroy_bodies`: all or, with an error, none.
Pushed add_bodies(lua_State* L, WorldRef self, TableArgument descriptions);
void destroy_bodies(lua_State* L, WorldRef self, TableArgument bodies);

}  // namespace cairn::scripting
