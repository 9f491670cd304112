// Reads maps. Invariant: nothing of a file is believed before it was checked; a fault ends the reading of its
// part, with the place at which it was found, and the other parts are read all the same.
#include <algorithm>
#include <functional>
#include <numbers>

#include <cairn/engine/tile_map.h>

#include "assets/tile_data.h"
#include "assets/tile_set_reader.h"
#include "assets/tiled_node.h"

namespace cairn::engine {
namespace {

/// Sides of maps, in tiles; with 16 million cells in all, what fits into memory and into a picture.
constexpr int kMaxSide = 10000;
constexpr std::size_t kMaxCells = 16u << 20;
/// Of infinite maps, which begin anywhere.
constexpr int kFarthestCell = 1 << 24;
/// Of an object that is a tile, pixels: as long as the longest map with cells of 100 pixels.
constexpr int kMaxTileSide = 1'000'000;

Tile read_tile(std::uint32_t bits) {
    return {.id = bits & 0x0fffffffu,
            .flip_x = (bits & 0x80000000u) != 0,
            .flip_y = (bits & 0x40000000u) != 0,
            .flip_diagonal = (bits & 0x20000000u) != 0};
}

class MapReader {
  public:
    MapReader(const Files& files, std::string_view path)
        : files_(files), path_(path), faults_(std::string(path)) {}

    TileMapReading read() {
        faults_.attempt([&] {
            const Json json = read_tiled_file(files_, path_);
            const Node root(json);
            reading_.is_map = true;
            read_map(root);
        });
        reading_.faults = faults_.take();
        return std::move(reading_);
    }

  private:
    void read_map(const Node& node) {
        has_cells_ = read_cells(node);
        map_.properties = read_tiled_properties(node, faults_, reading_.unreadable);
        faults_.attempt([&] { map_.background = read_tiled_color(node, "backgroundcolor"); });
        faults_.attempt([&] {
            if (has_cells_) editor_origin_ = editor_origin(node);
            map_.parallax_origin = editor_origin_ + read_place(node, "parallaxorigin", 0);
        });
        const std::size_t faults_before = faults_.count();
        faults_.attempt([&] {
            for (const Node& set : node.list("tilesets"))
                faults_.attempt([&] { add_set(called_by_name(set, "tile set")); });
        });
        knows_tiles_ = faults_.count() == faults_before;
        reading_.lacks_objects |= !faults_.attempt([&] {
            if (!node.has("layers")) node.fail("layers", "must be a list");
            add_layers(node, "", {});
        });
    }

    /// The grid and how many cells it has.
    bool read_cells(const Node& node) {
        const std::size_t faults_before = faults_.count();
        faults_.attempt([&] { map_.grid = read_grid(node); });
        faults_.attempt([&] { map_.tile_size.width = node.whole("tilewidth", 1, 4096); });
        faults_.attempt([&] { map_.tile_size.height = node.whole("tileheight", 1, 4096); });
        faults_.attempt([&] {
            if (map_.grid == MapGrid::Staggered) read_stagger(node);
        });
        faults_.attempt([&] { is_infinite_ = node.flag("infinite", false); });
        if (is_infinite_) {
            faults_.attempt([&] { find_extent(node); });
        } else {
            faults_.attempt([&] { map_.columns = node.whole("width", 1, kMaxSide); });
            faults_.attempt([&] { map_.rows = node.whole("height", 1, kMaxSide); });
        }
        faults_.attempt([&] {
            if (cells() > kMaxCells) node.fail("width", "width times height must be at most 16777216");
        });
        return faults_.count() == faults_before;
    }

    std::size_t cells() const {
        return static_cast<std::size_t>(map_.columns) * static_cast<std::size_t>(map_.rows);
    }

    /// A block of the tiles of an infinite map; where it begins may be below 0.
    struct Chunk {
        int column, row, columns, rows;
    };
    static Chunk read_chunk(const Node& node) {
        return {node.whole("x", -kFarthestCell, kFarthestCell),
                node.whole("y", -kFarthestCell, kFarthestCell), node.whole("width", 1, kMaxSide),
                node.whole("height", 1, kMaxSide)};
    }

