// The outlines of the solid cells of a grid. Invariant: every border between a solid cell and another one, or
// the outside, is on exactly one of them.
#pragma once

#include <vector>

namespace cairn::scripting {

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
