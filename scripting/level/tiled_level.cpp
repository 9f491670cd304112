// Source of the outlines: each cell's border runs anticlockwise; what two solid cells share cancels, and the
// rest is linked end to end, by the leftmost turn where there is a choice.
#include "level/tiled_level.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "level/format.h"

namespace cairn::scripting {
namespace {

using engine::MapLayer;
using engine::MapObject;
using engine::MapShape;
using engine::Vec2;

Value to_value(double number) {
    Value value;
    // The editor does not tell 1 from 1.0; bit sets and counts are integers here.
    if (std::abs(number) < 1e15 && number == std::floor(number)) {
        value.content = static_cast<std::int64_t>(number);
    } else {
        value.content = number;
    }
    return value;
}
Value to_value(const std::string& text) {
    Value value;
    value.content = text;
    return value;
}
Value to_value(bool is_true) {
    Value value;
    value.content = is_true;
    return value;
}
Value new_table() {
    Value value;
    value.content = Entries{};
    return value;
}
Value to_value(const engine::TileProperty& property) {
    return std::visit([](const auto& content) { return to_value(content); }, property);
}

bool is_field(const std::vector<const Field*>& fields, std::string_view name) {
    return std::any_of(fields.begin(), fields.end(), [&](const Field* field) { return name == field->name; });
}

/// Those that are fields; the others go into `data`.
void set_properties(Value& table, const engine::TileProperties& properties,
                    const std::vector<const Field*>& fields) {
    Value data = new_table();
    for (const auto& [name, property] : properties) {
        const bool is_known = is_field(fields, name) && name != "data";
        if (table.find(name) == nullptr) add_entry(is_known ? table : data, name, to_value(property));
    }
    if (!data.entries().empty() && is_field(fields, "data")) add_entry(table, "data", std::move(data));
}

/// Twice the area to the left of the outline.
float signed_area(const std::vector<Vec2>& points) {
    float area = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 a = points[i];
        const Vec2 b = points[(i + 1) % points.size()];
        area += a.x * b.y - a.y * b.x;
    }
    return area;
}

/// Of an anticlockwise outline.
bool is_convex(const std::vector<Vec2>& points) {
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 a = points[i];
        const Vec2 b = points[(i + 1) % count];
        const Vec2 c = points[(i + 2) % count];
        if ((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) < 0) return false;
    }
    return true;
}

class MapReader {
  public:
    /// Objects that cannot be what their class says are told in `faults`.
    MapReader(const engine::TileMap& map, double scale, std::vector<std::string>& faults)
        : map_(map), scale_(scale), faults_(faults) {}

    Value read() {
        for (auto& [name, list] : lists_) list = new_table();
        for (const MapLayer& layer : map_.layers) {
            if (layer.kind == MapLayer::Kind::Tiles) {
                read_tiles(layer);
            } else {
                for (const MapObject& object : layer.objects) read_object(object);
            }
        }
        Value level = new_table();
        read_own(level);
        for (auto& [name, list] : lists_) {
            if (!list.entries().empty()) add_entry(level, name, std::move(list));
        }
        return level;
    }

  private:
    static const std::vector<const Field*>& body_fields() {
        static const std::vector<const Field*> fields = fields_of_any_body();
        return fields;
    }

    Value& list(std::string_view name) {
        return std::find_if(std::begin(lists_), std::end(lists_),
                            [&](const auto& l) { return l.first == name; })
            ->second;
    }

    double height_m() const { return map_.rows * map_.tile_size.height * scale_; }
    Value x_value(float x) const { return to_value(static_cast<double>(x) * scale_); }
    Value y_value(float y) const { return to_value(height_m() - static_cast<double>(y) * scale_); }
    Value length_value(float length) const { return to_value(static_cast<double>(length) * scale_); }

    void read_own(Value& level) const {
        static const std::vector<const Field*> fields = [] {
            std::vector<const Field*> all = all_fields(kLevelFields);
            std::erase_if(all, [](const Field* field) {
                return field->type == FieldType::Table && std::string_view(field->name) != "data";
            });
            return all;
        }();
        engine::TileProperties properties = map_.properties;
        if (const auto includes = properties.find("includes"); includes != properties.end()) {
            Value files = new_table();
            add_item(files, to_value(includes->second));
            add_entry(level, "includes", std::move(files));
            properties.erase(includes);
        }
        set_properties(level, properties, fields);
        if (camera_) add_entry(level, "camera", *camera_);
        if (bounds_) add_entry(level, "bounds", *bounds_);
    }

