// All is worked out for rows that are moved, with two sides of the hexagon upright; for columns x and y
// change places. Source: the documentation of Tiled's map format, "hexsidelength", "staggeraxis" and
// "staggerindex".
#include "assets/staggered_grid.h"

#include <algorithm>
#include <cmath>

namespace cairn::engine {
namespace {

/// Along the rows, and across them.
struct Along {
    float along;
    float across;
};

class Rows {
  public:
    explicit Rows(const TileMap& map)
        : is_turned_(map.stagger.moves_columns),
          moves_even_(map.stagger.moves_even),
          length_(static_cast<float>(is_turned_ ? map.tile_size.height : map.tile_size.width)),
          depth_(static_cast<float>(is_turned_ ? map.tile_size.width : map.tile_size.height)),
          side_(static_cast<float>(map.stagger.side_length)) {}

    [[nodiscard]] Vec2 turned(Along p) const {
        return is_turned_ ? Vec2{p.across, p.along} : Vec2{p.along, p.across};
    }
    [[nodiscard]] Along turned(Vec2 p) const { return is_turned_ ? Along{p.y, p.x} : Along{p.x, p.y}; }

    /// From one row to the next.
    [[nodiscard]] float pitch() const { return 0.5f * (depth_ + side_); }
    [[nodiscard]] float moved(int row) const {
        const bool is_even = row % 2 == 0;
        return is_even == moves_even_ ? 0.5f * length_ : 0;
    }
    [[nodiscard]] Along middle(int place, int row) const {
        return {(static_cast<float>(place) + 0.5f) * length_ + moved(row),
                static_cast<float>(row) * pitch() + 0.5f * depth_};
    }
    /// How far a place is outside of a cell, as a share of its half depth and in a measure that is the same
    /// from both sides of an edge; below 0 inside.
    [[nodiscard]] float outside(Along from_middle) const {
        const float slope = (depth_ - side_) / length_;
        const float slanted =
            std::fabs(from_middle.across) + slope * std::fabs(from_middle.along) - 0.5f * depth_;
        const float upright = slope * (std::fabs(from_middle.along) - 0.5f * length_);
        return std::max(slanted, upright);
    }

    float length() const { return length_; }
    float depth() const { return depth_; }
    float side() const { return side_; }

  private:
    bool is_turned_;
    bool moves_even_;
    float length_;  ///< of a cell along its row
    float depth_;   ///< across it
    float side_;
};

}  // namespace

Vec2 staggered_size(const TileMap& map) {
    const Rows rows(map);
    const int count = map.stagger.moves_columns ? map.columns : map.rows;
    const int places = map.stagger.moves_columns ? map.rows : map.columns;
    const float behind = count > 1 ? 0.5f * rows.length() : rows.moved(0);
    return rows.turned(Along{static_cast<float>(places) * rows.length() + behind,
                             static_cast<float>(count - 1) * rows.pitch() + rows.depth()});
}

Vec2 staggered_middle(const TileMap& map, int column, int row) {
    const Rows rows(map);
    return rows.turned(map.stagger.moves_columns ? rows.middle(row, column) : rows.middle(column, row));
}

TileMap::Cell staggered_cell(const TileMap& map, Vec2 place) {
    const Rows rows(map);
    const Along at = rows.turned(place);
    const auto whole = [](float x) { return static_cast<int>(std::clamp(std::floor(x), -1e6f, 1e6f)); };
    const int row_near = whole((at.across - 0.5f * rows.depth()) / rows.pitch());
    TileMap::Cell best;
    float least = INFINITY;
    for (int row = row_near - 1; row <= row_near + 2; ++row) {
        const int place_in_row = whole((at.along - rows.moved(row)) / rows.length());
        for (int along = place_in_row - 1; along <= place_in_row + 1; ++along) {
            const Along middle = rows.middle(along, row);
            const float outside = rows.outside({at.along - middle.along, at.across - middle.across});
            if (outside >= least) continue;
            least = outside;
            best = map.stagger.moves_columns ? TileMap::Cell{row, along} : TileMap::Cell{along, row};
        }
    }
    return best;
}

std::vector<Vec2> staggered_outline(const TileMap& map) {
    const Rows rows(map);
    const float l = 0.5f * rows.length();
    const float d = 0.5f * rows.depth();
    const float s = 0.5f * rows.side();
    std::vector<Along> corners = {{0, -d}, {l, -s}, {l, s}, {0, d}, {-l, s}, {-l, -s}};
    if (map.stagger.side_length == 0) corners = {{0, -d}, {l, 0}, {0, d}, {-l, 0}};
    std::vector<Vec2> points;
    for (const Along& corner : corners) points.push_back(rows.turned(corner));
    return points;
}

}  // namespace cairn::engine