    static std::string name_of(const Node& node) {
        const bool has_name = node.has("name") && node.at("name").is_string();
        return has_name ? node.at("name").get<std::string>() : "";
    }
    static Node called_layer(const Node& node, const std::string& prefix) {
        const std::string name = name_of(node);
        return name.empty() ? node : node.called("layer \"" + prefix + name + '"');
    }

    /// An infinite map is as large as what was drawn in it.
    void find_extent(const Node& map) {
        Chunk all{0, 0, 0, 0};  // the least corner, and behind the greatest
        bool has_any = false;
        const std::function<void(const Node&, const std::string&)> add_layers =
            [&](const Node& parent, const std::string& prefix) {
                for (const Node& unnamed : parent.list("layers")) {
                    const Node layer = called_layer(unnamed, prefix);
                    add_layers(unnamed, prefix + name_of(unnamed) + '/');
                    for (const Node& node : layer.list("chunks")) {
                        const Chunk chunk = read_chunk(node);
                        const int right = chunk.column + chunk.columns, bottom = chunk.row + chunk.rows;
                        all = has_any
                                  ? Chunk{std::min(all.column, chunk.column), std::min(all.row, chunk.row),
                                          std::max(all.columns, right), std::max(all.rows, bottom)}
                                  : Chunk{chunk.column, chunk.row, right, bottom};
                        has_any = true;
                    }
                }
            };
        add_layers(map, "");
        if (!has_any) all = {0, 0, 1, 1};
        if (map_.grid == MapGrid::Staggered) {  // the same rows and columns stay moved
            all.column -= all.column & 1;
            all.row -= all.row & 1;
        }
        first_column_ = all.column;
        first_row_ = all.row;
        map_.columns = all.columns - all.column;
        map_.rows = all.rows - all.row;
        if (map_.columns > kMaxSide || map_.rows > kMaxSide) {
            map.fail("what is drawn in the map is " + std::to_string(map_.columns) + " x " +
                     std::to_string(map_.rows) + " tiles large, but must be at most " +
                     std::to_string(kMaxSide) + " either way; is there a stray tile far out?");
        }
    }

    /// Where the first cell lies, as objects have it.
    [[nodiscard]] Vec2 first_place() const {
        const auto column = static_cast<float>(first_column_), row = static_cast<float>(first_row_);
        auto width = static_cast<float>(map_.tile_size.width),
             height = static_cast<float>(map_.tile_size.height);
        if (map_.grid == MapGrid::Isometric) width = height;
        if (map_.grid == MapGrid::Staggered) {
            float& moved = map_.stagger.moves_columns ? width : height;
            moved = 0.5f * (moved + static_cast<float>(map_.stagger.side_length));
        }
        return {column * width, row * height};
    }

    static MapGrid read_grid(const Node& node) {
        const std::string grid = node.text("orientation", "orthogonal");
        if (grid == "orthogonal") return MapGrid::Orthogonal;
        if (grid == "isometric") return MapGrid::Isometric;
        if (grid == "staggered" || grid == "hexagonal") return MapGrid::Staggered;
        node.fail("orientation", "must be orthogonal, isometric, staggered or hexagonal");
    }

    void read_stagger(const Node& node) {
        const auto choice = [&](const char* field, const char* one, const char* other) {
            const std::string text = node.text(field, other);
            if (text != one && text != other)
                node.fail(field, std::string("must be ") + one + " or " + other);
            return text == one;
        };
        map_.stagger.moves_columns = choice("staggeraxis", "x", "y");
        map_.stagger.moves_even = choice("staggerindex", "even", "odd");
        const int longest = map_.stagger.moves_columns ? map_.tile_size.width : map_.tile_size.height;
        if (node.text("orientation") == "hexagonal")
            map_.stagger.side_length = node.whole("hexsidelength", 0, longest - 1, 0);
    }

