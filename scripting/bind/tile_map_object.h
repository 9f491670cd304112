// TileMap as a Lua value, and the drawing of its layers.
#pragma once

#include <string_view>
#include <vector>

#include <cairn/engine/tile_map.h>

#include "bind/context.h"
#include "bind/function.h"
#include "bind/object.h"

namespace cairn::scripting {

struct TileMapObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::TileMap;
    engine::TileMap map;
    std::vector<engine::TextureId> textures;  ///< of the map's sets
    std::vector<engine::TextureId> images;    ///< of its layers; null where one has no picture of its own
    float scale;                              ///< units per pixel of the map
    bool is_y_up;
    bool is_nearest;

    [[nodiscard]] float cell_width() const { return static_cast<float>(map.tile_size.width) * scale; }
    [[nodiscard]] float cell_height() const { return static_cast<float>(map.tile_size.height) * scale; }
    [[nodiscard]] float height() const { return map.size().y * scale; }
    /// From pixels of the map to units.
    [[nodiscard]] engine::Vec2 to_units(engine::Vec2 pixels) const {
        const float y = pixels.y * scale;
        return {pixels.x * scale, is_y_up ? height() - y : y};
    }
    /// The other way.
    [[nodiscard]] engine::Vec2 to_pixels(engine::Vec2 units) const {
        return {units.x / scale, (is_y_up ? height() - units.y : units.y) / scale};
    }
};

template <>
struct Argument<TileMapObject*> {
    static constexpr std::string_view kType = "TileMap";
    static TileMapObject* get(lua_State* L, int index) {
        auto* map = object_at<TileMapObject>(L, index);
        if (map == nullptr) argument_error(L, index, "a TileMap");
        return map;
    }
};

/// Draws a layer: its tiles, its objects that are tiles, or its picture, as far as the screen shows them.
void draw_layer(const Context& context, const TileMapObject& map, const engine::MapLayer& layer);

}  // namespace cairn::scripting
