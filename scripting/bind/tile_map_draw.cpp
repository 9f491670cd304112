// The drawing of tile maps. Invariant: tiles of one set, and copies of one picture, are one mesh without
// smooth edges, so that neighbours meet without a seam.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bind/tile_map_object.h"
#include "bind/timers.h"

namespace cairn::scripting {
namespace {

using engine::MapLayer;
using engine::MapObject;
using engine::Rect;
using engine::Tile;
using engine::Vec2;

/// Triangles of the tiles of one layer, sent whenever the picture changes.
class TileMesh {
  public:
    TileMesh(engine::Renderer& renderer, const TileMapObject& map, engine::Color color, double time_s)
        : renderer_(renderer), map_(map), color_(color), time_s_(time_s) {
        // Where a pixel of the map is not one of the screen, the filter would mix a tile with its neighbour
        // in the set.
        const float pixel = renderer.transform().mean_scale() * renderer.pixel_scale() * map.scale;
        margin_ = map.is_nearest || std::fabs(pixel - 1) < 0.001f ? 0 : 0.5f;
    }
    ~TileMesh() { send(); }
    TileMesh(const TileMesh&) = delete;
    TileMesh& operator=(const TileMesh&) = delete;

    /// A tile in its own size, whose bottom left lies at a place of the map, in pixels.
    void add(const Tile& tile, Vec2 bottom_left) {
        const engine::TileSet& set = set_of(tile);
        const auto width = static_cast<float>(set.tile_size.width);
        const auto height = static_cast<float>(set.tile_size.height);
        bottom_left = bottom_left + set.tile_offset;
        add(tile, {bottom_left + Vec2{0, -height}, bottom_left + Vec2{width, -height},
                   bottom_left + Vec2{width, 0}, bottom_left});
    }
    /// An object that is a tile: in the size of the object, turned about its place.
    void add(const MapObject& object, Vec2 offset) {
        const Vec2 size = object.size;
        const engine::TileSet& set = set_of(object.tile);
        const Vec2 stretch = {size.x / static_cast<float>(set.tile_size.width),
                              size.y / static_cast<float>(set.tile_size.height)};
        const Vec2 low = {-object.anchor.x * size.x + set.tile_offset.x * stretch.x,
                          -object.anchor.y * size.y + set.tile_offset.y * stretch.y};
        const Vec2 high = low + size;
        const engine::Affine2 turned =
            engine::Affine2::translation(map_.map.from_object(object.position) + offset) *
            engine::Affine2::rotation(object.rotation_rad);
        add(object.tile, {turned.apply(low), turned.apply({high.x, low.y}), turned.apply(high),
                          turned.apply({low.x, high.y})});
    }

  private:
    [[nodiscard]] const engine::TileSet& set_of(const Tile& tile) const {
        return *map_.map.set_of(map_.map.shown(tile.id, time_s_));
    }

