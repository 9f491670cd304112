// Maps of the editor Tiled as levels: objects become bodies, triggers and spawns, solid tiles become chains.
// Invariant: what comes out is a table in the level format, so that everything that is checked in a level
// file is checked in a map too. Metres, y up: the map's bottom left is (0, 0).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/files.h>

#include "data/value.h"

namespace cairn::scripting {

struct TiledFault {
    int line = 0;  ///< of the map, from 1; 0: it stands in the text, or is not known
    std::string text;
};

/// `scale`: metres per pixel; 0: one tile is one metre wide. What is wrong with the map is added to `faults`;
/// then there is a level for finding more of them, whose values are unreadable where the map's are. Nothing
/// when the file is no map.
std::optional<Value> tiled_level(const engine::Files& files, std::string_view path, double scale,
                                 std::vector<TiledFault>& faults);

/// The member of the origin of a value that is the class of an object: the name of a template, or one of
/// these.
inline constexpr std::string_view kTiledClass = "class";
std::span<const std::string_view> tiled_classes();

}  // namespace cairn::scripting
