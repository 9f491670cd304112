// An object's class says what is made of it; what its values are called there stands in their origins.
#include "level/tiled_level.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "level/cell_outlines.h"
#include "level/format.h"
#include "level/tiled_values.h"

namespace cairn::scripting {
namespace {

using engine::MapLayer;
using engine::MapObject;
using engine::MapShape;
using engine::Vec2;

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
    MapReader(const engine::TileMapReading& reading, double scale, std::vector<TiledFault>& faults)
        : map_(reading.map),
          map_thing_{"the map", 0, &reading.unreadable},
          lacks_objects_(reading.lacks_objects),
          scale_(scale),
          faults_(faults) {}

    Value read() {
        for (auto& [name, list] : lists_) list = new_table();
        for (const MapLayer& layer : map_.layers) {
            if (layer.kind == MapLayer::Kind::Tiles) {
                read_tiles(layer);
            } else {
                for (const MapObject& object : layer.objects) read_object(object);
            }
        }
        if (lacks_objects_) add_unknown();
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
    static TiledThing thing_of(const MapObject& object) {
        return {object.place, object.line, &object.unreadable};
    }

    Value& list(std::string_view name) {
        return std::find_if(std::begin(lists_), std::end(lists_),
                            [&](const auto& l) { return l.first == name; })
            ->second;
    }
    /// Whatever it is, it may have any name.
    void add_unknown() {
        Value body = new_table();
        add_entry(body, "name", unreadable_value());
        add_entry(body, "shape", unreadable_value());
        add_item(list("bodies"), std::move(body));
    }

    double height_m() const { return map_.rows * map_.tile_size.height * scale_; }
    double x_m(float x) const { return static_cast<double>(x) * scale_; }
    double y_m(float y) const { return height_m() - static_cast<double>(y) * scale_; }

    /// What follows from a number of pixels that the object has: value = offset + per_pixel * pixels.
    Value from_pixels(const MapObject& object, const char* member, float pixels, double value,
                      double per_pixel) const {
        return value_of(thing_of(object), to_value(value),
                        {.member = member,
                         .written = written_number(pixels, kPixels),
                         .unit = kPixels,
                         .offset = value - per_pixel * static_cast<double>(pixels),
                         .per_unit = per_pixel});
    }
    Value length_value(const MapObject& object, const char* member, float pixels, double per_pixel) const {
        if (thing_of(object).lacks(member)) return unreadable_value();
        return from_pixels(object, member, pixels, per_pixel * static_cast<double>(pixels), per_pixel);
    }
    void set_size(Value& table, const MapObject& object) const {
        add_entry(table, "width", length_value(object, "width", object.size.x, scale_));
        add_entry(table, "height", length_value(object, "height", object.size.y, scale_));
    }
    /// A place that follows from the object's own and the other attributes.
    void set_place(Value& table, const MapObject& object, Vec2 place,
                   std::initializer_list<std::string_view> others) const {
        const TiledThing thing = thing_of(object);
        const bool is_lost = thing.lacks_any(others);
        add_entry(table, "x",
                  is_lost || thing.lacks("x")
                      ? unreadable_value()
                      : from_pixels(object, "x", object.position.x, x_m(place.x), scale_));
        add_entry(table, "y",
                  is_lost || thing.lacks("y")
                      ? unreadable_value()
                      : from_pixels(object, "y", object.position.y, y_m(place.y), -scale_));
    }
    void set_angle(Value& table, const MapObject& object) const {
        if (thing_of(object).lacks("rotation")) return add_entry(table, "angle", unreadable_value());
        constexpr float kDegrees = 180 / std::numbers::pi_v<float>;
        add_entry(table, "angle",
                  value_of(thing_of(object), to_value(static_cast<double>(-object.rotation_rad)),
                           {.member = "rotation",
                            .written = written_number(object.rotation_rad * kDegrees, "degrees"),
                            .unit = "degrees",
                            .per_unit = -std::numbers::pi / 180}));
    }

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
            Value files = table_of(map_thing_);
            add_item(files, property_value(map_thing_, "includes", includes->second));
            add_entry(level, "includes", std::move(files));
            properties.erase(includes);
        } else if (map_thing_.lacks_any({"properties", "property includes"})) {
            add_entry(level, "includes", unreadable_value());
        }
        set_properties(level, map_thing_, properties, fields);
        set_unreadable(level, map_thing_, fields);
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
        // Of a layer that could not be read there are none.
        is_solid.resize(static_cast<std::size_t>(map_.columns) * static_cast<std::size_t>(map_.rows));
        const auto outlines = outline_cells(map_.columns, map_.rows, is_solid);
        if (outlines.empty()) return;
        const TiledThing thing{"layer \"" + layer.name + '"', layer.line};
        Value shapes = table_of(thing);
        for (const std::vector<CellCorner>& outline : outlines)
            add_item(shapes, tile_chain(layer, thing, outline));
        Value body = table_of(thing);
        add_entry(body, "type", to_value(std::string("static")));
        add_entry(body, "shapes", std::move(shapes));
        Value data = new_table();
        add_entry(data, "layer", to_value(layer.name));
        add_entry(body, "data", std::move(data));
        add_item(list("bodies"), std::move(body));
    }

