// Maps of tiles and objects, as the editor Tiled saves them (.tmx and .tsx, .tmj and .tsj, .json).
// Invariant: every tile of every layer is 0 or a tile of one of the tile sets, so drawing need not check.
// Coordinates are pixels of the map, y down, as in the editor.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <cairn/engine/files.h>
#include <cairn/engine/geometry.h>
#include <cairn/engine/result.h>

namespace cairn::engine {

using TileProperty = std::variant<bool, double, std::string>;
using TileProperties = std::map<std::string, TileProperty, std::less<>>;

/// A tile as a layer holds it: its number among all tile sets, from 1, and how it is turned.
struct Tile {
    std::uint32_t id = 0;  ///< 0: none
    bool flip_x = false;
    bool flip_y = false;
    bool flip_diagonal = false;  ///< before the others: x and y change places

    friend bool operator==(const Tile&, const Tile&) = default;
};

struct TileFrame {
    std::uint32_t id = 0;
    double duration_s = 0;
};

struct TileSet {
    std::string name;
    std::uint32_t first_id = 1;
    int tile_count = 0;
    Size tile_size;  ///< pixels
    int columns = 1;
    int margin = 0;
    int spacing = 0;
    std::string image_path;            ///< as Files knows it
    std::optional<Color> transparent;  ///< pixels of that color are not seen
    Vec2 tile_offset;                  ///< how far from their places its tiles are drawn, pixels of the tiles
    /// Which point of its tiles lies at the position of an object, as a share of their sizes from the top
    /// left; absent: the bottom left, on isometric maps the middle of the bottom.
    std::optional<Vec2> object_anchor;
    std::string place;  ///< for messages: `maps/one.tmx:4: tile set "ground"`
    std::map<std::uint32_t, TileProperties> properties;          ///< by id
    std::map<std::uint32_t, std::vector<TileFrame>> animations;  ///< by id

    /// Where a tile lies in the image.
    Rect source(std::uint32_t id) const;
    /// Whether an image of that size has room for all of them; the error names the place, the value and the
    /// rule.
    Result<void> check_image(Size image) const;
};

enum class MapShape { Rectangle, Ellipse, Point, Polygon, Polyline, Tile, Text };

struct MapObject {
    int id = 0;
    std::string name;
    std::string kind;  ///< the class (or type) that the editor shows
    MapShape shape = MapShape::Rectangle;
    Vec2 position;           ///< top left; of tiles the point that their set says
    Vec2 size;               ///< of tiles that say none that of their set
    Vec2 anchor;             ///< which point of it the position is, as a share of the size from the top left
    float rotation_rad = 0;  ///< clockwise in the editor
    std::vector<Vec2> points;  ///< of polygons and polylines, from the position
    Tile tile;
    std::string text;
    bool is_visible = true;
    TileProperties properties;
    std::string place;  ///< for messages: `object 3 "crate" in layer "things"`
    int line = 0;       ///< of the file, from 1; 0: not known
    /// Of a map with faults, what of this could not be read and is not told again: "width", "property mass",
    /// "properties" when none could.
    std::set<std::string, std::less<>> unreadable;
};

struct MapLayer {
    enum class Kind { Tiles, Objects, Image };

