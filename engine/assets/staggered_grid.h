// Where the cells of staggered and hexagonal maps lie. Invariant: each place is in one cell, whose middle and
// corners agree with that.
#pragma once

#include <cairn/engine/tile_map.h>

namespace cairn::engine {

/// Of the picture of a map, in pixels.
Vec2 staggered_size(const TileMap& map);
Vec2 staggered_middle(const TileMap& map, int column, int row);
TileMap::Cell staggered_cell(const TileMap& map, Vec2 place);
/// The corners of a cell, from its middle: six, or of a diamond four.
std::vector<Vec2> staggered_outline(const TileMap& map);

}  // namespace cairn::engine