    Value tile_chain(const MapLayer& layer, const TiledThing& thing,
                     const std::vector<CellCorner>& outline) const {
        static const std::vector<const Field*> fields = shape_fields("chain");
        Value chain = table_of(thing);
        add_entry(chain, "shape", to_value(std::string("chain")));
        add_entry(chain, "closed", to_value(true));
        Value points = table_of(thing);
        for (const CellCorner& corner : outline) {
            Value point = new_table();
            add_item(point, to_value(x_m(static_cast<float>(corner.column * map_.tile_size.width) +
                                         layer.offset.x)));
            add_item(point,
                     to_value(y_m(static_cast<float>(corner.row * map_.tile_size.height) + layer.offset.y)));
            add_item(points, std::move(point));
        }
        add_entry(chain, "points", std::move(points));
        for (const auto& [name, property] : layer.properties) {
            if (is_field(fields, name) && chain.find(name) == nullptr)
                add_entry(chain, name, property_value(thing, name, property));
        }
        return chain;
    }

    // ---- Objects

    void read_object(const MapObject& object) {
        if (object.kind == "camera") {
            camera_ = table_of(thing_of(object));
            set_middle(*camera_, object);
            add_entry(*camera_, "height", length_value(object, "height", object.size.y, scale_));
        } else if (object.kind == "bounds") {
            read_bounds(object);
        } else if (object.kind == "spawn") {
            static const std::vector<const Field*> fields = all_fields(kSpawnFields);
            Value spawn = named(object);
            set_middle(spawn, object);
            if (object.rotation_rad != 0) set_angle(spawn, object);
            set_properties(spawn, thing_of(object), object.properties, fields);
            add_item(list("spawns"), std::move(spawn));
        } else if (object.kind == "joint" || object.kind == "prefab") {
            read_made(object, object.kind == "joint" ? PartKind::Joint : PartKind::Prefab);
        } else if (object.kind == "trigger") {
            read_trigger(object);
        } else {
            read_body(object);
        }
    }

    void read_bounds(const MapObject& object) {
        const TiledThing thing = thing_of(object);
        const Vec2 corner = object.position;
        const Vec2 end = corner + object.size;
        bounds_ = table_of(thing);
        const auto add = [&](const char* side, bool is_lost, const char* member, float pixels, double value,
                             double per_pixel) {
            add_entry(*bounds_, side,
                      is_lost ? unreadable_value() : from_pixels(object, member, pixels, value, per_pixel));
        };
        add("left", thing.lacks("x"), "x", corner.x, x_m(corner.x), scale_);
        add("bottom", thing.lacks_any({"y", "height"}), "height", object.size.y, y_m(end.y), -scale_);
        add("right", thing.lacks_any({"x", "width"}), "width", object.size.x, x_m(end.x), scale_);
        add("top", thing.lacks("y"), "y", corner.y, y_m(corner.y), -scale_);
    }

