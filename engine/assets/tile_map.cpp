// Where things lie in a map.
#include <algorithm>
#include <cmath>

#include <cairn/engine/tile_map.h>

#include "assets/staggered_grid.h"

namespace cairn::engine {

Rect TileSet::source(std::uint32_t id) const {
    const int index = static_cast<int>(id - first_id);
    return {static_cast<float>(margin + index % columns * (tile_size.width + spacing)),
            static_cast<float>(margin + index / columns * (tile_size.height + spacing)),
            static_cast<float>(tile_size.width), static_cast<float>(tile_size.height)};
}

Result<void> TileSet::check_image(Size image) const {
    const auto room = [&](int side, int tile) {
        return std::max(0, (side - margin + spacing) / (tile + spacing));
    };
    const int wide = room(image.width, tile_size.width);
    const int rows = room(image.height, tile_size.height);
    const auto fault = [&](const char* field, int value, int most) {
        const auto text = [](Size size) {
            return std::to_string(size.width) + " x " + std::to_string(size.height);
        };
        return Error{place + ": " + field + " is " + std::to_string(value) + ", but must be at most " +
                     std::to_string(most) + ": so many tiles of " + text(tile_size) +
                     " fit into the picture '" + image_path + "' of " + text(image)};
    };
    if (columns > wide) return fault("columns", columns, wide);
    if ((tile_count + columns - 1) / columns > rows) return fault("tilecount", tile_count, rows * columns);
    return {};
}

Vec2 TileMap::size() const {
    const auto width = static_cast<float>(tile_size.width);
    const auto height = static_cast<float>(tile_size.height);
    if (grid == MapGrid::Orthogonal)
        return {static_cast<float>(columns) * width, static_cast<float>(rows) * height};
    if (grid == MapGrid::Staggered) return staggered_size(*this);
    const auto sides = static_cast<float>(columns + rows);
    return {0.5f * sides * width, 0.5f * sides * height};
}

Vec2 TileMap::from_cells(Vec2 cells) const {
    const auto width = static_cast<float>(tile_size.width);
    const auto height = static_cast<float>(tile_size.height);
    if (grid == MapGrid::Orthogonal) return {cells.x * width, cells.y * height};
    return {0.5f * width * (cells.x - cells.y + static_cast<float>(rows)),
            0.5f * height * (cells.x + cells.y)};
}

Vec2 TileMap::to_cells(Vec2 place) const {
    const Vec2 cells = {place.x / static_cast<float>(tile_size.width),
                        place.y / static_cast<float>(tile_size.height)};
    if (grid == MapGrid::Orthogonal) return cells;
    const float across = cells.x - 0.5f * static_cast<float>(rows);
    return {cells.y + across, cells.y - across};
}

Vec2 TileMap::from_object(Vec2 place) const {
    if (grid != MapGrid::Isometric) return place;
    return from_cells(place * (1 / static_cast<float>(tile_size.height)));
}

Vec2 TileMap::cell_middle(int column, int row) const {
    if (grid == MapGrid::Staggered) return staggered_middle(*this, column, row);
    return from_cells({static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f});
}

TileMap::Cell TileMap::cell_at(Vec2 place) const {
    if (grid == MapGrid::Staggered) return staggered_cell(*this, place);
    const auto index = [](float x) { return static_cast<int>(std::clamp(std::floor(x), -1e9f, 1e9f)); };
    const Vec2 cells = to_cells(place);
    return {index(cells.x), index(cells.y)};
}

std::vector<Vec2> TileMap::cell_outline() const {
    if (grid == MapGrid::Staggered) return staggered_outline(*this);
    const Vec2 middle = from_cells({0.5f, 0.5f});
    std::vector<Vec2> corners;
    for (const Vec2 corner : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}})
        corners.push_back(from_cells(corner) - middle);
    return corners;
}

Vec2 TileMap::tile_corner(int column, int row) const {
    if (grid == MapGrid::Staggered) {
        return staggered_middle(*this, column, row) +
               Vec2{-0.5f * static_cast<float>(tile_size.width), 0.5f * static_cast<float>(tile_size.height)};
    }
    const Vec2 below = from_cells({static_cast<float>(column), static_cast<float>(row + 1)});
    if (grid == MapGrid::Orthogonal) return below;
    return below + Vec2{0, 0.5f * static_cast<float>(tile_size.height)};
}

const TileSet* TileMap::set_of(std::uint32_t id) const {
    const auto behind = std::upper_bound(sets.begin(), sets.end(), id,
                                         [](std::uint32_t i, const TileSet& s) { return i < s.first_id; });
    if (behind == sets.begin()) return nullptr;
    const TileSet& set = *(behind - 1);
    return id - set.first_id < static_cast<std::uint32_t>(set.tile_count) ? &set : nullptr;
}

const MapLayer* TileMap::layer(std::string_view name) const {
    for (const MapLayer& layer : layers)
        if (layer.name == name) return &layer;
    return nullptr;
}

// Source: "Parallax Scrolling Factor" in Tiled's manual; at 1 a layer moves with the map, at 0 with the view.
Vec2 TileMap::parallax_shift(const MapLayer& layer, Vec2 view_middle) const {
    const Vec2 way = view_middle - parallax_origin;
    return {(1 - layer.parallax.x) * way.x, (1 - layer.parallax.y) * way.y};
}

const TileProperties& TileMap::properties_of(std::uint32_t id) const {
    static const TileProperties kNone;
    const TileSet* set = set_of(id);
    if (set == nullptr) return kNone;
    const auto found = set->properties.find(id);
    return found == set->properties.end() ? kNone : found->second;
}

std::uint32_t TileMap::shown(std::uint32_t id, double time_s) const {
    const TileSet* set = set_of(id);
    if (set == nullptr) return id;
    const auto found = set->animations.find(id);
    if (found == set->animations.end()) return id;
    double length_s = 0;
    for (const TileFrame& frame : found->second) length_s += frame.duration_s;
    double rest_s = std::fmod(std::max(time_s, 0.0), length_s);
    for (const TileFrame& frame : found->second) {
        if (rest_s < frame.duration_s) return frame.id;
        rest_s -= frame.duration_s;
    }
    return found->second.back().id;
}

std::vector<CellRect> cover_cells(int columns, int rows, const std::vector<bool>& is_solid) {
    std::vector<CellRect> rects;
    std::vector<std::size_t> open;  // of the row above, by column
    for (int row = 0; row < rows; ++row) {
        std::vector<std::size_t> now;
        for (int column = 0; column < columns; ++column) {
            const auto at = [&](int c) { return is_solid[static_cast<std::size_t>(row) * columns + c]; };
            if (!at(column)) continue;
            int end = column;
            while (end < columns && at(end)) ++end;
            const auto same = std::find_if(open.begin(), open.end(), [&](std::size_t i) {
                return rects[i].column == column && rects[i].columns == end - column;
            });
            if (same != open.end()) {
                ++rects[*same].rows;
                now.push_back(*same);
            } else {
                now.push_back(rects.size());
                rects.push_back({column, row, end - column, 1});
            }
            column = end;
        }
        open = std::move(now);
    }
    return rects;
}

}  // namespace cairn::engine
