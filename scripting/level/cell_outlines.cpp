// Source: each cell's border runs anticlockwise; what two solid cells share cancels, and the rest is linked
// end to end, by the leftmost turn where there is a choice.
#include "level/cell_outlines.h"

#include <utility>

namespace cairn::scripting {

std::vector<std::vector<CellCorner>> outline_cells(int columns, int rows, const std::vector<bool>& is_solid) {
    // Directions: 0 right, 1 up, 2 left, 3 down. An edge is known by its first corner and its direction.
    constexpr int kSteps[4][2] = {{1, 0}, {0, -1}, {-1, 0}, {0, 1}};
    const int corner_columns = columns + 1;
    std::vector<bool> edges(static_cast<std::size_t>(corner_columns * (rows + 1)) * 4, false);
    const auto edge = [&](CellCorner at, int direction) {
        return static_cast<std::size_t>((at.row * corner_columns + at.column) * 4 + direction);
    };
    const auto solid = [&](int column, int row) {
        return column >= 0 && row >= 0 && column < columns && row < rows &&
               is_solid[static_cast<std::size_t>(row * columns + column)];
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            if (!solid(column, row)) continue;
            if (!solid(column, row + 1)) edges[edge({column, row + 1}, 0)] = true;
            if (!solid(column + 1, row)) edges[edge({column + 1, row + 1}, 1)] = true;
            if (!solid(column, row - 1)) edges[edge({column + 1, row}, 2)] = true;
            if (!solid(column - 1, row)) edges[edge({column, row}, 3)] = true;
        }
    }
    std::vector<std::vector<CellCorner>> outlines;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            for (int first = 0; first < 4; ++first) {
                if (!edges[edge({column, row}, first)]) continue;
                std::vector<CellCorner> outline;
                CellCorner at{column, row};
                int direction = first;
                int previous = -1;
                while (edges[edge(at, direction)]) {
                    edges[edge(at, direction)] = false;
                    if (direction != previous) outline.push_back(at);
                    previous = direction;
                    at = {at.column + kSteps[direction][0], at.row + kSteps[direction][1]};
                    for (const int turn : {1, 0, 3}) {
                        const int next = (direction + turn) % 4;
                        if (!edges[edge(at, next)]) continue;
                        direction = next;
                        break;
                    }
                }
                if (previous == first) outline.erase(outline.begin());
                outlines.push_back(std::move(outline));
            }
        }
    }
    return outlines;
}

}  // namespace cairn::scripting