    void add_set(const Node& node) {
        const auto first_id = static_cast<std::uint32_t>(node.whole("firstgid", 1, 0x0fffffff));
        if (!map_.sets.empty() &&
            first_id < map_.sets.back().first_id + static_cast<std::uint32_t>(map_.sets.back().tile_count))
            node.fail("firstgid", "must lie behind the tiles of the set before");
        if (!node.has("source")) return map_.sets.push_back(read_tile_set(node, first_id, path_, faults_));
        const std::string path = tiled_path_beside(path_, node.text("source"));
        const std::string place = faults_.start(node.line()) + "tile set '" + path + '\'';
        FaultList faults(path);
        faults.attempt([&] {
            const Json json = read_tiled_file(files_, path);
            map_.sets.push_back(read_tile_set(Node(json), first_id, path, faults));
            map_.sets.back().place = place;
        });
        faults_.add(place + ": ", faults.take());
    }

    void check_tile(const Tile& tile, const Node& node) const {
        if (knows_tiles_ && tile.id != 0 && map_.set_of(tile.id) == nullptr)
            node.fail("it has a tile " + std::to_string(tile.id) + " that no tile set has");
    }

    /// "FIELDx" and "FIELDy".
    static Vec2 read_place(const Node& node, const std::string& field, double otherwise) {
        return {static_cast<float>(node.number((field + 'x').c_str(), otherwise)),
                static_cast<float>(node.number((field + 'y').c_str(), otherwise))};
    }

    /// Where the editor's own (0, 0), from which it counts pictures, lies in the picture of the map. In an
    /// infinite map the first cell is not at it.
    [[nodiscard]] Vec2 editor_origin(const Node& map) const {
        if (!is_infinite_) return {};
        if (map_.grid != MapGrid::Isometric) return -1 * first_place();
        // The editor moves a picture to the right by the rows that the file says, not by those that were
        // drawn.
        const int across = first_column_ - first_row_ + map.whole("height", 0, kFarthestCell, 0) - map_.rows;
        return {-0.5f * static_cast<float>(across * map_.tile_size.width),
                -0.5f * static_cast<float>((first_column_ + first_row_) * map_.tile_size.height)};
    }

    /// `group` is what it inherits.
    void add_layers(const Node& parent, const std::string& prefix, const MapLayer& group) {
        for (const Node& node : parent.list("layers")) add_layer(node, prefix, group);
    }

    void add_layer(const Node& unnamed, const std::string& prefix, const MapLayer& group) {
        MapLayer layer;
        faults_.attempt([&] { layer.name = prefix + unnamed.text("name"); });
        const Node node = called_layer(unnamed, prefix);
        layer.place = faults_.start(node.line()) + node.place();
        layer.line = node.line();
        layer.color = group.color;
        layer.offset = group.offset;
        layer.parallax = group.parallax;
        faults_.attempt([&] { layer.is_visible = group.is_visible && node.flag("visible", true); });
        faults_.attempt([&] { tint(layer.color, read_tiled_color(node, "tintcolor").value_or(Color{})); });
        faults_.attempt([&] {
            const auto opacity = static_cast<float>(node.number("opacity", 1));
            if (opacity < 0 || opacity > 1) node.fail("opacity", "must be from 0 to 1");
            layer.color.a *= opacity;
        });
        faults_.attempt([&] { layer.offset = group.offset + read_place(node, "offset", 0); });
        faults_.attempt([&] {
            const Vec2 parallax = read_place(node, "parallax", 1);
            layer.parallax = {group.parallax.x * parallax.x, group.parallax.y * parallax.y};
        });
        Names unreadable;
        layer.properties = read_tiled_properties(node, faults_, unreadable);
        std::string type;
        reading_.lacks_objects |= !faults_.attempt([&] {
            type = node.text("type");
            if (type == "group") {
                add_layers(node, layer.name + '/', layer);
            } else if (type == "objectgroup") {
                layer.kind = MapLayer::Kind::Objects;
                if (!node.has("objects")) node.fail("objects", "must be a list");
                for (const Node& object : node.list("objects")) layer.objects.push_back(read_object(object));
            } else if (type != "tilelayer" && type != "imagelayer") {
                node.fail("type", "must be a tilelayer, an objectgroup, a group or an imagelayer");
            }
        });
        if (type == "tilelayer") faults_.attempt([&] { read_tiles(node, layer); });
        if (type == "objectgroup") faults_.attempt([&] { layer.draws_from_top = reads_from_top(node); });
        if (type == "imagelayer") faults_.attempt([&] { read_image(node, layer); });
        if (type != "group") map_.layers.push_back(std::move(layer));
    }

