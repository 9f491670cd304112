// What a world went through, as a Lua value: `cairn.physics.new_recording`.
#pragma once

#include "bind/fields.h"
#include "bind/function.h"
#include "bind/physics_objects.h"

namespace cairn::scripting {

extern const FieldSet kRecordingFields;

Pushed new_recording(lua_State* L, std::optional<TableArgument> fields);
/// `cairn.physics.make_delta` and `apply_delta`.
Pushed make_delta(lua_State* L, std::string_view base, std::string_view target);
Pushed apply_delta(lua_State* L, std::string_view base, std::string_view delta);

}  // namespace cairn::scripting
