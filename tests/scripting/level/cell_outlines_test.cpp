#include "level/cell_outlines.h"

#include <catch2/catch.hpp>
#include <string>

namespace cairn::scripting::test {
namespace {

TEST_CASE("outlines of cells keep what is solid on the left, and part at corners") {
    const auto outlines_of = [](int columns, const std::string& picture) {
        std::vector<bool> cells;
        for (const char c : picture) cells.push_back(c == '#');
        return outline_cells(columns, static_cast<int>(picture.size()) / columns, cells);
    };
    const auto signed_area = [](const std::vector<CellCorner>& outline) {
        int area = 0;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const CellCorner a = outline[i];
            const CellCorner b = outline[(i + 1) % outline.size()];
            area += a.row * b.column - a.column * b.row;  // y points up
        }
        return area / 2;
    };
    CHECK(outlines_of(3, "......").empty());
    const auto single = outlines_of(3, "....#.");
    REQUIRE(single.size() == 1);
    CHECK(single[0].size() == 4);
    CHECK(signed_area(single[0]) == 1);
    const auto corner = outlines_of(2, "#..#");
    REQUIRE(corner.size() == 2);
    CHECK(corner[0].size() == 4);
    // A ring: outside anticlockwise, its hole clockwise.
    const auto ring = outlines_of(3, "####.####");
    REQUIRE(ring.size() == 2);
    CHECK(signed_area(ring[0]) == 9);
    CHECK(signed_area(ring[1]) == -1);
    // Against a count of cells, for every picture of 3 x 3.
    for (int bits = 0; bits < 512; ++bits) {
        std::vector<bool> cells;
        int count = 0;
        for (int i = 0; i < 9; ++i) {
            cells.push_back((bits >> i & 1) != 0);
            count += bits >> i & 1;
        }
        int area = 0;
        for (const auto& outline : outline_cells(3, 3, cells)) {
            CHECK(outline.size() % 2 == 0);
            area += signed_area(outline);
        }
        CHECK(area == count);
    }
}

}  // namespace
}  // namespace cairn::scripting::test
