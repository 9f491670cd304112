// The plain shapes of cairn.graphics, as bindings.
#pragma once

#include <string_view>

#include "bind/graphics_objects.h"

namespace cairn::scripting {

void rectangle(lua_State* L, std::string_view mode, float x, float y, float width, float height,
               std::optional<float> radius);
void circle(lua_State* L, std::string_view mode, float x, float y, float radius);
void ellipse(lua_State* L, std::string_view mode, float x, float y, float radius_x, float radius_y);
void arc(lua_State* L, std::string_view mode, float x, float y, float radius, float from, float to);
void capsule(lua_State* L, std::string_view mode, float x1, float y1, float x2, float y2, float radius);
void polygon(lua_State* L, std::string_view mode, TableArgument points);
void line(lua_State* L, AnyArgument points);
void mesh(lua_State* L, TableArgument vertices, std::optional<Picture> image);

}  // namespace cairn::scripting
