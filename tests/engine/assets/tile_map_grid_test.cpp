// Where the cells of maps lie, on each kind of grid.
#include <catch2/catch.hpp>

#include <cairn/engine/random.h>

#include "engine/support/maps.h"

using namespace cairn::engine;

TEST_CASE_METHOD(Maps, "the cells of an isometric map are diamonds, and its objects lie along their sides") {
    const TileMap map =
        good("iso.tmj", R"({"orientation": "isometric", "width": 3, "height": 2, "tilewidth": 32,
        "tileheight": 16, "layers": []})");
    CHECK(map.size() == Vec2{80, 40});
    CHECK(map.from_cells({0, 0}) == Vec2{32, 0});   // the top
    CHECK(map.from_cells({3, 0}) == Vec2{80, 24});  // the right corner
    CHECK(map.from_cells({0, 2}) == Vec2{0, 16});   // the left one
    CHECK(map.from_cells({3, 2}) == Vec2{48, 40});  // the bottom
    CHECK(map.from_object({48, 0}) == map.from_cells({3, 0}));
    CHECK(map.tile_corner(0, 0) == Vec2{16, 16});
    for (const Vec2 cells : {Vec2{0.5f, 0.25f}, Vec2{2, 1.5f}, Vec2{-3, 7}})
        CHECK(map.to_cells(map.from_cells(cells)) == cells);
}

TEST_CASE_METHOD(Maps, "hexagons and staggered diamonds lie where Tiled draws them") {
    const TileMap hexagons = good("hex.tmj", R"({"orientation": "hexagonal", "width": 3, "height": 3,
        "tilewidth": 14, "tileheight": 12, "hexsidelength": 6, "staggeraxis": "y", "staggerindex": "odd", "layers": []})");
    CHECK(hexagons.size() == Vec2{49, 30});
    CHECK(hexagons.cell_middle(0, 0) == Vec2{7, 6});
    CHECK(hexagons.cell_middle(0, 1) == Vec2{14, 15});
    CHECK(hexagons.cell_middle(2, 2) == Vec2{35, 24});
    CHECK(hexagons.tile_corner(0, 1) == Vec2{7, 21});
    CHECK(hexagons.cell_outline().size() == 6);
    CHECK(hexagons.cell_outline()[1] == Vec2{7, -3});
    const TileMap diamonds = good("staggered.tmj", R"({"orientation": "staggered", "width": 4, "height": 2,
        "tilewidth": 32, "tileheight": 16, "staggeraxis": "x", "staggerindex": "even", "layers": []})");
    CHECK(diamonds.size() == Vec2{80, 40});
    CHECK(diamonds.cell_middle(0, 0) == Vec2{16, 16});
    CHECK(diamonds.cell_middle(1, 0) == Vec2{32, 8});
    CHECK(diamonds.cell_outline().size() == 4);
    CHECK_THAT(load("bad.tmj", R"({"orientation": "hexagonal", "width": 3, "height": 3, "tilewidth": 14,
        "tileheight": 12, "hexsidelength": 12})")
                   .error()
                   .message,
               Catch::Contains("hexsidelength is 12, but must be a whole number from 0 to 11"));
    CHECK_THAT(load("bad.tmj", R"({"orientation": "staggered", "width": 3, "height": 3, "tilewidth": 14,
        "tileheight": 12, "staggeraxis": "z"})")
                   .error()
                   .message,
               Catch::Contains("staggeraxis is \"z\", but must be x or y"));
}

TEST_CASE_METHOD(Maps, "a place is in the cell whose outline holds it, on each kind of grid") {
    Random random(5);
    for (const char* orientation : {"orthogonal", "isometric", "staggered", "hexagonal"}) {
        for (const char* axis : {"x", "y"}) {
            for (const char* index : {"even", "odd"}) {
                const TileMap map =
                    good("m.tmj", std::string(R"({"width": 9, "height": 8, "tilewidth": 18,
                    "tileheight": 14, "hexsidelength": 5, "orientation": ")") +
                                      orientation + R"(", "staggeraxis": ")" + axis +
                                      R"(", "staggerindex": ")" + index + R"(", "layers": []})");
                const std::vector<Vec2> outline = map.cell_outline();
                for (int i = 0; i < 500; ++i) {
                    const Vec2 place = {static_cast<float>(random.uniform(-60, 300)),
                                        static_cast<float>(random.uniform(-60, 300))};
                    const TileMap::Cell cell = map.cell_at(place);
                    const Vec2 from_middle = place - map.cell_middle(cell.column, cell.row);
                    bool is_inside = true;
                    for (std::size_t k = 0; k < outline.size(); ++k) {
                        const Vec2 edge = outline[(k + 1) % outline.size()] - outline[k];
                        const Vec2 way = from_middle - outline[k];
                        const float turn = edge.x * way.y - edge.y * way.x;
                        const Vec2 inward = Vec2{0, 0} - outline[k];
                        const float side = edge.x * inward.y - edge.y * inward.x;
                        is_inside = is_inside && turn * (side > 0 ? 1.0f : -1.0f) >= -0.01f;
                    }
                    INFO(orientation << ' ' << axis << ' ' << index << ' ' << place.x << ' ' << place.y);
                    REQUIRE(is_inside);
                    const Vec2 middle = map.cell_middle(cell.column, cell.row);
                    REQUIRE(map.cell_at(middle) == cell);
                }
            }
        }
    }
}

TEST_CASE("rectangles cover exactly the solid cells, each once, and runs with one rectangle") {
    CHECK(cover_cells(4, 3, std::vector<bool>(12, true)) == std::vector<CellRect>{{0, 0, 4, 3}});
    CHECK(cover_cells(3, 2, std::vector<bool>(6, false)).empty());
    Random random(3);
    for (int round = 0; round < 50; ++round) {
        constexpr int kColumns = 17, kRows = 9;
        std::vector<bool> solid;
        for (int i = 0; i < kColumns * kRows; ++i) solid.push_back(random.uniform() < 0.6);
        std::vector<int> covered(solid.size(), 0);
        for (const CellRect& r : cover_cells(kColumns, kRows, solid))
            for (int y = r.row; y < r.row + r.rows; ++y)
                for (int x = r.column; x < r.column + r.columns; ++x) ++covered[y * kColumns + x];
        for (std::size_t i = 0; i < solid.size(); ++i) REQUIRE(covered[i] == (solid[i] ? 1 : 0));
    }
}
