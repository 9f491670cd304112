// The rewriting. Source: the pages "TMX Map Format" and "JSON Map Format" of Tiled's manual.
#include "assets/tiled_xml.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "assets/tiled_node.h"

namespace cairn::engine {
namespace {

using Json = nlohmann::ordered_json;

/// Attributes that are words even when they look like numbers.
constexpr std::array<std::string_view, 9> kTexts = {"name",  "value", "type",     "class",      "source",
                                                    "color", "trans", "encoding", "compression"};

bool is_text(std::string_view name) {
    for (const std::string_view text : kTexts)
        if (name == text) return true;
    return false;
}

/// Words like "nan" and "inf" are read as numbers, but no JSON can say them.
Json number_or_text(std::string_view text) {
    double value = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end.ec == std::errc{} && end.ptr == text.data() + text.size() && std::isfinite(value)) return value;
    return std::string(text);
}

Json flag_or_text(std::string_view text) {
    if (text == "true" || text == "false") return text == "true";
    return std::string(text);
}

/// "x,y x,y ..." as [{"x": .., "y": ..}, ...].
Json points(std::string_view text) {
    Json list = Json::array();
    while (!text.empty()) {
        const std::size_t space = std::min(text.find(' '), text.size());
        const std::string_view pair = text.substr(0, space);
        const std::size_t comma = std::min(pair.find(','), pair.size());
        list.push_back({{"x", number_or_text(pair.substr(0, comma))},
                        {"y", number_or_text(pair.substr(std::min(comma + 1, pair.size())))}});
        text.remove_prefix(std::min(space + 1, text.size()));
    }
    return list;
}

void read_transparent_color(const pugi::xml_node& image, Json& json) {
    if (image.attribute("trans")) json["transparentcolor"] = image.attribute("trans").value();
}

/// The tiles of a layer or of a chunk: text in some encoding, or an element for each, without `gid` where the
/// cell is empty.
Json tiles(const pugi::xml_node& data) {
    if (!data.child("tile")) return data.child_value();
    Json list = Json::array();
    for (const pugi::xml_node& tile : data.children("tile")) {
        const std::string_view text = tile.attribute("gid").as_string("0");
        std::uint32_t bits = 0;
        const auto end = std::from_chars(text.data(), text.data() + text.size(), bits);
        const bool is_number = end.ec == std::errc{} && end.ptr == text.data() + text.size();
        list.push_back(is_number ? Json(bits) : Json(text));
    }
    return list;
}

/// What an image layer says about its picture.
void read_image(const pugi::xml_node& layer, Json& json) {
    const pugi::xml_node image = layer.child("image");
    if (image.attribute("source")) json["image"] = image.attribute("source").value();
    read_transparent_color(image, json);
    for (const char* field : {"repeatx", "repeaty"})
        if (json.contains(field)) json[field] = json[field] != 0;
}

/// With the line of each element.
class Rewriter {
  public:
    explicit Rewriter(std::string_view xml) {
        for (std::size_t end = xml.find('\n'); end != std::string_view::npos; end = xml.find('\n', end + 1))
            line_ends_.push_back(end);
    }

    [[nodiscard]] int line_at(std::ptrdiff_t byte) const {
        const auto ends =
            std::lower_bound(line_ends_.begin(), line_ends_.end(), static_cast<std::size_t>(byte));
        return static_cast<int>(ends - line_ends_.begin()) + 1;
    }

    Json map(const pugi::xml_node& map) const {
        Json json = attributes(map);
        // What stays a text in JSON too.
        json["infinite"] = map.attribute("infinite").as_int() != 0;
        if (const pugi::xml_attribute color = map.attribute("backgroundcolor"))
            json["backgroundcolor"] = color.value();
        json["properties"] = properties(map);
        Json sets = Json::array();
        for (const pugi::xml_node& set : map.children("tileset")) sets.push_back(tile_set(set));
        json["tilesets"] = std::move(sets);
        json["layers"] = layers(map);
        return json;
    }

    Json tile_set(const pugi::xml_node& node) const {
        Json json = attributes(node);
        json["properties"] = properties(node);
        if (const pugi::xml_node image = node.child("image")) {
            json["image"] = image.attribute("source").value();
            json["imagewidth"] = number_or_text(image.attribute("width").value());
            json["imageheight"] = number_or_text(image.attribute("height").value());
            read_transparent_color(image, json);
        }
        if (const pugi::xml_node offset = node.child("tileoffset")) json["tileoffset"] = attributes(offset);
        Json tiles = Json::array();
        for (const pugi::xml_node& tile : node.children("tile")) {
            Json entry = attributes(tile);
            entry["properties"] = properties(tile);
            if (const pugi::xml_node image = tile.child("image"))
                entry["image"] = image.attribute("source").value();
            if (const pugi::xml_node animation = tile.child("animation")) {
                Json frames = Json::array();
                for (const pugi::xml_node& frame : animation.children("frame"))
                    frames.push_back(attributes(frame));
                entry["animation"] = std::move(frames);
            }
            tiles.push_back(std::move(entry));
        }
        json["tiles"] = std::move(tiles);
        return json;
    }

