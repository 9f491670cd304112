#include "data/nearest.h"

#include <catch2/catch.hpp>
#include <vector>

namespace cairn::scripting {
namespace {

TEST_CASE("edit distance counts insertions, removals, replacements and swaps of neighbours") {
    CHECK(edit_distance("", "") == 0);
    CHECK(edit_distance("wood", "wood") == 0);
    CHECK(edit_distance("wod", "wood") == 1);
    CHECK(edit_distance("woood", "wood") == 1);
    CHECK(edit_distance("wxod", "wood") == 1);
    CHECK(edit_distance("wdoo", "wood") == 2);
    CHECK(edit_distance("owod", "wood") == 1);
    CHECK(edit_distance("abc", "") == 3);
    CHECK(edit_distance("kitten", "sitting") == 3);
}

TEST_CASE("the nearest word is suggested when it is near") {
    const std::vector<std::string> words = {"friction", "restitution", "radius", "width"};
    CHECK(nearest("fricton", words) == "friction");
    CHECK(nearest("widht", words) == "width");
    CHECK(nearest("color", words).empty());
    CHECK(nearest(std::string(1000, 'x'), words).empty());
}

TEST_CASE("what is no slip is looked for by the words in it") {
    const std::vector<std::string> words = {"set_position", "position", "circle",     "draw_world",
                                            "is_awake",     "awake",    "add_circle", "world_to_screen"};
    CHECK(nearest("getPosition", words) == "position");
    CHECK(nearest("get_position", words) == "position");
    CHECK(nearest("setBodyPosition", words) == "set_position");
    CHECK(nearest("fill_circle", words) == "add_circle");  // an edit distance of 3: a slip is likelier
    CHECK(nearest("draw_filled_circle", words) == "circle");
    CHECK(nearest("isBodyAwake", words) == "is_awake");
    CHECK(nearest("get", words).empty());
    CHECK(nearest("_", words).empty());
}

TEST_CASE("a suggestion names the nearest and lists all") {
    const std::vector<std::string> words = {"ice", "stone", "wood"};
    CHECK(suggestion("wod", words) == "; did you mean \"wood\"? (ice, stone, wood)");
    CHECK(suggestion("zzzzzz", words) == " (ice, stone, wood)");
    CHECK(suggestion("x", {}) == "");
}

}  // namespace
}  // namespace cairn::scripting
