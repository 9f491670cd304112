// What a level that was read holds, by name.
#include <algorithm>
#include <charconv>

#include "data/table_writer.h"
#include "level/reader.h"

namespace cairn::scripting {

std::optional<std::size_t> Level::find(std::string_view wanted) const {
    const auto found =
        std::find_if(parts.begin(), parts.end(), [&](const LevelPart& part) { return part.name == wanted; });
    if (wanted.empty() || found == parts.end()) return std::nullopt;
    return static_cast<std::size_t>(found - parts.begin());
}

std::optional<std::size_t> Level::find(PartKind kind, std::string_view wanted) const {
    const auto found = find(wanted);
    if (!found || parts[*found].kind != kind) return std::nullopt;
    return found;
}

std::vector<std::string> Level::names(PartKind kind) const {
    std::vector<std::string> names;
    for (const LevelPart& part : parts) {
        if (part.kind == kind && !part.name.empty()) names.push_back(part.name);
    }
    return names;
}

bool is_tiled_file(std::string_view path) {
    return path.ends_with(".tmx") || path.ends_with(".tmj") || path.ends_with(".json");
}

PartName split_part_name(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos) return {name, 0};
    int index = 0;
    const char* end = name.data() + name.size();
    const auto read = std::from_chars(name.data() + dot + 1, end, index);
    if (read.ec != std::errc() || read.ptr != end || index < 1) return {name, 0};
    return {name.substr(0, dot), index};
}

std::string signature_of(const LevelPart& part) {
    std::string text = section_of(part.kind).one;
    text += ' ' + part.variant + ' ' + to_table_text(part.fields);
    for (const ShapePart& shape : part.shapes) text += shape.variant + ' ' + to_table_text(shape.fields);
    return text;
}

}  // namespace cairn::scripting