    // From the top left, clockwise.
    void add(const Tile& tile, const std::array<Vec2, 4>& corners) {
        const std::uint32_t id = map_.map.shown(tile.id, time_s_);
        const engine::TileSet& set = set_of(tile);
        const auto index = static_cast<std::size_t>(&set - map_.map.sets.data());
        if (index != set_) {
            send();
            set_ = index;
            texture_size_ = renderer_.texture_size(map_.textures[index]);
        }
        const Rect source = set.source(id);
        Vec2 uv[] = {{source.x + margin_, source.y + margin_},
                     {source.x + source.width - margin_, source.y + margin_},
                     {source.x + source.width - margin_, source.y + source.height - margin_},
                     {source.x + margin_, source.y + source.height - margin_}};
        if (tile.flip_diagonal) std::swap(uv[1], uv[3]);
        if (tile.flip_x) {
            std::swap(uv[0], uv[1]);
            std::swap(uv[2], uv[3]);
        }
        if (tile.flip_y) {
            std::swap(uv[0], uv[3]);
            std::swap(uv[1], uv[2]);
        }
        const auto first = static_cast<std::uint32_t>(vertices_.size());
        for (std::size_t i = 0; i < 4; ++i)
            vertices_.push_back({map_.to_units(corners[i]),
                                 color_,
                                 {uv[i].x / static_cast<float>(std::max(texture_size_.width, 1)),
                                  uv[i].y / static_cast<float>(std::max(texture_size_.height, 1))}});
        indices_.insert(indices_.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }

    void send() {
        if (!indices_.empty()) renderer_.draw_mesh(vertices_, indices_, map_.textures[set_]);
        vertices_.clear();
        indices_.clear();
    }

    engine::Renderer& renderer_;
    const TileMapObject& map_;
    engine::Color color_;
    double time_s_;
    float margin_ = 0;
    std::size_t set_ = static_cast<std::size_t>(-1);
    engine::Size texture_size_;
    std::vector<engine::MeshVertex> vertices_;
    std::vector<std::uint32_t> indices_;
};

/// The part of the map that the picture shows, in pixels of the map.
struct View {
    Vec2 low, middle, high;
};
View view_of(const engine::Renderer& renderer, const TileMapObject& map) {
    const engine::Size target = renderer.target_size();
    const engine::Affine2 back = renderer.transform().inverse();
    const auto place = [&](Vec2 share) {
        return map.to_pixels(back.apply(
            {share.x * static_cast<float>(target.width), share.y * static_cast<float>(target.height)}));
    };
    View view{{1e30f, 1e30f}, place({0.5f, 0.5f}), {-1e30f, -1e30f}};
    for (const Vec2 corner : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}, Vec2{1, 1}}) {
        const Vec2 p = place(corner);
        view.low = {std::min(view.low.x, p.x), std::min(view.low.y, p.y)};
        view.high = {std::max(view.high.x, p.x), std::max(view.high.y, p.y)};
    }
    return view;
}

/// The cells that the picture may show, with room for tiles that are larger than cells.
struct CellRange {
    int first_column, last_column, first_row, last_row;
};
CellRange visible_cells(const View& view, const TileMapObject& map, Vec2 offset) {
    Vec2 low = view.low - offset;
    Vec2 high = view.high - offset;
    engine::Size largest = map.map.tile_size;
    Vec2 least_offset, greatest_offset;
    for (const engine::TileSet& set : map.map.sets) {
        largest = {std::max(largest.width, set.tile_size.width),
                   std::max(largest.height, set.tile_size.height)};
        const Vec2 offset_of_set = set.tile_offset;
        least_offset = {std::min(least_offset.x, offset_of_set.x), std::min(least_offset.y, offset_of_set.y)};
        greatest_offset = {std::max(greatest_offset.x, offset_of_set.x),
                           std::max(greatest_offset.y, offset_of_set.y)};
    }
    // The picture, and what tiles may reach into it from below and from the left, as a part of the grid.
    low = low - greatest_offset - Vec2{static_cast<float>(largest.width), 0};
    high = high - least_offset + Vec2{0, static_cast<float>(largest.height)};
    const auto cell = [](float place, int count) {
        return static_cast<int>(std::clamp(std::floor(place), -1.0f, static_cast<float>(count)));
    };
    if (map.map.grid == engine::MapGrid::Staggered) {
        // The cells at the corners, and those around: rows that are moved begin or end half a cell behind.
        const engine::TileMap::Cell from = map.map.cell_at(low);
        const engine::TileMap::Cell to = map.map.cell_at(high);
        return {std::max(from.column - 1, 0), std::min(to.column + 1, map.map.columns - 1),
                std::max(from.row - 1, 0), std::min(to.row + 1, map.map.rows - 1)};
    }
    Vec2 first = {1e30f, 1e30f};
    Vec2 last = {-1e30f, -1e30f};
    for (const Vec2 corner : {low, Vec2{high.x, low.y}, high, Vec2{low.x, high.y}}) {
        const Vec2 cells = map.map.to_cells(corner);
        first = {std::min(first.x, cells.x), std::min(first.y, cells.y)};
        last = {std::max(last.x, cells.x), std::max(last.y, cells.y)};
    }
    return {std::max(cell(first.x, map.map.columns), 0),
            std::min(cell(last.x, map.map.columns), map.map.columns - 1),
            std::max(cell(first.y, map.map.rows), 0), std::min(cell(last.y, map.map.rows), map.map.rows - 1)};
}

/// Those that are seen, the rearmost first.
std::vector<const MapObject*> drawn_objects(const MapLayer& layer) {
    std::vector<const MapObject*> drawn;
    for (const MapObject& object : layer.objects)
        if (object.shape == engine::MapShape::Tile && object.is_visible) drawn.push_back(&object);
    const auto is_above = [](const MapObject* a, const MapObject* b) {
        return a->position.y < b->position.y;
    };
    if (layer.draws_from_top) std::stable_sort(drawn.begin(), drawn.end(), is_above);
    return drawn;
}

/// Which copies of a picture the view shows along one axis; a picture that is not repeated is copy 0.
struct CopyRange {
    int first, last;
};
CopyRange visible_copies(float low, float high, float corner, float side, bool repeats) {
    const float first = std::floor((low - corner) / side), last = std::ceil((high - corner) / side) - 1;
    if (!repeats) return first <= 0 && last >= 0 ? CopyRange{0, 0} : CopyRange{0, -1};
    // A picture of few pixels seen from far away would be drawn millions of times; more than these nobody
    // tells apart. The middle of the view has them.
    constexpr float kMostCopies = 256;
    const float beyond = std::max(0.0f, 0.5f * (last - first + 1 - kMostCopies));
    constexpr float kFarthest = 1e9f;
    return {static_cast<int>(std::clamp(std::ceil(first + beyond), -kFarthest, kFarthest)),
            static_cast<int>(std::clamp(std::floor(last - beyond), -kFarthest, kFarthest))};
}

void draw_image(engine::Renderer& renderer, const TileMapObject& map, const MapLayer& layer, const View& view,
                Vec2 offset, engine::Color color) {
    const engine::TextureId texture = map.images[static_cast<std::size_t>(&layer - map.map.layers.data())];
    const engine::Size pixels = renderer.texture_size(texture);
    const Vec2 size = {static_cast<float>(std::max(pixels.width, 1)),
                       static_cast<float>(std::max(pixels.height, 1))};
    const Vec2 corner = layer.image_corner + offset;
    const CopyRange across = visible_copies(view.low.x, view.high.x, corner.x, size.x, layer.repeats_x);
    const CopyRange down = visible_copies(view.low.y, view.high.y, corner.y, size.y, layer.repeats_y);
    std::vector<engine::MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
    for (int row = down.first; row <= down.last; ++row) {
        for (int column = across.first; column <= across.last; ++column) {
            const auto first = static_cast<std::uint32_t>(vertices.size());
            for (const Vec2 uv : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}}) {
                const Vec2 place = {corner.x + (static_cast<float>(column) + uv.x) * size.x,
                                    corner.y + (static_cast<float>(row) + uv.y) * size.y};
                vertices.push_back({map.to_units(place), color, uv});
            }
            indices.insert(indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
        }
    }
    if (!indices.empty()) renderer.draw_mesh(vertices, indices, texture);
}

}  // namespace

