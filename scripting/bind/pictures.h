// What can be drawn like an image, besides images: canvases, quads, atlases; and batches of sprites. As
// bindings of cairn.graphics.
#pragma once

#include "bind/graphics_objects.h"

namespace cairn::scripting {

inline constexpr Range kCanvasSides{1, engine::kMaxImageSide};
using CanvasSide = Ranged<kCanvasSides, std::int64_t>;
Pushed new_canvas(lua_State* L, CanvasSide width, CanvasSide height, std::optional<std::string_view> filter);
Pushed new_quad(lua_State* L, Picture image, float x, float y, float width, float height);
Pushed new_atlas(lua_State* L, std::string_view path, std::optional<std::string_view> filter);
Pushed new_batch(lua_State* L, Picture image);

}  // namespace cairn::scripting