    // ---- Tiles

    void read_tiles(const MapLayer& layer) {
        const auto says = [](const engine::TileProperties& properties) {
            const auto found = properties.find("solid");
            const bool* is_solid = found == properties.end() ? nullptr : std::get_if<bool>(&found->second);
            return is_solid != nullptr && *is_solid;
        };
        const bool all_solid = says(layer.properties);
        std::vector<bool> is_solid;
        is_solid.reserve(layer.tiles.size());
        for (const engine::Tile& tile : layer.tiles)
            is_solid.push_back(tile.id != 0 && (all_solid || says(map_.properties_of(tile.id))));
        const auto outlines = outline_cells(map_.columns, map_.rows, is_solid);
        if (outlines.empty()) return;
        Value shapes = new_table();
        for (const std::vector<CellCorner>& outline : outlines) add_item(shapes, tile_chain(layer, outline));
        Value body = new_table();
        add_entry(body, "type", to_value(std::string("static")));
        add_entry(body, "shapes", std::move(shapes));
        Value data = new_table();
        add_entry(data, "layer", to_value(layer.name));
        add_entry(body, "data", std::move(data));
        add_item(list("bodies"), std::move(body));
    }

    Value tile_chain(const MapLayer& layer, const std::vector<CellCorner>& outline) const {
        static const std::vector<const Field*> fields = shape_fields("chain");
        Value chain = new_table();
        add_entry(chain, "shape", to_value(std::string("chain")));
        add_entry(chain, "closed", to_value(true));
        Value points = new_table();
        for (const CellCorner& corner : outline) {
            add_item(points,
                     point_value({static_cast<float>(corner.column * map_.tile_size.width) + layer.offset.x,
                                  static_cast<float>(corner.row * map_.tile_size.height) + layer.offset.y}));
        }
        add_entry(chain, "points", std::move(points));
        for (const auto& [name, property] : layer.properties) {
            if (is_field(fields, name) && chain.find(name) == nullptr)
                add_entry(chain, name, to_value(property));
        }
        return chain;
    }

    Value point_value(Vec2 place) const {
        Value point = new_table();
        add_item(point, x_value(place.x));
        add_item(point, y_value(place.y));
        return point;
    }

    // ---- Objects

    void read_object(const MapObject& object) {
        if (object.kind == "camera") {
            camera_ = new_table();
            set_middle(*camera_, object);
            add_entry(*camera_, "height", length_value(object.size.y));
        } else if (object.kind == "bounds") {
            bounds_ = new_table();
            add_entry(*bounds_, "left", x_value(object.position.x));
            add_entry(*bounds_, "bottom", y_value(object.position.y + object.size.y));
            add_entry(*bounds_, "right", x_value(object.position.x + object.size.x));
            add_entry(*bounds_, "top", y_value(object.position.y));
        } else if (object.kind == "spawn") {
            static const std::vector<const Field*> fields = all_fields(kSpawnFields);
            Value spawn = named(object);
            set_middle(spawn, object);
            if (object.rotation_rad != 0)
                add_entry(spawn, "angle", to_value(static_cast<double>(-object.rotation_rad)));
            set_properties(spawn, object.properties, fields);
            add_item(list("spawns"), std::move(spawn));
        } else if (object.kind == "joint" || object.kind == "prefab") {
            read_made(object, object.kind == "joint" ? PartKind::Joint : PartKind::Prefab);
        } else if (object.kind == "trigger") {
            static const std::vector<const Field*> fields = part_fields(PartKind::Trigger, "box");
            Value trigger = named(object);
            set_shape(trigger, object);
            set_properties(trigger, object.properties, fields);
            add_item(list("triggers"), std::move(trigger));
        } else {
            read_body(object);
        }
    }

    /// Joints and prefabs: their kind and fields are properties.
    void read_made(const MapObject& object, PartKind kind) {
        const PartSection& section = section_of(kind);
        const auto variant = object.properties.find(section.variant);
        const auto* word =
            variant == object.properties.end() ? nullptr : std::get_if<std::string>(&variant->second);
        const std::vector<const Field*> fields = part_fields(kind, word == nullptr ? "" : *word);
        Value part = named(object);
        if (is_field(fields, "x")) set_middle(part, object);
        for (const auto& [name, property] : object.properties) {
            if (part.find(name) == nullptr) add_entry(part, name, to_value(property));
        }
        add_item(list(section.list), std::move(part));
    }