    /// Joints and prefabs: their kind and fields are properties.
    void read_made(const MapObject& object, PartKind kind) {
        const TiledThing thing = thing_of(object);
        const PartSection& section = section_of(kind);
        const auto variant = object.properties.find(section.variant);
        const auto* word =
            variant == object.properties.end() ? nullptr : std::get_if<std::string>(&variant->second);
        const std::vector<const Field*> fields = part_fields(kind, word == nullptr ? "" : *word);
        Value part = named(object);
        if (is_field(fields, "x")) set_middle(part, object);
        for (const auto& [name, property] : object.properties) {
            if (part.find(name) == nullptr) add_entry(part, name, property_value(thing, name, property));
        }
        set_unreadable(part, thing, fields);
        // What it should be could not be read, whatever there was.
        if (thing.lacks("properties")) add_entry(part, section.variant, unreadable_value());
        add_item(list(section.list), std::move(part));
    }

    void read_trigger(const MapObject& object) {
        static const std::vector<const Field*> fields = part_fields(PartKind::Trigger, "box");
        Value trigger = named(object);
        set_shape(trigger, object);
        if (const Value* shape = trigger.find("shape");
            shape == nullptr || (!shape->is_unreadable && shape->text() == "chain")) {
            const auto has_shape = [](const Entry& entry) { return entry.key == Key("shape"); };
            std::erase_if(std::get<Entries>(trigger.content), has_shape);
            refuse_form(trigger, object,
                        "a trigger must be a tile, a rectangle, an ellipse or a polygon without dents and "
                        "with at most 8 corners");
        }
        set_properties(trigger, thing_of(object), object.properties, fields);
        set_unreadable(trigger, thing_of(object), fields);
        add_item(list("triggers"), std::move(trigger));
    }

    /// Tells that the object has a form that does not do for its class.
    void refuse_form(Value& part, const MapObject& object, const std::string& rule) {
        // By MapShape.
        constexpr const char* kForms[] = {"a rectangle", "an ellipse", "a point", "such a polygon",
                                          "a line",      "a tile",     "a text"};
        const std::string form = kForms[static_cast<int>(object.shape)];
        const std::string kind = object.kind.empty() ? "" : " of class \"" + object.kind + '"';
        faults_.push_back({object.line, object.place + ": is " + form + kind + ", but " + rule});
        add_entry(part, "shape", unreadable_value());
    }

    void read_body(const MapObject& object) {
        const TiledThing thing = thing_of(object);
        const bool is_plain = (object.kind.empty() && !thing.lacks("class")) || object.kind == "body";
        const bool is_formless = object.shape == MapShape::Text || object.shape == MapShape::Point;
        // Without a class these are pictures, labels and marks.
        if (is_plain && object.kind.empty() && (is_formless || object.shape == MapShape::Tile)) return;
        Value body = named(object);
        if (is_plain) {
            if (is_formless) {
                refuse_form(body, object,
                            "a body must have a form: a tile, a rectangle, an ellipse, a polygon or a line");
            } else {
                set_shape(body, object);
            }
            if (!object.properties.contains("type")) add_entry(body, "type", to_value(std::string("static")));
        } else {
            Value kind = to_value(object.kind);
            const std::string written = to_short_text(kind);
            add_entry(body, "template",
                      thing.lacks("class")
                          ? unreadable_value()
                          : value_of(thing, std::move(kind),
                                     {.member = std::string(kTiledClass), .written = written}));
            set_middle(body, object);
            set_angle(body, object);
            if (object.shape == MapShape::Rectangle && object.size.x > 0) set_size(body, object);
        }
        set_properties(body, thing, object.properties, body_fields());
        set_unreadable(body, thing, body_fields());
        add_item(list("bodies"), std::move(body));
    }

    static Value named(const MapObject& object) {
        const TiledThing thing = thing_of(object);
        Value table = table_of(thing);
        const Value name = to_value(object.name);
        if (thing.lacks("name")) {
            add_entry(table, "name", unreadable_value());
        } else if (!object.name.empty()) {
            add_entry(table, "name",
                      value_of(thing, name, {.member = "name", .written = to_short_text(name)}));
        }
        return table;
    }

    /// Tiled turns an object about its position; what is made is placed by its middle.
    void set_middle(Value& table, const MapObject& object) const {
        const Vec2 middle = {(0.5f - object.anchor.x) * object.size.x,
                             (0.5f - object.anchor.y) * object.size.y};
        const engine::Affine2 turn =
            engine::Affine2::translation(object.position) * engine::Affine2::rotation(object.rotation_rad);
        set_place(table, object, turn.apply(middle), {"width", "height", "rotation"});
    }

