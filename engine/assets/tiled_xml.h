// Rewrites Tiled's XML as the JSON that Tiled writes for the same map, so that one reader reads both.
// Invariant: what the JSON would have as a number is a number, and what it would have as a list is a list.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace cairn::engine {

/// Of a map (.tmx) or a tile set (.tsx). Objects keep their line as those of
/// `json_with_lines` do. Throws a Fault with the line in which the XML is broken.
nlohmann::ordered_json tiled_json_from_xml(std::string_view xml);

}  // namespace cairn::engine