    static void tint(Color& color, const Color& by) {
        color = {color.r * by.r, color.g * by.g, color.b * by.b, color.a * by.a};
    }

    static bool reads_from_top(const Node& node) {
        const std::string order = node.text("draworder", "topdown");
        if (order != "topdown" && order != "index") node.fail("draworder", "must be topdown or index");
        return order == "topdown";
    }

    void read_image(const Node& node, MapLayer& layer) {
        layer.kind = MapLayer::Kind::Image;
        layer.image_corner = editor_origin_;
        faults_.attempt([&] { layer.repeats_x = node.flag("repeatx", false); });
        faults_.attempt([&] { layer.repeats_y = node.flag("repeaty", false); });
        faults_.attempt([&] { layer.transparent = read_tiled_color(node, "transparentcolor"); });
        if (node.text("image").empty()) node.fail("image", "must name the picture of the layer");
        layer.image_path = tiled_path_beside(path_, node.text("image"));
    }

    /// The numbers of `cells` tiles out of `node`; how they are written stands in the layer.
    static std::vector<std::uint32_t> read_bits(const Node& node, const Node& layer, std::size_t cells) {
        if (!node.has("data")) node.fail("data", "must hold the tiles");
        const Json& data = node.at("data");
        std::vector<std::uint32_t> bits;
        if (data.is_array()) {
            for (const Json& value : data) {
                if (!value.is_number_unsigned()) node.fail("data", "must hold tile numbers");
                bits.push_back(value.get<std::uint32_t>());
            }
            if (bits.size() != cells)
                node.fail("data has " + std::to_string(bits.size()) + " tiles, but there are " +
                          std::to_string(cells) + " cells");
            return bits;
        }
        const std::string encoding = layer.text("encoding", "csv");
        if (encoding != "csv" && encoding != "base64") layer.fail("encoding", "must be csv or base64");
        const std::string text = node.text("data");
        Result<std::vector<std::uint32_t>> read =
            encoding == "csv" ? tiles_from_csv(text, cells)
                              : tiles_from_base64(text, layer.text("compression"), cells);
        if (!read) node.fail(read.error().message);
        return std::move(*read);
    }

    /// Whether a layer has its tiles outside of chunks.
    static bool part_of_fixed_map(const Node& layer) {
        if (!layer.has("data")) return false;
        const Json& data = layer.at("data");
        return data.is_array() ? !data.empty()
                               : layer.text("data").find_first_not_of(" \n\r\t") != std::string::npos;
    }

    void read_tiles(const Node& node, MapLayer& layer) const {
        if (!has_cells_) return;  // how many tiles there must be is not known
        std::vector<std::uint32_t> bits;
        if (is_infinite_) {
            bits.resize(cells());
            for (const Node& part : node.list("chunks")) {
                const Chunk chunk = read_chunk(part);
                const auto width = static_cast<std::size_t>(chunk.columns);
                const std::vector<std::uint32_t> read =
                    read_bits(part, node, width * static_cast<std::size_t>(chunk.rows));
                for (std::size_t i = 0; i < read.size(); ++i) {
                    const auto column = static_cast<std::size_t>(chunk.column - first_column_) + i % width;
                    const auto row = static_cast<std::size_t>(chunk.row - first_row_) + i / width;
                    bits[row * static_cast<std::size_t>(map_.columns) + column] = read[i];
                }
            }
            if (part_of_fixed_map(node))
                node.fail("data", "must stand in chunks: the map says that it is infinite");
        } else {
            if (node.has("chunks")) node.fail("chunks", "only a map that says infinite has them");
            bits = read_bits(node, node, cells());
        }
        layer.tiles.reserve(bits.size());
        for (const std::uint32_t value : bits) {
            layer.tiles.push_back(read_tile(value));
            check_tile(layer.tiles.back(), node);
        }
    }