    void set_shape(Value& table, const MapObject& object) const {
        const TiledThing thing = thing_of(object);
        if (object.rotation_rad != 0 || thing.lacks("rotation")) set_angle(table, object);
        if (thing.lacks("shape")) {
            add_entry(table, "shape", unreadable_value());
            return;
        }
        switch (object.shape) {
            case MapShape::Rectangle:
            case MapShape::Tile:
                add_entry(table, "shape", to_value(std::string("box")));
                set_middle(table, object);
                set_size(table, object);
                return;
            case MapShape::Ellipse:
                set_middle(table, object);
                set_ellipse(table, object);
                return;
            case MapShape::Polygon:
            case MapShape::Polyline:
                set_place(table, object, object.position, {});
                set_points(table, object);
                return;
            case MapShape::Point:
            case MapShape::Text:
                set_middle(table, object);
                return;
        }
    }

    void set_ellipse(Value& table, const MapObject& object) const {
        const bool is_lost = thing_of(object).lacks_any({"width", "height"});
        if (object.size.x == object.size.y || is_lost) {
            add_entry(table, "shape", to_value(std::string("circle")));
            add_entry(
                table, "radius",
                is_lost ? unreadable_value() : length_value(object, "width", object.size.x, scale_ / 2));
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
        add_entry(table, "points", local_points(object, "", corners));
    }

    /// Of points with y up, in pixels.
    Value local_points(const MapObject& object, const char* member, const std::vector<Vec2>& points) const {
        Value list = value_of(thing_of(object), new_table(), {.member = member});
        for (const Vec2 p : points) {
            Value point = new_table();
            add_item(point, to_value(static_cast<double>(p.x) * scale_));
            add_item(point, to_value(static_cast<double>(p.y) * scale_));
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
        add_entry(table, "points", local_points(object, is_closed ? "polygon" : "polyline", points));
    }

    static constexpr std::string_view kPixels = "pixels";

    const engine::TileMap& map_;
    TiledThing map_thing_;
    bool lacks_objects_;
    double scale_;
    std::vector<TiledFault>& faults_;
    std::pair<const char*, Value> lists_[5] = {
        {"bodies", {}}, {"triggers", {}}, {"prefabs", {}}, {"joints", {}}, {"spawns", {}}};
    std::optional<Value> camera_;
    std::optional<Value> bounds_;
};

/// "PATH:LINE: TEXT" as the line and the text.
TiledFault placed_fault(const std::string& path, const std::string& fault) {
    TiledFault placed;
    const std::string start = path + ':';
    const char* const end = fault.data() + fault.size();
    if (fault.starts_with(start)) {
        const auto read = std::from_chars(fault.data() + start.size(), end, placed.line);
        if (read.ec == std::errc() && end - read.ptr > 2) {
            placed.text = std::string(read.ptr + 2, end);
            return placed;
        }
    }
    return {0, fault};
}

}  // namespace

std::span<const std::string_view> tiled_classes() {
    static constexpr std::string_view kClasses[] = {"body",   "trigger", "spawn", "camera",
                                                    "bounds", "joint",   "prefab"};
    return kClasses;
}

std::optional<Value> tiled_level(const engine::Files& files, std::string_view path, double scale,
                                 std::vector<TiledFault>& faults) {
    const engine::TileMapReading reading = engine::read_tile_map(files, path);
    for (const std::string& fault : reading.faults) faults.push_back(placed_fault(std::string(path), fault));
    if (!reading.is_map) return std::nullopt;
    if (reading.map.grid != engine::MapGrid::Orthogonal) {
        faults.push_back({0, std::string(path) +
                                 ": levels are made of orthogonal maps; this one is isometric, staggered or "
                                 "hexagonal"});
    }
    // Where the size of a tile is a fault, any scale does for finding more.
    if (!(scale > 0)) scale = 1.0 / std::max(1, reading.map.tile_size.width);
    return MapReader(reading, scale, faults).read();
}

}  // namespace cairn::scripting
