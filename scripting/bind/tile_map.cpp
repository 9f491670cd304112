// cairn.tilemap and the methods of TileMap. Invariant: the author sees one frame only, that of the map's
// units: y down as on the screen, or y up as in the world, with (0, 0) at the map's corner of least x and y.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "bind/context.h"
#include "bind/fields.h"
#include "bind/graphics_objects.h"
#include "bind/modules.h"
#include "bind/tile_map_object.h"
#include "data/nearest.h"
#include "data/table_writer.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

using engine::MapLayer;
using engine::MapObject;
using engine::Rect;
using engine::Tile;
using engine::Vec2;

constexpr Field kScale =
    above(number_field("scale", 1, "1", "units per pixel of the map: metres, under a camera"), 0, 1e6);
constexpr Field kYUp = boolean_field("y_up", false, "whether y points up, as under a camera");
constexpr Field kFilter{"filter", FieldType::String, "linear",
                        "of its pictures: \"linear\", or \"nearest\" for pixel art"};
constexpr const Field* kOwn[] = {&kScale, &kYUp, &kFilter};
constexpr FieldSet kLoadFields{kOwn};

Pushed load(lua_State* L, std::string_view path, std::optional<TableArgument> fields) {
    if (!fields) lua_newtable(L);
    const FieldReader reader(L, fields ? fields->index : -1, kLoadFields);
    const Services& services = context_of(L).services;
    engine::TileMap map = value_or_raise(L, engine::load_tile_map(services.files, path));
    const std::string_view filter = reader.text(kFilter);
    if (filter != "linear" && filter != "nearest") reader.fail(kFilter, "must be \"linear\" or \"nearest\"");
    const bool is_nearest = filter == "nearest";
    // Of a tile set or of a layer.
    const auto texture = [&](const auto& of) {
        const std::string& image = of.image_path;
        const std::string& place = of.place;
        const auto loaded = services.renderer.load_texture(
            image, is_nearest ? engine::TextureFilter::Nearest : engine::TextureFilter::Linear,
            of.transparent);
        if (!loaded) call_error(L, place + ": image is \"" + image + "\", but " + loaded.error().message);
        return *loaded;
    };
    std::vector<engine::TextureId> textures;
    for (const engine::TileSet& set : map.sets) {
        textures.push_back(texture(set));
        const engine::Size size = services.renderer.texture_size(textures.back());
        if (const auto fits = set.check_image(size); !fits) call_error(L, fits.error().message);
    }
    std::vector<engine::TextureId> images;
    for (const MapLayer& layer : map.layers)
        images.push_back(layer.image_path.empty() ? engine::TextureId{} : texture(layer));
    std::size_t bytes = 0;
    for (const MapLayer& layer : map.layers)
        bytes +=
            layer.tiles.size() * sizeof(layer.tiles[0]) + layer.objects.size() * sizeof(layer.objects[0]);
    new_object<TileMapObject>(L, 0, std::move(map), std::move(textures), std::move(images),
                              reader.real(kScale), reader.boolean(kYUp), is_nearest);
    charge_native_memory(L, bytes);
    return {1};
}

// ---- Facts

std::tuple<float, float> size(TileMapObject* self) {
    const Vec2 size = self->map.size() * self->scale;
    return {size.x, size.y};
}
std::tuple<std::int64_t, std::int64_t> cells(TileMapObject* self) {
    return {self->map.columns, self->map.rows};
}
std::tuple<float, float> cell_size(TileMapObject* self) {
    return {self->cell_width(), self->cell_height()};
}

void push_properties(lua_State* L, const engine::TileProperties& properties) {
    lua_createtable(L, 0, static_cast<int>(properties.size()));
    for (const auto& [name, value] : properties) {
        if (const bool* flag = std::get_if<bool>(&value)) lua_pushboolean(L, *flag ? 1 : 0);
        if (const double* number = std::get_if<double>(&value)) {
            lua_Integer whole = 0;
            if (lua_numbertointeger(*number, &whole) && static_cast<double>(whole) == *number)
                lua_pushinteger(L, whole);
            else
                lua_pushnumber(L, *number);
        }
        if (const std::string* text = std::get_if<std::string>(&value))
            lua_pushlstring(L, text->data(), text->size());
        lua_setfield(L, -2, name.c_str());
    }
}

