// Fonts cut anywhere, against the length of the font that comes with the engine: its last table ends, but for
// padding, with the file.
#include "assets/font_check.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <span>
#include <string>

#include "support/source_path.h"

using cairn::engine::font_fault;

namespace {

std::string fault(const std::string& file) {
    return font_fault(std::as_bytes(std::span(file)));
}

}  // namespace

TEST_CASE("a font that ends before its tables do is cut off, wherever that is") {
    std::ifstream in(cairn::test::source_path("assets/fonts/default.ttf"), std::ios::binary);
    const std::string font{std::istreambuf_iterator<char>(in), {}};
    REQUIRE(font.size() > 10'000);
    CHECK(fault(font).empty());
    CHECK(fault(font + "more").empty());
    for (std::size_t length = 12; length + 4 < font.size(); length += 397) {
        INFO(length);
        CHECK(fault(font.substr(0, length)).find("is cut off: its tables should end at byte ") == 0);
    }
    CHECK(fault("neither TrueType nor OpenType").empty());
    CHECK(fault("short").empty());
    std::string many = font;  // tables without end
    many[4] = many[5] = '\xff';
    CHECK_FALSE(fault(many).empty());
}