  private:
    [[nodiscard]] int line_of(const pugi::xml_node& node) const { return line_at(node.offset_debug()); }

    Json attributes(const pugi::xml_node& node) const {
        Json json = Json::object();
        json[kLineMember] = line_of(node);
        for (const pugi::xml_attribute& attribute : node.attributes()) {
            const std::string_view name = attribute.name();
            json[std::string(name)] =
                is_text(name) ? Json(attribute.value()) : number_or_text(attribute.value());
        }
        // XML says 0 and 1 where JSON says false and true.
        if (json.contains("visible")) json["visible"] = json["visible"] != 0;
        return json;
    }

    Json properties(const pugi::xml_node& node) const {
        Json list = Json::array();
        for (const pugi::xml_node& property : node.child("properties").children("property")) {
            Json entry = attributes(property);
            // A text of several lines stands inside.
            const std::string value =
                property.attribute("value") ? property.attribute("value").value() : property.child_value();
            const std::string type = entry.value("type", "string");
            if (type == "bool")
                entry["value"] = flag_or_text(value);
            else if (type == "int" || type == "float" || type == "object")
                entry["value"] = number_or_text(value);
            else
                entry["value"] = value;
            list.push_back(std::move(entry));
        }
        return list;
    }

    Json object(const pugi::xml_node& node) const {
        Json json = attributes(node);
        json["properties"] = properties(node);
        if (node.child("ellipse")) json["ellipse"] = true;
        if (node.child("point")) json["point"] = true;
        if (const pugi::xml_node text = node.child("text")) json["text"] = {{"text", text.child_value()}};
        for (const char* name : {"polygon", "polyline"})
            if (const pugi::xml_node shape = node.child(name))
                json[name] = points(shape.attribute("points").value());
        return json;
    }

    Json layers(const pugi::xml_node& parent) const {
        Json list = Json::array();
        for (const pugi::xml_node& node : parent.children()) {
            const std::string_view name = node.name();
            if (name != "layer" && name != "objectgroup" && name != "group" && name != "imagelayer") continue;
            Json json = attributes(node);
            json["properties"] = properties(node);
            json["type"] = name == "layer" ? "tilelayer" : std::string(name);
            if (name == "group") json["layers"] = layers(node);
            if (name == "imagelayer") read_image(node, json);
            if (name == "layer") {
                const pugi::xml_node data = node.child("data");
                for (const char* field : {"encoding", "compression"})
                    if (data.attribute(field)) json[field] = data.attribute(field).value();
                json["data"] = tiles(data);
                for (const pugi::xml_node& part : data.children("chunk")) {
                    Json chunk = attributes(part);
                    chunk["data"] = tiles(part);
                    json["chunks"].push_back(std::move(chunk));
                }
            }
            if (name == "objectgroup") {
                Json objects = Json::array();
                for (const pugi::xml_node& child : node.children("object")) objects.push_back(object(child));
                json["objects"] = std::move(objects);
            }
            list.push_back(std::move(json));
        }
        return list;
    }

    std::vector<std::size_t> line_ends_;
};

/// Walks without a stack of its own.
struct NestingCheck : pugi::xml_tree_walker {
    bool for_each(pugi::xml_node&) override { return depth() < kMaxNesting; }
};

}  // namespace

Json tiled_json_from_xml(std::string_view xml) {
    const Rewriter rewriter(xml);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(xml.data(), xml.size());
    if (!parsed)
        throw Fault{std::string("the XML is broken: ") + parsed.description(),
                    static_cast<int>(rewriter.line_at(parsed.offset))};
    NestingCheck check;
    if (!document.traverse(check))
        throw Fault{"the XML is nested more than " + std::to_string(kMaxNesting) + " deep"};
    if (const pugi::xml_node set = document.child("tileset")) return rewriter.tile_set(set);
    const pugi::xml_node map = document.child("map");
    if (!map) throw Fault{"it holds neither a <map> nor a <tileset>"};
    return rewriter.map(map);
}

}  // namespace cairn::engine
