// Reads tile sets, and files of the editor in either of its formats.
#include "assets/tile_set_reader.h"

#include "assets/json_text.h"
#include "assets/tiled_xml.h"

namespace cairn::engine {

std::string tiled_path_beside(std::string_view path, const std::string& name) {
    std::vector<std::string> parts;
    const std::size_t slash = path.rfind('/');
    std::string all = (slash == std::string_view::npos ? "" : std::string(path.substr(0, slash + 1))) + name;
    std::size_t begin = 0;
    while (begin <= all.size()) {
        const std::size_t end = std::min(all.find('/', begin), all.size());
        const std::string part = all.substr(begin, end - begin);
        if (part == ".." && !parts.empty() && parts.back() != "..")
            parts.pop_back();
        else if (part != "." && !part.empty())
            parts.push_back(part);
        begin = end + 1;
    }
    std::string result;
    for (const std::string& part : parts) result += (result.empty() ? "" : "/") + part;
    return result;
}

Json read_tiled_file(const Files& files, std::string_view path) {
    const Result<std::string> text = files.read_text(path);
    if (!text) throw Fault{text.error().message};
    if (path.ends_with(".tmx") || path.ends_with(".tsx") || path.ends_with(".xml"))
        return tiled_json_from_xml(*text);
    int fault_line = 0;
    Result<Json> json = json_with_lines(*text, fault_line);
    if (!json) throw Fault{json.error().message, fault_line};
    return std::move(*json);
}

Node called_by_name(const Node& node, const std::string& what, const std::string& where) {
    std::string text = what;
    if (node.has("id") && node.at("id").is_number()) {
        const double id = node.at("id").get<double>();
        if (id > 0 && id < (1 << 30)) text += ' ' + std::to_string(static_cast<int>(id));
    }
    if (node.has("name") && node.at("name").is_string()) {
        const std::string name = node.at("name").get<std::string>();
        if (!name.empty()) text += " \"" + name + '"';
    }
    return text == what ? node : node.called(text + where);
}

namespace {

/// `place` is what the property is called.
TileProperty read_property(const Node& property, const std::string& place) {
    const Json& value = property.at("value");
    const std::string type = property.text("type", "");
    const auto fail = [&](const std::string& rule) {
        throw Fault{place + " is " + excerpt(value) + ", but must be " + rule, property.line()};
    };
    // What is of another type than the file says was no such thing there: "nan" is no number.
    if ((type == "int" || type == "float") && !value.is_number()) fail("a number: its type is " + type);
    if (type == "bool" && !value.is_boolean()) fail("true or false: its type is bool");
    if (value.is_boolean()) return value.get<bool>();
    if (value.is_number()) return value.get<double>();
    if (!value.is_string()) fail("a text, a number, true or false");
    return value.get<std::string>();
}

}  // namespace

TileProperties read_tiled_properties(const Node& node, FaultList& faults, Names& unreadable) {
    TileProperties properties;
    const bool is_list = faults.attempt([&] {
        for (const Node& property : node.list("properties")) {
            std::string name;
            if (!faults.attempt([&] { name = property.text("name"); }) || !property.has("value")) continue;
            const std::string told = "property \"" + name + '"';
            const std::string place = (node.place().empty() ? "" : node.place() + ": ") + told;
            const bool is_good = faults.attempt([&] { properties[name] = read_property(property, place); });
            if (!is_good) unreadable.insert("property " + name);
        }
    });
    if (!is_list) unreadable.insert("properties");
    return properties;
}

std::optional<Color> read_tiled_color(const Node& node, const char* field) {
    if (!node.has(field)) return std::nullopt;
    std::string text = node.text(field);
    if (text.starts_with('#')) text.erase(0, 1);
    if (text.size() == 6) text = "ff" + text;
    if (text.size() != 8 || text.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos)
        node.fail(field, "must be a color like \"#rrggbb\"");
    const auto part = [&](std::size_t at) {
        return static_cast<float>(std::stoi(text.substr(at, 2), nullptr, 16)) / 255;
    };
    return Color{part(2), part(4), part(6), part(0)};
}

namespace {

/// As Tiled names the places of the nine, from the top left.
std::optional<Vec2> read_object_anchor(const Node& set) {
    constexpr const char* kNames[] = {"topleft", "top",        "topright", "left",       "center",
                                      "right",   "bottomleft", "bottom",   "bottomright"};
    const std::string name = set.text("objectalignment", "unspecified");
    if (name == "unspecified") return std::nullopt;
    for (int i = 0; i < 9; ++i)
        if (name == kNames[i])
            return Vec2{0.5f * static_cast<float>(i % 3), 0.5f * static_cast<float>(i / 3)};
    set.fail("objectalignment",
             "must be unspecified, topleft, top, topright, left, center, right, bottomleft, bottom or "
             "bottomright");
}

void read_kind_of_tile(const Node& tile, TileSet& set, FaultList& faults) {
    const std::uint32_t id =
        set.first_id + static_cast<std::uint32_t>(tile.whole("id", 0, set.tile_count - 1));
    Names unreadable;
    TileProperties properties = read_tiled_properties(tile, faults, unreadable);
    const std::string kind = tile.text("class", tile.text("type"));
    if (!kind.empty()) properties.emplace("class", kind);
    if (!properties.empty()) set.properties[id] = std::move(properties);
    for (const Node& frame : tile.list("animation"))
        set.animations[id].push_back(
            {set.first_id + static_cast<std::uint32_t>(frame.whole("tileid", 0, set.tile_count - 1)),
             frame.whole("duration", 1, 3'600'000) / 1000.0});
}

}  // namespace

TileSet read_tile_set(const Node& node, std::uint32_t first_id, std::string_view path, FaultList& faults) {
    TileSet set;
    set.first_id = first_id;
    set.place = faults.start(node.line()) + node.place();
    faults.attempt([&] { set.name = node.text("name"); });
    faults.attempt([&] {
        if (!node.has("image"))
            node.fail("image",
                      "must name the picture of all its tiles; sets of single pictures are not known");
        set.image_path = tiled_path_beside(path, node.text("image"));
    });
    faults.attempt([&] { set.transparent = read_tiled_color(node, "transparentcolor"); });
    faults.attempt([&] { set.object_anchor = read_object_anchor(node); });
    faults.attempt([&] {
        if (!node.has("tileoffset")) return;
        const Node offset = node.child("tileoffset");
        constexpr int kFarthest = 1'000'000;
        set.tile_offset = {static_cast<float>(offset.whole("x", -kFarthest, kFarthest, 0)),
                           static_cast<float>(offset.whole("y", -kFarthest, kFarthest, 0))};
    });
    const auto whole = [&](int& to, const char* field, int low, int high) {
        faults.attempt([&] { to = node.whole(field, low, high); });
    };
    whole(set.tile_size.width, "tilewidth", 1, 4096);
    whole(set.tile_size.height, "tileheight", 1, 4096);
    whole(set.columns, "columns", 1, 8192);
    whole(set.tile_count, "tilecount", 1, 1 << 24);
    faults.attempt([&] { set.margin = node.whole("margin", 0, 4096, 0); });
    faults.attempt([&] { set.spacing = node.whole("spacing", 0, 4096, 0); });
    if (set.tile_count < 1) return set;  // then no tile can be of it
    faults.attempt([&] {
        for (const Node& tile : node.list("tiles"))
            faults.attempt([&] { read_kind_of_tile(tile, set, faults); });
    });
    return set;
}

}  // namespace cairn::engine