void draw_layer(const Context& context, const TileMapObject& map, const MapLayer& layer) {
    engine::Renderer& renderer = context.services.renderer;
    const engine::Color color = {context.draw.color.r * layer.color.r, context.draw.color.g * layer.color.g,
                                 context.draw.color.b * layer.color.b, context.draw.color.a * layer.color.a};
    const View view = view_of(renderer, map);
    const Vec2 offset = layer.offset + map.map.parallax_shift(layer, view.middle);
    if (layer.kind == MapLayer::Kind::Image) return draw_image(renderer, map, layer, view, offset, color);
    TileMesh mesh(renderer, map, color, context.time_s());
    if (layer.kind == MapLayer::Kind::Objects) {
        for (const MapObject* object : drawn_objects(layer)) mesh.add(*object, offset);
        return;
    }
    const CellRange range = visible_cells(view, map, offset);
    const auto add_row = [&](int row, int first_column, int step) {
        for (int column = first_column; column <= range.last_column; column += step) {
            const Tile& tile =
                layer.tiles[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.map.columns) +
                            column];
            if (tile.id == 0) continue;
            mesh.add(tile, map.map.tile_corner(column, row) + offset);
        }
    };
    const bool moves_columns = map.map.grid == engine::MapGrid::Staggered && map.map.stagger.moves_columns;
    for (int row = range.first_row; row <= range.last_row; ++row) {
        if (!moves_columns) {
            add_row(row, range.first_column, 1);
            continue;
        }
        // Columns that are moved down stand before the others of their row.
        const bool first_is_moved = (range.first_column % 2 == 0) == map.map.stagger.moves_even;
        add_row(row, range.first_column + (first_is_moved ? 1 : 0), 2);
        add_row(row, range.first_column + (first_is_moved ? 0 : 1), 2);
    }
}

}  // namespace cairn::scripting
