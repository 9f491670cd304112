// The plain shapes of cairn.graphics, as bindings.
#pragma once

#include <string_view>

#include "bind/graphics_objects.h"

namespace cairn::scripting {

void rectangle(lua_State* L, std::string_view mode, float x, float y, NotNegative width, NotNegative height,
               std::optional<NotNegative> radius);
void circle(lua_State* L, std::string_view mode, float x, float y, NotNegative radius);
void ellipse(lua_State* L, std::string_view mode, float x, float y, NotNegative radius_x,
             NotNegative radius_y);
void arc(lua_State* L, std::string_view mode, float x, float y, NotNegative radius, float from, float to);
void capsule(lua_State* L, std::string_view mode, float x1, float y1, float x2, float y2, NotNegative radius);
void polygon(lua_State* L, std::string_view mode, TableArgument points);
void line(lua_State* L, FurtherArguments points);
void mesh(lua_State* L, TableArgument vertices, std::optional<Picture> image);

}  // namespace cairn::scripting