    void read_body(const MapObject& object) {
        const bool is_plain = object.kind.empty() || object.kind == "body";
        const bool is_formless = object.shape == MapShape::Text || object.shape == MapShape::Point;
        // Without a class these are pictures, labels and marks.
        if (object.kind.empty() && (is_formless || object.shape == MapShape::Tile)) return;
        if (is_plain && is_formless) {
            faults_.push_back("object " + std::to_string(object.id) +
                              (object.name.empty() ? "" : " \"" + object.name + '"') + " is a " +
                              (object.shape == MapShape::Text ? "text" : "point") +
                              " of class \"body\", but a body must have a form: a tile, a rectangle, an "
                              "ellipse, a polygon or a line");
            return;
        }
        Value body = named(object);
        if (!is_plain) add_entry(body, "template", to_value(object.kind));
        const bool has_shape = object.shape != MapShape::Point && object.shape != MapShape::Tile;
        if (is_plain) {
            set_shape(body, object);
            if (!object.properties.contains("type")) add_entry(body, "type", to_value(std::string("static")));
        } else {
            set_middle(body, object);
            add_entry(body, "angle", to_value(static_cast<double>(-object.rotation_rad)));
            if (has_shape && object.size.x > 0 && object.shape == MapShape::Rectangle) {
                add_entry(body, "width", length_value(object.size.x));
                add_entry(body, "height", length_value(object.size.y));
            }
        }
        set_properties(body, object.properties, body_fields());
        add_item(list("bodies"), std::move(body));
    }

    static Value named(const MapObject& object) {
        Value table = new_table();
        if (!object.name.empty()) add_entry(table, "name", to_value(object.name));
        return table;
    }

    /// Tiled turns an object about its position; what is made is placed by its middle.
    void set_middle(Value& table, const MapObject& object) const {
        Vec2 middle = object.size * 0.5f;
        if (object.shape == MapShape::Tile) middle.y = -middle.y;
        const engine::Affine2 turn =
            engine::Affine2::translation(object.position) * engine::Affine2::rotation(object.rotation_rad);
        const Vec2 place = turn.apply(middle);
        add_entry(table, "x", x_value(place.x));
        add_entry(table, "y", y_value(place.y));
    }

    void set_shape(Value& table, const MapObject& object) const {
        if (object.rotation_rad != 0)
            add_entry(table, "angle", to_value(static_cast<double>(-object.rotation_rad)));
        const auto say = [&](const char* shape) { add_entry(table, "shape", to_value(std::string(shape))); };
        switch (object.shape) {
            case MapShape::Rectangle:
            case MapShape::Tile:
                say("box");
                set_middle(table, object);
                add_entry(table, "width", length_value(object.size.x));
                add_entry(table, "height", length_value(object.size.y));
                return;
            case MapShape::Ellipse:
                set_middle(table, object);
                set_ellipse(table, object);
                return;
            case MapShape::Polygon:
            case MapShape::Polyline:
                add_entry(table, "x", x_value(object.position.x));
                add_entry(table, "y", y_value(object.position.y));
                set_points(table, object);
                return;
            case MapShape::Point:
            case MapShape::Text:
                set_middle(table, object);
                return;
        }
    }

    void set_ellipse(Value& table, const MapObject& object) const {
        if (object.size.x == object.size.y) {
            add_entry(table, "shape", to_value(std::string("circle")));
            add_entry(table, "radius", length_value(object.size.x / 2));
            return;
        }
        // Eight corners on it: what a polygon can have.
        add_entry(table, "shape", to_value(std::string("polygon")));
        constexpr float kDiagonal = 0.70710678f;
        constexpr Vec2 kDirections[] = {{1, 0},  {kDiagonal, kDiagonal},   {0, 1},  {-kDiagonal, kDiagonal},
                                        {-1, 0}, {-kDiagonal, -kDiagonal}, {0, -1}, {kDiagonal, -kDiagonal}};
        std::vector<Vec2> corners;
        for (const Vec2 d : kDirections)
            corners.push_back({d.x * object.size.x / 2, d.y * object.size.y / 2});
        add_entry(table, "points", local_points(corners));
    }

    /// Of points with y up, in pixels.
    Value local_points(const std::vector<Vec2>& points) const {
        Value list = new_table();
        for (const Vec2 p : points) {
            Value point = new_table();
            add_item(point, length_value(p.x));
            add_item(point, length_value(p.y));
            add_item(list, std::move(point));
        }
        return list;
    }

