// cairn.text: parts, lines, and text that is typed before the player's eyes.
#include <catch2/catch.hpp>

#include "scripting/support/drawing.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

const GameFiles kSmall = {{"conf.lua", "{ width = 200, height = 100 }"}};

/// The sums of red, green and blue.
std::array<long, 3> light(const engine::Image& image) {
    std::array<long, 3> sums{};
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        for (std::size_t k = 0; k < 3; ++k) sums[k] += image.rgba[i + k];
    return sums;
}

}  // namespace

TEST_CASE("parts in colors of their own make one text, broken and measured as one") {
    LuaBench bench(kSmall, MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("one = cairn.text.new('one two three', { width = 80 }) parts = cairn.text.new({ 'one "
                      "', { 'two', 1, 0, "
                      "0 }, ' three' }, { width = 80 })") == "");
    CHECK(bench.value("table.concat({ one:size() }, ' ') == table.concat({ parts:size() }, ' ')") == "true");
    CHECK(bench.value("one:length()") == "13");
    CHECK(bench.value("cairn.text.new('\xc3\xa4'):length()") == "1");
    CHECK(bench.value("cairn.text.new('a\\0b'):length()") == "3");
    CHECK(bench.value("cairn.text.new{ 'a\\0b', { 'c\\0', 1, 0, 0 } }:length()") == "5");
    CHECK(bench.value("table.concat(cairn.text.wrap('one two three', 80), '|')") == "one two|three");
    const auto white = light(picture_of(bench, "one:draw(10, 10)"));
    const auto mixed = light(picture_of(bench, "parts:draw(10, 10)"));
    CHECK(mixed[0] == white[0]);
    CHECK(mixed[1] < white[1]);
    CHECK(mixed[1] == mixed[2]);
    const auto tinted = light(picture_of(bench, "cairn.graphics.set_color(0, 1, 1) parts:draw(10, 10)"));
    CHECK(tinted[0] == 0);
    CHECK(tinted[1] == mixed[1]);
}

TEST_CASE("text is typed character by character") {
    LuaBench bench(kSmall, MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("t = cairn.text.new('MMMM') all = t:length()") == "");
    long before = -1;
    for (int shown = 0; shown <= 4; ++shown) {
        const long now =
            light(picture_of(bench, "t:set_shown(" + std::to_string(shown) + ") t:draw(10, 10)"))[0];
        CHECK(now > before);
        before = now;
    }
    CHECK(light(picture_of(bench, "t:set_shown() t:draw(10, 10)"))[0] == before);
    REQUIRE(bench.run("t:set_text('M')") == "");
    CHECK(light(picture_of(bench, "t:draw(10, 10)"))[0] == before / 4);
}

TEST_CASE("wrong texts name the part and the rule") {
    LuaBench bench(kSmall);
    CHECK(bench.run("cairn.text.new(3)") ==
          "test.lua:1: cairn.text.new: parts is 3; expected a string, or a list of parts");
    CHECK(bench.run("cairn.text.new{ 'a', 3 }").find("parts[2] is 3; expected a string, or {") !=
          std::string::npos);
    CHECK(bench.run("cairn.text.new{ { 'a', 1, 2 } }").find("parts[1] must be a string, or {") !=
          std::string::npos);
    CHECK(
        bench.run("cairn.text.new('a', { align = 'middle' })").find("align = \"middle\": must be \"left\"") !=
        std::string::npos);
    CHECK(bench.run("cairn.text.new('a'):set_shown(-1)").find("at least 0") != std::string::npos);
    CHECK(bench.run("cairn.text.new('a'):draw(1, 1)").find("call it inside cairn.draw") != std::string::npos);
}

}  // namespace cairn::scripting::test
