// Reads atlases. Invariant: nothing of the file is believed before its type was looked at.
#include <cmath>
#include <optional>
#include <set>

#include <cairn/engine/atlas.h>

#include "assets/json_text.h"

namespace cairn::engine {
namespace {

using Json = nlohmann::ordered_json;  // keeps the order of the file

Error atlas_error(std::string_view path, const std::string& reason) {
    return Error{"atlas '" + std::string(path) + "': " + reason};
}

bool is_true(const Json& object, const char* name) {
    const auto found = object.find(name);
    return found != object.end() && found->is_boolean() && found->get<bool>();
}

std::optional<Rect> read_rect(const Json& object) {
    if (!object.is_object()) return std::nullopt;
    Rect rect;
    for (const auto& [name, part] : {std::pair{"x", &rect.x}, std::pair{"y", &rect.y},
                                     std::pair{"w", &rect.width}, std::pair{"h", &rect.height}}) {
        const auto found = object.find(name);
        if (found == object.end() || !found->is_number()) return std::nullopt;
        *part = found->get<float>();
        if (!std::isfinite(*part)) return std::nullopt;
    }
    return rect;
}

/// The folder of a path, with its slash.
std::string folder_of(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? "" : std::string(path.substr(0, slash + 1));
}

Result<void> add_frame(const std::string& name, const Json& entry, std::string_view path, Atlas& atlas) {
    if (!entry.is_object() || !entry.contains("frame"))
        return atlas_error(path, "frame '" + name + "' must be an object with \"frame\"");
    if (is_true(entry, "rotated"))
        return atlas_error(path, "frame '" + name + "' is rotated; let the packer write it without rotation");
    if (is_true(entry, "trimmed"))
        return atlas_error(path, "frame '" + name + "' is trimmed; let the packer write it without trimming");
    const std::optional<Rect> rect = read_rect(entry["frame"]);
    if (!rect || !(rect->width > 0 && rect->height > 0))
        return atlas_error(path,
                           "frame '" + name + "' must have numbers x, y, w and h, with w and h above 0");
    atlas.frames.push_back({name, *rect});
    return {};
}

}  // namespace

Result<Atlas> load_atlas(const Files& files, std::string_view path) {
    const Result<std::string> text = files.read_text(path);
    if (!text) return Error{"atlas '" + std::string(path) + "' cannot be loaded: " + text.error().message};
    const Result<Json> parsed = json_from_text(*text);
    if (!parsed) {
        int line = 0;
        const Result<Json> with_line = json_with_lines(*text, line);
        if (with_line || line == 0) return atlas_error(path, parsed.error().message);
        return Error{std::string(path) + ':' + std::to_string(line) + ": " + with_line.error().message};
    }
    const Json& json = *parsed;
    if (!json.is_object() || !json.contains("frames") || !json.contains("meta"))
        return atlas_error(path, "must be an object with \"frames\" and \"meta\"");
    const Json& meta = json["meta"];
    if (!meta.is_object() || !meta.contains("image") || !meta["image"].is_string())
        return atlas_error(path, "meta.image must be the name of the image's file");

    Atlas atlas{folder_of(path) + meta["image"].get<std::string>(), {}};
    const Json& frames = json["frames"];
    if (frames.is_object()) {
        for (const auto& [name, entry] : frames.items())
            if (auto added = add_frame(name, entry, path, atlas); !added) return added.error();
    } else if (frames.is_array()) {
        for (const Json& entry : frames) {
            const bool is_named =
                entry.is_object() && entry.contains("filename") && entry["filename"].is_string();
            if (!is_named) return atlas_error(path, "every member of \"frames\" must have a \"filename\"");
            if (auto added = add_frame(entry["filename"].get<std::string>(), entry, path, atlas); !added)
                return added.error();
        }
    } else {
        return atlas_error(path, "\"frames\" must be an object or a list");
    }
    std::set<std::string_view> names;
    for (const AtlasFrame& frame : atlas.frames)
        if (!names.insert(frame.name).second)
            return atlas_error(path, "two frames are called '" + frame.name + "'");
    return atlas;
}

bool is_atlas_text(std::string_view text) {
    const Result<Json> json = json_from_text(text);
    if (!json)
        return text.find("\"frames\"") != std::string_view::npos ||
               text.find("\"meta\"") != std::string_view::npos;
    return json->is_object() && json->contains("frames") && json->contains("meta");
}

Result<void> check_atlas(const Atlas& atlas, Size image, std::string_view path) {
    for (const AtlasFrame& frame : atlas.frames) {
        const Rect& r = frame.source;
        if (r.x >= 0 && r.y >= 0 && r.x + r.width <= static_cast<float>(image.width) &&
            r.y + r.height <= static_cast<float>(image.height))
            continue;
        return atlas_error(path, "frame '" + frame.name + "' lies outside of its image, which has " +
                                     std::to_string(image.width) + " x " + std::to_string(image.height) +
                                     " pixels");
    }
    return {};
}

}  // namespace cairn::engine