Pushed properties(lua_State* L, TileMapObject* self) {
    push_properties(L, self->map.properties);
    return {1};
}

Pushed layers(lua_State* L, TileMapObject* self) {
    lua_createtable(L, static_cast<int>(self->map.layers.size()), 0);
    lua_Integer count = 0;
    for (const MapLayer& layer : self->map.layers) {
        lua_pushlstring(L, layer.name.data(), layer.name.size());
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}

/// Raises for a layer that is not there, with the nearest that is.
MapLayer& find_layer(lua_State* L, TileMapObject* self, std::string_view name, MapLayer::Kind kind) {
    std::vector<std::string> names;
    for (MapLayer& layer : self->map.layers) {
        if (layer.kind != kind) continue;
        if (layer.name == name) return layer;
        names.push_back(layer.name);
    }
    call_error(L, "layer is " + quote_text(name) + ": no such layer of " +
                      (kind == MapLayer::Kind::Tiles ? "tiles" : "objects") + suggestion(name, names));
}

// ---- Tiles. Columns and rows count from 1, rows from the top, as the editor shows them plus one.

Tile* tile_at(TileMapObject* self, MapLayer& layer, std::int64_t column, std::int64_t row) {
    if (column < 1 || row < 1 || column > self->map.columns || row > self->map.rows) return nullptr;
    return &layer.tiles[static_cast<std::size_t>(row - 1) * static_cast<std::size_t>(self->map.columns) +
                        static_cast<std::size_t>(column - 1)];
}

std::int64_t tile(lua_State* L, TileMapObject* self, std::string_view layer, std::int64_t column,
                  std::int64_t row) {
    const Tile* found = tile_at(self, find_layer(L, self, layer, MapLayer::Kind::Tiles), column, row);
    return found ? found->id : 0;
}

void set_tile(lua_State* L, TileMapObject* self, std::string_view layer, std::int64_t column,
              std::int64_t row, std::int64_t id) {
    Tile* found = tile_at(self, find_layer(L, self, layer, MapLayer::Kind::Tiles), column, row);
    if (!found)
        call_error(L, "column and row are " + std::to_string(column) + " and " + std::to_string(row) +
                          "; the map has " + std::to_string(self->map.columns) + " columns and " +
                          std::to_string(self->map.rows) + " rows");
    if (id < 0 || id > 0x0fffffff || (id != 0 && !self->map.set_of(static_cast<std::uint32_t>(id))))
        argument_error(L, 5, "0, or a tile of one of the map's sets");
    *found = {.id = static_cast<std::uint32_t>(id)};
}

Pushed tile_properties(lua_State* L, TileMapObject* self, std::int64_t id) {
    push_properties(
        L, self->map.properties_of(static_cast<std::uint32_t>(std::clamp<std::int64_t>(id, 0, 0x0fffffff))));
    return {1};
}

std::tuple<std::int64_t, std::int64_t> cell_at(TileMapObject* self, float x, float y) {
    const engine::TileMap::Cell cell = self->map.cell_at(self->to_pixels({x, y}));
    return {cell.column + 1, cell.row + 1};
}

std::tuple<float, float> cell_center(TileMapObject* self, std::int64_t column, std::int64_t row) {
    const auto index = [](std::int64_t number) {
        return static_cast<int>(std::clamp<std::int64_t>(number, -1'000'000'000, 1'000'000'000)) - 1;
    };
    const Vec2 middle = self->to_units(self->map.cell_middle(index(column), index(row)));
    return {middle.x, middle.y};
}

void set_number(lua_State* L, const char* field, float value) {
    lua_pushnumber(L, static_cast<double>(value));
    lua_setfield(L, -2, field);
}
void set_text(lua_State* L, const char* field, std::string_view value) {
    lua_pushlstring(L, value.data(), value.size());
    lua_setfield(L, -2, field);
}

/// { {x, y}, ... } becomes a field of the table on top of the stack.
void set_points(lua_State* L, std::span<const Vec2> points) {
    lua_createtable(L, static_cast<int>(points.size()), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        lua_createtable(L, 2, 0);
        lua_pushnumber(L, static_cast<double>(points[i].x));
        lua_rawseti(L, -2, 1);
        lua_pushnumber(L, static_cast<double>(points[i].y));
        lua_rawseti(L, -2, 2);
        lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
    }
    lua_setfield(L, -2, "points");
}

/// A table with the middle of a rectangle of cells, and its sizes or, where it is a diamond, its corners.
void push_solid(lua_State* L, const TileMapObject& self, const engine::CellRect& rect) {
    const Vec2 low = {static_cast<float>(rect.column), static_cast<float>(rect.row)};
    const Vec2 high = low + Vec2{static_cast<float>(rect.columns), static_cast<float>(rect.rows)};
    const auto place = [&](Vec2 cells) { return self.to_units(self.map.from_cells(cells)); };
    const Vec2 middle = place(0.5f * (low + high));
    lua_createtable(L, 0, 4);
    set_number(L, "x", middle.x);
    set_number(L, "y", middle.y);
    if (self.map.grid == engine::MapGrid::Orthogonal) {
        set_number(L, "width", static_cast<float>(rect.columns) * self.cell_width());
        set_number(L, "height", static_cast<float>(rect.rows) * self.cell_height());
        return;
    }
    std::array<Vec2, 4> corners = {low, {high.x, low.y}, high, {low.x, high.y}};
    for (Vec2& corner : corners) corner = place(corner) - middle;
    set_points(L, corners);
}

/// The same of one cell of a staggered map, whose cells make no straight rows.
void push_solid_cell(lua_State* L, const TileMapObject& self, int column, int row) {
    const Vec2 in_picture = self.map.cell_middle(column, row);
    const Vec2 middle = self.to_units(in_picture);
    lua_createtable(L, 0, 3);
    set_number(L, "x", middle.x);
    set_number(L, "y", middle.y);
    std::vector<Vec2> corners = self.map.cell_outline();
    for (Vec2& corner : corners) corner = self.to_units(in_picture + corner) - middle;
    set_points(L, corners);
}

Pushed solids(lua_State* L, TileMapObject* self, std::string_view name,
              std::optional<std::string_view> property) {
    const MapLayer& layer = find_layer(L, self, name, MapLayer::Kind::Tiles);
    std::vector<bool> is_solid;
    is_solid.reserve(layer.tiles.size());
    for (const Tile& cell : layer.tiles) {
        bool solid = cell.id != 0;
        if (solid && property) {
            const engine::TileProperties& all = self->map.properties_of(cell.id);
            const auto found = all.find(*property);
            const bool* flag = found == all.end() ? nullptr : std::get_if<bool>(&found->second);
            solid = found != all.end() && (flag == nullptr || *flag);
        }
        is_solid.push_back(solid);
    }
    lua_newtable(L);
    lua_Integer count = 0;
    if (self->map.grid == engine::MapGrid::Staggered) {
        for (std::size_t i = 0; i < is_solid.size(); ++i) {
            if (!is_solid[i]) continue;
            const int cell = static_cast<int>(i);
            push_solid_cell(L, *self, cell % self->map.columns, cell / self->map.columns);
            lua_rawseti(L, -2, ++count);
        }
        return {1};
    }
    for (const engine::CellRect& rect : engine::cover_cells(self->map.columns, self->map.rows, is_solid)) {
        push_solid(L, *self, rect);
        lua_rawseti(L, -2, ++count);
    }
    return {1};
}

// ---- Objects

const char* shape_name(engine::MapShape shape) {
    switch (shape) {
        case engine::MapShape::Rectangle:
            return "rectangle";
        case engine::MapShape::Ellipse:
            return "ellipse";
        case engine::MapShape::Point:
            return "point";
        case engine::MapShape::Polygon:
            return "polygon";
        case engine::MapShape::Polyline:
            return "polyline";
        case engine::MapShape::Tile:
            return "tile";
        case engine::MapShape::Text:
            return "text";
    }
    return "";
}

void push_map_object(lua_State* L, const TileMapObject& self, const MapObject& object) {
    // Tiled turns an object about its position; the author gets its middle, which is what bodies and images
    // want.
    const bool is_isometric = self.map.grid == engine::MapGrid::Isometric;
    const Vec2 position = self.map.from_object(object.position);
    const auto place = [&](Vec2 from_position) {
        const Vec2 way = self.map.from_object(object.position + from_position) - position;
        return self.to_units(position + engine::Affine2::rotation(object.rotation_rad).apply(way));
    };
    Vec2 center = place(object.size * 0.5f);
    if (object.shape == engine::MapShape::Tile) {  // stands upright
        const Vec2 middle = {(0.5f - object.anchor.x) * object.size.x,
                             (0.5f - object.anchor.y) * object.size.y};
        center = self.to_units(position + engine::Affine2::rotation(object.rotation_rad).apply(middle));
    }
    lua_createtable(L, 0, 12);
    lua_pushinteger(L, object.id);
    lua_setfield(L, -2, "id");
    set_text(L, "name", object.name);
    set_text(L, "class", object.kind);
    set_text(L, "shape", shape_name(object.shape));
    set_number(L, "x", center.x);
    set_number(L, "y", center.y);
    set_number(L, "width", object.size.x * self.scale);
    set_number(L, "height", object.size.y * self.scale);
    set_number(L, "angle", self.is_y_up ? -object.rotation_rad : object.rotation_rad);
    lua_pushboolean(L, object.is_visible ? 1 : 0);
    lua_setfield(L, -2, "visible");
    if (object.tile.id != 0) {
        lua_pushinteger(L, object.tile.id);
        lua_setfield(L, -2, "tile");
    }
    if (!object.text.empty()) set_text(L, "text", object.text);
    push_properties(L, object.properties);
    lua_setfield(L, -2, "properties");
    std::vector<Vec2> points;
    for (const Vec2 point : object.points) points.push_back(place(point));
    if (is_isometric && object.shape == engine::MapShape::Rectangle) {
        const Vec2 size = object.size;
        points = {place({0, 0}), place({size.x, 0}), place(size), place({0, size.y})};
    }
    if (!points.empty()) set_points(L, points);
}

Pushed objects(lua_State* L, TileMapObject* self, std::optional<std::string_view> name) {
    const MapLayer* only = name ? &find_layer(L, self, *name, MapLayer::Kind::Objects) : nullptr;
    lua_newtable(L);
    lua_Integer count = 0;
    for (const MapLayer& layer : self->map.layers) {
        if (only != nullptr && &layer != only) continue;
        for (const MapObject& object : layer.objects) {
            push_map_object(L, *self, object);
            lua_rawseti(L, -2, ++count);
        }
    }
    return {1};
}

// ---- Drawing

void draw(lua_State* L, TileMapObject* self, std::optional<std::string_view> name) {
    const Context& context = drawing_context(L);
    for (const MapLayer& layer : self->map.layers) {
        if (name ? layer.name == *name : layer.is_visible) draw_layer(context, *self, layer);
    }
    if (!name || self->map.layer(*name) != nullptr) return;
    std::vector<std::string> names;
    for (const MapLayer& layer : self->map.layers) names.push_back(layer.name);
    call_error(L, "layer is " + quote_text(*name) + ": no such layer" + suggestion(*name, names));
}

constexpr std::array<std::string_view, 1> kReturnsMap = {"TileMap"};
constexpr std::array<std::string_view, 1> kReturnsTable = {"table"};
constexpr std::array<std::string_view, 1> kReturnsNames = {"string[]"};

constexpr Function kModuleFunctions[] = {
    function_pushing<&load>(
        "load", "path, fields = {}", "map", kReturnsMap,
        "Loads an orthogonal, isometric, staggered or hexagonal map, .tmx "
        "or .tmj, with its tile "
        "sets and pictures, in which the transparent color that the editor was told is not seen. An infinite "
        "one is as large as what was drawn in it: its upper "
        "left corner is that of the first tile. Layer data may be CSV or base64, plain or packed with zlib "
        "or gzip. Places are those "
        "of the picture, in which a cell may be a diamond or a hexagon.",
        &kLoadFields),
};
constexpr Function kMethods[] = {
    function<&draw>(
        "draw", "layer = nil", "",
        "Draws a layer, or all that are visible; only what the picture shows, with the color that is set. "
        "Of object layers it draws the tiles, sized, turned and ordered as in the editor, of image layers "
        "the picture, repeated as the map says. Layers "
        "with "
        "parallax move as in the editor when the middle of the picture does. Under a camera load it with "
        "`y_up = true` and a scale."),
    function<&size>("size", "", "width, height", "In the map's units; it begins at (0, 0)."),
    function<&cells>("cells", "", "columns, rows", ""),
    function<&cell_size>("cell_size", "", "width, height", "In the map's units."),
    function_pushing<&properties>("properties", "", "properties", kReturnsTable,
                                  "A new table of the map's own."),
    function_pushing<&layers>("layers", "", "names", kReturnsNames,
                              "A new list, the lowest first; those in groups are called \"group/layer\"."),
    function<&tile>(
        "tile", "layer, column, row", "id",
        "The number of a tile among all sets, 0 for none. Columns and rows count from 1, at the top left."),
    function<&set_tile>("set_tile", "layer, column, row, id", "", "Puts a tile there, or 0 for none."),
    function_pushing<&tile_properties>(
        "tile_properties", "id", "properties", kReturnsTable,
        "A new table of what the tile set says about a tile; `class` is its class."),
    function<&cell_at>("cell_at", "x, y", "column, row",
                       "The cell that holds a place, also outside of the map."),
    function<&cell_center>("cell_center", "column, row", "x, y", "The middle of a cell."),
    function_pushing<&solids>(
        "solids", "layer, property = nil", "rectangles", kReturnsTable,
        "Covers the layer's tiles, all or those whose property is there and not false, with few rectangles: "
        "a list of "
        "{ x, y, width, height }, x and y being the middle, as `body:add_box` takes them. On all but "
        "orthogonal maps "
        "{ x, y, points }, the points from the middle, as `world:add_polygon` takes them."),
    function_pushing<&objects>("objects", "layer = nil", "objects", kReturnsTable,
                               "A new list of tables: id, name, class, shape (\"rectangle\", \"ellipse\", "
                               "\"point\", \"polygon\", \"polyline\", "
                               "\"tile\" or \"text\"), x, y (the middle), width, height, angle, visible, "
                               "properties, points, tile, text. A rectangle on an isometric map is a "
                               "parallelogram, with its corners as points. A tile without a width or a "
                               "height has that of its set, and the set's object alignment says where it "
                               "stands, as in the editor."),
};

}  // namespace

int finalize_tile_map(lua_State* L) {
    object_at<TileMapObject>(L, 1)->~TileMapObject();
    return 0;
}

const Module kTileMapModule = {
    "cairn.tilemap",
    "Maps drawn with the editor Tiled: layers of tiles, of objects and with images, in groups, with their "
    "opacity, "
    "tint, offset and parallax.",
    kModuleFunctions,
};
const Module kTileMapMethods = {"TileMap", "A map of tiles and objects.", kMethods, true};

}  // namespace cairn::scripting