    /// What is wrong with one thing of an object hides no other.
    MapObject read_object(const Node& unnamed) {
        const std::string& layer = unnamed.owner();
        const Node node = called_by_name(unnamed, "object", layer.empty() ? "" : " in " + layer);
        MapObject object;
        object.place = node.place();
        object.line = node.line();
        const auto read = [&](const char* what, const auto& take) {
            if (!faults_.attempt(take)) object.unreadable.insert(what);
        };
        const auto read_number = [&](const char* field, float& to, bool is_required) {
            read(field,
                 [&] { to = static_cast<float>(is_required ? node.number(field) : node.number(field, 0)); });
        };
        read("template", [&] {
            if (node.has("template"))
                node.fail("template", "templates are not known; detach the object from it");
        });
        read("id", [&] { object.id = node.whole("id", 0, 1 << 30, 0); });
        read("name", [&] { object.name = node.text("name"); });
        read("class", [&] { object.kind = node.text("class", node.text("type")); });
        read_number("x", object.position.x, true);
        read_number("y", object.position.y, true);
        object.position = object.position - first_place();
        read_number("width", object.size.x, false);
        read_number("height", object.size.y, false);
        read_number("rotation", object.rotation_rad, false);
        object.rotation_rad *= std::numbers::pi_v<float> / 180;
        read("visible", [&] { object.is_visible = node.flag("visible", true); });
        object.properties = read_tiled_properties(node, faults_, object.unreadable);
        read("shape", [&] { read_shape(node, object); });
        if (object.shape == MapShape::Tile) finish_tile(node, object, read);
        return object;
    }

    /// What an object that is a tile has of its set. Of a side that it leaves out, or says to be 0, the
    /// editor takes that of the tile.
    template <class Read>
    void finish_tile(const Node& node, MapObject& object, const Read& read) const {
        const auto check_side = [&](const char* field, float side) {
            read(field, [&] {
                if (side < 0 || side > kMaxTileSide)
                    node.fail(field, "must be from 0 to " + std::to_string(kMaxTileSide) + " for a tile");
            });
        };
        check_side("width", object.size.x);
        check_side("height", object.size.y);
        const TileSet* set = map_.set_of(object.tile.id);
        const bool is_isometric = map_.grid == MapGrid::Isometric;
        object.anchor = Vec2{is_isometric ? 0.5f : 0, 1};
        if (set == nullptr) return;
        object.anchor = set->object_anchor.value_or(object.anchor);
        if (object.size.x == 0) object.size.x = static_cast<float>(set->tile_size.width);
        if (object.size.y == 0) object.size.y = static_cast<float>(set->tile_size.height);
    }

    void read_shape(const Node& node, MapObject& object) const {
        if (node.flag("ellipse", false)) object.shape = MapShape::Ellipse;
        if (node.flag("point", false)) object.shape = MapShape::Point;
        for (const auto& [field, shape] :
             {std::pair{"polygon", MapShape::Polygon}, std::pair{"polyline", MapShape::Polyline}}) {
            if (!node.has(field)) continue;
            object.shape = shape;
            for (const Node& point : node.list(field))
                object.points.push_back(
                    {static_cast<float>(point.number("x")), static_cast<float>(point.number("y"))});
        }
        if (node.has("gid")) {
            object.shape = MapShape::Tile;
            object.tile = read_tile(node.tile_bits("gid"));
            check_tile(object.tile, node);
        }
        if (node.has("text")) {
            object.shape = MapShape::Text;
            object.text = node.child("text").text("text");
        }
    }

    const Files& files_;
    std::string_view path_;
    FaultList faults_;
    TileMapReading reading_;
    TileMap& map_ = reading_.map;
    bool has_cells_ = false;    ///< their number and size is known
    bool knows_tiles_ = false;  ///< all tile sets were read, so that other tiles are faults
    bool is_infinite_ = false;
    int first_column_ = 0;  ///< as the file counts, where the map's first cell is
    int first_row_ = 0;
    Vec2 editor_origin_;
};

}  // namespace

TileMapReading read_tile_map(const Files& files, std::string_view path) {
    return MapReader(files, path).read();
}

Result<TileMap> load_tile_map(const Files& files, std::string_view path) {
    TileMapReading reading = read_tile_map(files, path);
    if (!reading.faults.empty()) return Error{std::move(reading.faults.front())};
    return std::move(reading.map);
}

}  // namespace cairn::engine
