#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include <cairn/scripting/reference.h>

#include "bridge/other_words.h"
#include "support/source_path.h"

namespace cairn::scripting {
namespace {

std::string file_text(const std::string& path) {
    std::ifstream file(cairn::test::source_path(path));
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// To renew them: cairn help --reference > docs/reference/lua.md; cairn help --types >
// scripting/types/cairn.lua
TEST_CASE("the committed reference is the one that the bindings give") {
    const bool is_same = file_text("docs/reference/lua.md") == reference_markdown();
    INFO("to renew it: cairn help --reference > docs/reference/lua.md");
    CHECK(is_same);
}

TEST_CASE("the committed format of levels is the one that the descriptions give") {
    const bool is_same = file_text("docs/reference/levels.md") == level_reference_markdown();
    INFO("to renew it: cairn help --levels > docs/reference/levels.md");
    CHECK(is_same);
}

TEST_CASE("the committed annotations are those that the bindings give") {
    const bool is_same = file_text("scripting/types/cairn.lua") == editor_annotations();
    INFO("to renew them: cairn help --types > scripting/types/cairn.lua");
    CHECK(is_same);
}

TEST_CASE("a name is found as an author would type it") {
    const auto text = [](const char* name) {
        auto found = reference_of(name);
        return found ? *found : found.error().message;
    };
    for (const char* name : {"world:step", "World:step", "world:step(dt)"})
        CHECK_THAT(text(name), Catch::StartsWith("### `world:step(dt)`\n\nMoves the world on"));
    CHECK(text("cairn.audio.play") == text("audio.play"));
    CHECK_THAT(text("audio.play"), Catch::Contains("volume"));  // its fields
    // All that are called so.
    CHECK_THAT(text("position"),
               Catch::Contains("`body:position()") && Catch::Contains("`transforms:position("));
    // Of modules and types what they have, in short.
    CHECK_THAT(text("audio"), Catch::StartsWith("## cairn.audio\n") &&
                                  Catch::Contains("    cairn.audio.stop(voice)\n") &&
                                  !Catch::Contains("###"));
    CHECK_THAT(text("Body"), Catch::StartsWith("## Body\n") && Catch::Contains("    body:mass() -> mass\n"));
    // What a game gives is found as what it is given.
    CHECK_THAT(text("key_pressed"),
               Catch::StartsWith("### `cairn.key_pressed(key, is_repeat)`\n\nA callback: "));
    CHECK_THAT(text("update"),
               Catch::Contains("`cairn.update(dt)`") && Catch::Contains("`camera:update(dt)`"));
    CHECK_THAT(text("cairn.update"),
               Catch::StartsWith("### `cairn.update(dt)`") && !Catch::Contains("`camera:update(dt)`"));
    CHECK_THAT(text("cairn.step"), Catch::StartsWith("### `world:step(dt)`"));
    CHECK_THAT(text("callbacks"), Catch::Contains("`cairn.quit_requested()`"));
    CHECK_THAT(text("conf.lua"), Catch::Contains("| `vsync` | boolean | true |"));
    CHECK_THAT(text("updates_per_second"), Catch::StartsWith("### `updates_per_second` in conf.lua\n") &&
                                               Catch::Contains("| 60 |") &&
                                               Catch::Contains("from 10 to 240"));
    CHECK_THAT(text("wheel"), Catch::Contains("`cairn.wheel(dx, dy)`") &&
                                  Catch::Contains("See also world:add_wheel_joint.\n"));
    CHECK_THAT(text("wheeel"), Catch::Contains("did you mean \"wheel\"?"));
    CHECK_THAT(text("key_presed"), Catch::Contains("did you mean \"key_pressed\"?"));
    CHECK_THAT(text("particle"), Catch::Contains("did you mean \"particles\"?"));
    CHECK_THAT(text("world:stepp"), Catch::Contains("did you mean \"world:step\"?"));
    CHECK_THAT(text("aply_force"), Catch::Contains("did you mean \"apply_force\"?"));
    CHECK_THAT(text("qqqqqqq"), Catch::Equals("the reference has nothing that is called \"qqqqqqq\""));
}

TEST_CASE("a field is found with all tables that have it") {
    const auto text = [](const char* name) {
        auto found = reference_of(name);
        return found ? *found : found.error().message;
    };
    CHECK_THAT(text("density"),
               Catch::Contains("### `shape:density() -> density`") && Catch::Contains("`density` in ") &&
                   Catch::Contains("world:add_box{...}") && Catch::Contains("body:add_circle{...}") &&
                   Catch::Contains("\n| `density` | number | "));
    CHECK_THAT(text("suspension_travel"),
               Catch::StartsWith("### `suspension_travel` in cairn.prefab.vehicle{...}\n"));
    // What is described in the same words is told once.
    const std::string sensor = text("sensor");
    CHECK(sensor.find("| `sensor` |") == sensor.rfind("| `sensor` |"));
    CHECK_THAT(text("template"), Catch::Contains("bodies of levels"));
    CHECK_THAT(text("denstiy"), Catch::Contains("did you mean \"density\"?"));
    CHECK_THAT(text("motor_speeds"), Catch::Contains("did you mean \"motor_speed\"?"));
}

TEST_CASE("every word of another framework leads to what Cairn has") {
    REQUIRE_FALSE(other_words().empty());
    for (const OtherWord& entry : other_words()) {
        std::istringstream words{std::string(entry.words)};
        for (std::string word; words >> word;) {
            INFO(word);
            const auto text = reference_of(word);
            REQUIRE(text);
            CHECK(other_word(word) == &entry);
            std::istringstream names{std::string(entry.names)};
            for (std::string name; names >> name;) {
                INFO(name);
                CHECK(reference_of(name));
                CHECK_THAT(*text, Catch::Contains(name));
            }
            CHECK((!entry.names.empty() || !entry.note.empty()));
        }
    }
    CHECK(other_word("") == nullptr);
    CHECK_THAT(*reference_of("hinge"),
               Catch::StartsWith("`hinge` is in Cairn: `world:add_revolute_joint`.\n") &&
                   Catch::Contains("### `world:add_revolute_joint{...} -> joint`"));
    CHECK_THAT(*reference_of("bullet"), Catch::Contains("there is nothing to set"));
    CHECK_THAT(*reference_of("max_length"),
               Catch::Contains("`max_length` in world:add_distance_joint{...}\n") &&
                   Catch::Contains("cairn.prefab.rope"));
    // A name that Cairn has, for another thing.
    CHECK_THAT(*reference_of("trigger"), Catch::StartsWith("### `level:trigger(name)") &&
                                             Catch::Contains("See also ") && Catch::Contains("sensor"));
    for (const char* name : {"love.graphics.newImage", "newImage", "NewImage"})
        CHECK_THAT(*reference_of(name), Catch::StartsWith("### `cairn.graphics.new_image("));
    CHECK_THAT(*reference_of("OnTriggerEnter"), Catch::Contains("### `world:sensor_events()"));
    CHECK_THAT(*reference_of("love.keypressed"), Catch::Contains("`cairn.key_pressed("));
}

}  // namespace
}  // namespace cairn::scripting