    void set_points(Value& table, const MapObject& object) const {
        std::vector<Vec2> points;
        for (const Vec2 p : object.points) points.push_back({p.x, -p.y});
        const bool is_closed = object.shape == MapShape::Polygon;
        // Outlines keep things out; open lines are solid from above, however they were drawn.
        const bool is_wrong_way =
            is_closed ? signed_area(points) < 0 : !points.empty() && points.front().x < points.back().x;
        if (is_wrong_way) std::reverse(points.begin(), points.end());
        const bool is_polygon = is_closed && points.size() <= 8 && is_convex(points);
        add_entry(table, "shape", to_value(std::string(is_polygon ? "polygon" : "chain")));
        if (is_closed && !is_polygon) add_entry(table, "closed", to_value(true));
        add_entry(table, "points", local_points(points));
    }

    const engine::TileMap& map_;
    double scale_;
    std::vector<std::string>& faults_;
    std::pair<const char*, Value> lists_[5] = {
        {"bodies", {}}, {"triggers", {}}, {"prefabs", {}}, {"joints", {}}, {"spawns", {}}};
    std::optional<Value> camera_;
    std::optional<Value> bounds_;
};

}  // namespace

std::vector<std::vector<CellCorner>> outline_cells(int columns, int rows, const std::vector<bool>& is_solid) {
    // Directions: 0 right, 1 up, 2 left, 3 down. An edge is known by its first corner and its direction.
    constexpr int kSteps[4][2] = {{1, 0}, {0, -1}, {-1, 0}, {0, 1}};
    const int corner_columns = columns + 1;
    std::vector<bool> edges(static_cast<std::size_t>(corner_columns * (rows + 1)) * 4, false);
    const auto edge = [&](CellCorner at, int direction) {
        return static_cast<std::size_t>((at.row * corner_columns + at.column) * 4 + direction);
    };
    const auto solid = [&](int column, int row) {
        return column >= 0 && row >= 0 && column < columns && row < rows &&
               is_solid[static_cast<std::size_t>(row * columns + column)];
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            if (!solid(column, row)) continue;
            if (!solid(column, row + 1)) edges[edge({column, row + 1}, 0)] = true;
            if (!solid(column + 1, row)) edges[edge({column + 1, row + 1}, 1)] = true;
            if (!solid(column, row - 1)) edges[edge({column + 1, row}, 2)] = true;
            if (!solid(column - 1, row)) edges[edge({column, row}, 3)] = true;
        }
    }
    std::vector<std::vector<CellCorner>> outlines;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            for (int first = 0; first < 4; ++first) {
                if (!edges[edge({column, row}, first)]) continue;
                std::vector<CellCorner> outline;
                CellCorner at{column, row};
                int direction = first;
                int previous = -1;
                while (edges[edge(at, direction)]) {
                    edges[edge(at, direction)] = false;
                    if (direction != previous) outline.push_back(at);
                    previous = direction;
                    at = {at.column + kSteps[direction][0], at.row + kSteps[direction][1]};
                    for (const int turn : {1, 0, 3}) {
                        const int next = (direction + turn) % 4;
                        if (!edges[edge(at, next)]) continue;
                        direction = next;
                        break;
                    }
                }
                if (previous == first) outline.erase(outline.begin());
                outlines.push_back(std::move(outline));
            }
        }
    }
    return outlines;
}

std::optional<Value> tiled_level(const engine::Files& files, std::string_view path, double scale,
                                 std::vector<std::string>& faults) {
    const engine::TileMapReading reading = engine::read_tile_map(files, path);
    faults.insert(faults.end(), reading.faults.begin(), reading.faults.end());
    const engine::TileMap& map = reading.map;
    if (map.grid != engine::MapGrid::Orthogonal) {
        faults.push_back(
            "map '" + std::string(path) +
            "': levels are made of orthogonal maps; this one is isometric, staggered or hexagonal");
    }
    if (!faults.empty()) return std::nullopt;
    std::vector<std::string> wrong;
    Value level = MapReader(map, scale > 0 ? scale : 1.0 / map.tile_size.width, wrong).read();
    for (const std::string& fault : wrong) faults.push_back("map '" + std::string(path) + "': " + fault);
    return level;
}

}  // namespace cairn::scripting