    std::string name;
    Kind kind = Kind::Tiles;
    bool is_visible = true;
    Color color;  ///< its tint and opacity, with those of its groups
    Vec2 offset;  ///< pixels, with those of its groups
    Vec2 parallax = {1,
                     1};  ///< its factors, multiplied with those of its groups: how far it moves with the map
    TileProperties properties;
    std::vector<Tile> tiles;  ///< rows from the top
    std::vector<MapObject> objects;
    bool draws_from_top = true;  ///< its objects in the order of their y; else in that of the list
    // Of image layers
    std::string image_path;            ///< as Files knows it
    std::optional<Color> transparent;  ///< pixels of that color are not seen
    Vec2 image_corner;                 ///< the top left of the picture in that of the map, but for the offset
    bool repeats_x = false;
    bool repeats_y = false;
    std::string place;  ///< for messages: `maps/one.tmx:9: layer "sky"`
    int line = 0;       ///< of the file, from 1; 0: not known
};

/// How the cells of a map lie in its picture.
enum class MapGrid {
    Orthogonal,
    Isometric,  ///< diamonds: columns run down to the right, rows down to the left
    Staggered,  ///< diamonds or hexagons: every second row or column is half a cell behind
};

/// What a staggered grid has besides the size of its cells. A cell is a hexagon with two sides of
/// `side_length` pixels, which lie across the axis in which cells are moved; at 0 it is a diamond.
struct Stagger {
    int side_length = 0;
    bool moves_columns = false;  ///< else rows
    bool moves_even = false;     ///< the first, third, ... one; else the others
};

struct TileMap {
    MapGrid grid = MapGrid::Orthogonal;
    int columns = 0;
    int rows = 0;
    Size tile_size;                ///< of a cell
    Stagger stagger;               ///< of a staggered grid
    std::vector<TileSet> sets;     ///< by first_id
    std::vector<MapLayer> layers;  ///< the lowest first; those in groups are named "group/layer"
    TileProperties properties;
    std::optional<Color> background;
    Vec2 parallax_origin;  ///< where the middle of the view shows all layers in their places

    /// Of the picture, in pixels.
    Vec2 size() const;
    /// On grids whose rows are straight: where a place among the cells lies in the picture; (0, 0) is the
    /// outer corner of the first cell, (1, 1) that of the second in the second row.
    Vec2 from_cells(Vec2 cells) const;
    /// The other way.
    Vec2 to_cells(Vec2 place) const;
    /// Where a place as objects have it lies in the picture. Tiled counts those of isometric maps along the
    /// sides of the cells, of which both are as long as a cell is high.
    Vec2 from_object(Vec2 place) const;
    /// The bottom left of a cell's tile.
    Vec2 tile_corner(int column, int row) const;
    /// Where the middle of a cell lies in the picture, on any grid.
    Vec2 cell_middle(int column, int row) const;
    /// The corners of a cell, from its middle, in order.
    std::vector<Vec2> cell_outline() const;
    /// The cell that a place in the picture is in, on any grid; outside of the map the one that would be
    /// there.
    struct Cell {
        int column = 0;
        int row = 0;

        friend bool operator==(const Cell&, const Cell&) = default;
    };
    Cell cell_at(Vec2 place) const;

    const TileSet* set_of(std::uint32_t id) const;
    const MapLayer* layer(std::string_view name) const;
    /// How far a layer is moved by parallax when the middle of the view shows that place of the picture.
    Vec2 parallax_shift(const MapLayer& layer, Vec2 view_middle) const;
    /// The properties of a kind of tile; empty for 0.
    const TileProperties& properties_of(std::uint32_t id) const;
    /// What an animated tile shows at a time; others show themselves.
    std::uint32_t shown(std::uint32_t id, double time_s) const;
};

/// Orthogonal, isometric, staggered and hexagonal maps. An infinite one is as large as what was drawn in it:
/// its first cell is at the upper left corner of that, and objects are counted from there. Layer data as CSV,
/// as base64, plain or compressed with zlib or gzip, or as XML elements. Errors name the file, the place in
/// it, the value and the rule.
Result<TileMap> load_tile_map(const Files& files, std::string_view path);

/// The same with all that is wrong, not only the first fault: each is one text.
struct TileMapReading {
    TileMap map;                 ///< what could be read, good when there are no faults
    bool is_map = false;         ///< whether the file is a map at all
    bool lacks_objects = false;  ///< some could not be read, nor what they are called
    /// Of the map's own properties; as in MapObject.
    std::set<std::string, std::less<>> unreadable;
    std::vector<std::string> faults;
};
TileMapReading read_tile_map(const Files& files, std::string_view path);

/// Covers the cells that `is_solid` says with few rectangles (in cells), so that bodies slide over no joints:
/// rows of cells are joined, and equal rows below each other.
struct CellRect {
    int column = 0;
    int row = 0;
    int columns = 0;
    int rows = 0;

    friend bool operator==(const CellRect&, const CellRect&) = default;
};
std::vector<CellRect> cover_cells(int columns, int rows, const std::vector<bool>& is_solid);

}  // namespace cairn::engine
