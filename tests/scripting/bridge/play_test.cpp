#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <cairn/engine/image.h>
#include <cairn/scripting/play.h>

#include "bridge/replay.h"
#include "scripting/support/lua_bench.h"
#include "support/source_path.h"

namespace cairn::scripting::test {
namespace {

/// The game of the folder tests/scripting/games/replayed, with files of its own to write.
struct Replayed {
    GameFolder folder{{}};
    PlayOptions options{.source = {.program_path = "scripting-tests",
                                   .path = cairn::test::source_path("tests/scripting/games/replayed"),
                                   .name = "replayed",
                                   .assets = {cairn::test::source_path("assets")},
                                   .save_root = folder.path()},
                        .headless = true};

    std::string file(const std::string& name) const { return folder.path() + '/' + name; }
    static std::string text(const std::string& path) {
        std::ifstream file(path);
        std::ostringstream out;
        out << file.rdbuf();
        return out.str();
    }
};

/// Clicks at three frames, without a hash.
const char* const kClicks =
    "cairn-replay 1\ngame replayed\nseed 5\nsize 1280 720\nframes 240\nevents\n"
    "40 mouse_pressed left 640 320\n90 mouse_pressed left 650 330\n150 mouse_pressed left 600 300\n";

TEST_CASE("a replay recorded again is the same, hash and all") {
    Replayed game;
    std::ofstream(game.file("by-hand.replay")) << kClicks;
    game.options.replay = game.file("by-hand.replay");
    game.options.record = game.file("first.replay");
    REQUIRE(play(game.options) == 0);
    game.options.replay = game.file("first.replay");
    game.options.record = game.file("second.replay");
    REQUIRE(play(game.options) == 0);
    const std::string first = Replayed::text(game.file("first.replay"));
    CHECK(first.find("hash ") != std::string::npos);
    CHECK(first == Replayed::text(game.file("second.replay")));

    SECTION("another seed ends elsewhere, and a wrong hash fails the run") {
        std::string other = kClicks;
        other.replace(other.find("seed 5"), 6, "seed 6");
        std::ofstream(game.file("by-hand.replay")) << other;
        game.options.replay = game.file("by-hand.replay");
        REQUIRE(play(game.options) == 0);
        CHECK(first != Replayed::text(game.file("second.replay")));

        auto broken = parse_replay(first, "first");
        REQUIRE(broken);
        broken->hash = *broken->hash ^ 1;
        std::ofstream(game.file("broken.replay")) << to_text(*broken);
        game.options.replay = game.file("broken.replay");
        game.options.record.clear();
        CHECK(play(game.options) != 0);
    }
    SECTION("drawing the run changes nothing") {
        game.options.screenshot = game.file("picture.png");
        game.options.screenshot_frame = 100;
        REQUIRE(play(game.options) == 0);
        CHECK(first == Replayed::text(game.file("second.replay")));
        CHECK(Replayed::text(game.file("picture.png")).size() > 1000);
    }
    SECTION("a window plays the same run to the same end") {
        if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) {
            WARN("no display: the window test is left out (run it under xvfb-run)");
            return;
        }
        game.options.headless = false;
        game.options.screenshot = game.file("window.png");
        REQUIRE(play(game.options) == 0);
        CHECK(first == Replayed::text(game.file("second.replay")));
        const std::string png = Replayed::text(game.file("window.png"));
        const auto image = engine::decode_image(std::as_bytes(std::span(png)), "window.png");
        REQUIRE(image);
        // The ground of the default look lies across the lower half, black sky above.
        const int x = image->size.width / 10;
        CHECK(image->pixel(x, image->size.height * 53 / 100)[1] > 80);
        CHECK(image->pixel(x, image->size.height / 3)[1] < 20);
    }
}

TEST_CASE("recordings of other games, sizes and formats are refused") {
    Replayed game;
    const auto status_of = [&](const std::string& text) {
        std::ofstream(game.file("x.replay")) << text;
        game.options.replay = game.file("x.replay");
        return play(game.options);
    };
    CHECK(status_of("cairn-replay 1\ngame replayed\nseed 5\nsize 1280 720\nframes 2\nevents\n") == 0);
    CHECK(status_of("cairn-replay 1\ngame other\nseed 5\nsize 1280 720\nframes 2\nevents\n") != 0);
    CHECK(status_of("cairn-replay 1\ngame replayed\nseed 5\nsize 800 600\nframes 2\nevents\n") != 0);
    CHECK(status_of("something else") != 0);
    game.options.replay = game.file("none.replay");
    CHECK(play(game.options) != 0);
}

TEST_CASE("a run that ends with an error is recorded as far as it went, and leads there again") {
    Replayed game;
    const GameFolder crashing(
        GameFiles{{"main.lua",
                   "function cairn.key_pressed(key) clicked = key end\n"
                   "function cairn.update() if clicked == 'x' then error('boom') end end"}});
    game.options.source.path = crashing.path();
    std::ofstream(game.file("by-hand.replay"))
        << "cairn-replay 1\ngame replayed\nseed 5\nsize 1280 720\nframes 90\nevents\n40 key_pressed x\n";
    game.options.replay = game.file("by-hand.replay");
    game.options.record = game.file("crash.replay");
    REQUIRE(play(game.options) == 1);
    CHECK(Replayed::text(game.file("crash.replay")) ==
          "cairn-replay 1\ngame replayed\nseed 5\nsize 1280 720\nframes 40\nevents\n40 key_pressed x\n");
    game.options.replay = game.file("crash.replay");
    game.options.record = game.file("again.replay");
    REQUIRE(play(game.options) == 1);
    CHECK(Replayed::text(game.file("again.replay")) == Replayed::text(game.file("crash.replay")));
}

TEST_CASE("files that cannot be written fail the run before it begins") {
    Replayed game;
    game.options.frames = 2;
    CHECK(play(game.options) == 0);
    game.options.frames = std::uint64_t{1} << 62;  // would never be reached
    game.options.record = game.file("no/such/folder/x.replay");
    CHECK(play(game.options) != 0);
    game.options.record.clear();
    game.options.screenshot = game.file("no/such/folder/x.png");
    CHECK(play(game.options) != 0);
}

}  // namespace
}  // namespace cairn::scripting::test
