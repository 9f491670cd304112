// The shelf of games that `cairn` alone shows, played like any other game.
#include <catch2/catch.hpp>
#include <fstream>

#include <cairn/scripting/play.h>

#include "scripting/support/lua_bench.h"
#include "support/source_path.h"

namespace cairn::scripting::test {
namespace {

/// A folder with three games, one of them a level deeper, and what is no game.
const GameFiles kGames{
    {"apple/main.lua", ""},          {"apple/conf.lua", "return { title = \"Apple Pie\" }"},
    {"bread/conf.lua", "return {}"}, {"more/cake/main.lua", ""},
    {"nuts/main.lua", ""},           {"nuts/picture.png", "no picture"}};

PlayResult launch(const std::string& events) {
    const GameFolder games(kGames);
    const std::string replay = games.path() + "/launch.replay";
    std::ofstream(replay) << "cairn-replay 1\ngame launcher\nseed 1\nsize 1280 720\nframes 30\nevents\n"
                          << events;
    PlayResult result;
    REQUIRE(play({.source = {.program_path = "scripting-tests",
                             .path = cairn::test::source_path("tools/player/launcher"),
                             .name = "launcher",
                             .assets = {cairn::test::source_path("assets"), games.path()},
                             .save_root = games.path()},
                  .headless = true,
                  .replay = replay,
                  .result = &result}) == 0);
    return result;
}

TEST_CASE("the launcher gives the folder of the game that is chosen, whatever chooses it") {
    CHECK(launch("5 key_pressed return\n").level == "apple");
    CHECK(launch("5 key_pressed right\n6 key_pressed return\n").level == "more/cake");
    CHECK(launch("5 key_pressed d\n6 key_released d\n7 key_pressed d\n8 key_pressed space\n").level ==
          "nuts");
    CHECK(launch("5 mouse_pressed left 600 200\n6 mouse_released left 600 200\n").level == "more/cake");
    CHECK(
        launch("2 gamepad_connected 1 pad\n5 gamepad_pressed 1 dpad_right\n6 gamepad_pressed 1 a\n").level ==
        "more/cake");
}

TEST_CASE("who leaves the launcher, or lets go beside a card, has chosen nothing") {
    CHECK(launch("5 key_pressed escape\n").outcome.empty());
    CHECK(launch("5 mouse_pressed left 600 200\n6 mouse_released left 10 10\n").outcome.empty());
    CHECK(launch("").outcome.empty());
}

}  // namespace
}  // namespace cairn::scripting::test
