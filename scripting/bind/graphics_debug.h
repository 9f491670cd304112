// cairn.graphics.draw_debug, as a binding.
#pragma once

#include <optional>

#include "bind/fields.h"
#include "bind/physics_objects.h"

namespace cairn::scripting {

extern const FieldSet kDebugDrawFields;

void draw_debug_world(lua_State* L, WorldRef world, std::optional<TableArgument> options);

}  // namespace cairn::scripting
