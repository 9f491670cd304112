// Maps of the editor Tiled as levels: objects become bodies, triggers and spawns, solid tiles become chains.
// Invariant: what comes out is a table in the level format, so that everything that is checked in a level
// file is checked in a map too. Metres, y up: the map's bottom left is (0, 0).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/files.h>
#include <cairn/engine/geometry.h>
#include <cairn/engine/tile_map.h>

#include "data/value.h"

namespace cairn::scripting {

/// `scale`: metres per pixel; 0: one tile is one metre wide. What is wrong with the map is added to `faults`;
/// then there is no level, unless it is wrong with single objects, which the level lacks.
std::optional<Value> tiled_level(const engine::Files& files, std::string_view path, double scale,
                                 std::vector<std::string>& faults);

/// Corners of cells, from the top left of the map, in cells; a closed outline.
struct CellCorner {
    int column = 0;
    int row = 0;
    friend bool operator==(const CellCorner&, const CellCorner&) = default;
};

/// The outlines of regions of solid cells, without corners in straight runs. Walking along one, with y up,
/// what is solid lies on the left, so that a chain of it keeps things out (see chain.h). Regions that touch
/// at a corner only are outlined apart. In the order of their topmost, leftmost corner.
std::vector<std::vector<CellCorner>> outline_cells(int columns, int rows, const std::vector<bool>& is_solid);

}  // namespace cairn::scripting
