// cairn.window headless: what a game changes of its window has the same effect as on a desktop.
#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

/// Runs as many frames, with what the window has to tell.
void frames(LuaBench& bench, int count) {
    for (; count > 0; --count) {
        std::vector<engine::InputEvent> events;
        bench.machine().platform->poll_events(events);
        const auto error = bench.game().update(events);
        if (error) FAIL(error->to_text());
    }
}

constexpr const char* kFollowing = "return { width = 400, height = 300, scaling = 'follow' }";
constexpr const char* kNoteSizes =
    "log = '' function cairn.window_resized(w, h) log = log .. w .. 'x' .. h .. ' ' end";
constexpr const char* kSizes =
    "table.concat({ cairn.window.size() }, 'x') .. ' in ' .. "
    "table.concat({ cairn.window.window_size() }, 'x')";

}  // namespace

TEST_CASE("a game may draw in other pixels than its window has, and change them") {
    LuaBench bench(
        {{"conf.lua", "return { width = 320, height = 180, window_width = 1280, window_height = 720 }"}},
        MachineKind::HeadlessDrawing);
    CHECK(bench.value(kSizes) == "320x180 in 1280x720");
    CHECK(bench.value("cairn.window.pixel_scale()") == "4.0");
    CHECK(bench.run("cairn.window.set_logical_size(640, 360)") == "");
    CHECK(bench.value(kSizes) == "640x360 in 1280x720");
    CHECK(bench.value("cairn.window.pixel_scale()") == "2.0");

    REQUIRE(bench.run("function cairn.draw() cairn.graphics.set_color(1, 1, 1) "
                      "cairn.graphics.rectangle('fill', 0, 0, 320, 360) end") == "");
    engine::Renderer& renderer = *bench.machine().renderer;
    renderer.begin_frame({0, 0, 0, 1});
    REQUIRE_FALSE(bench.game().draw(1));
    const auto picture = renderer.capture();
    renderer.end_frame();
    REQUIRE(picture);
    CHECK(picture->size == engine::Size{1280, 720});
    CHECK(picture->pixel(639, 719)[0] == 255);
    CHECK(picture->pixel(640, 719)[0] == 0);
}

TEST_CASE("a picture that follows its window takes its size one update later, and says so") {
    LuaBench bench(GameFiles{{"conf.lua", kFollowing}});
    REQUIRE(bench.run(kNoteSizes) == "");
    frames(bench, 1);
    CHECK(bench.value("log") == "");
    CHECK(bench.run("cairn.window.set_window_size(500, 200)") == "");
    CHECK(bench.value(kSizes) == "400x300 in 500x200");
    frames(bench, 3);
    CHECK(bench.value(kSizes) == "500x200 in 500x200");
    CHECK(bench.value("log") == "500x200 ");
}

TEST_CASE("a picture that fits stays as it is whatever the window does") {
    LuaBench bench(GameFiles{{"conf.lua", "return { width = 400, height = 300 }"}});
    REQUIRE(bench.run(kNoteSizes) == "");
    CHECK(bench.run("cairn.window.set_window_size(500, 200)") == "");
    frames(bench, 2);
    CHECK(bench.value(kSizes) == "400x300 in 500x200");
    CHECK(bench.value("log") == "");
}

TEST_CASE("a recorded change of the window's size does the same as the change itself") {
    LuaBench bench(GameFiles{{"conf.lua", kFollowing}});
    REQUIRE(bench.run(kNoteSizes) == "");
    const std::vector<engine::InputEvent> events = {*engine::input_event_from_text("window_resized 800 600"),
                                                    *engine::input_event_from_text("window_resized 800 600")};
    REQUIRE_FALSE(bench.game().update(events));
    CHECK(bench.value("log") == "800x600 ");
    CHECK(bench.value("table.concat({ cairn.window.size() }, 'x')") == "800x600");
}

TEST_CASE("full screen and whether the player may resize are kept, and left by a new size") {
    LuaBench bench(GameFiles{{"conf.lua", "return { fullscreen = true, resizable = false }"}});
    CHECK(bench.value("cairn.window.is_fullscreen()") == "true");
    CHECK(bench.value("cairn.window.is_resizable()") == "false");
    CHECK(bench.run("cairn.window.set_resizable(true) cairn.window.set_window_size(300, 200)") == "");
    CHECK(bench.value("cairn.window.is_resizable()") == "true");
    CHECK(bench.value("cairn.window.is_fullscreen()") == "false");
}

TEST_CASE("sizes that no window has are errors that name the rule") {
    LuaBench bench;
    const std::string rule = "expected an integer from 1 to 8192";
    for (const char* call : {"set_logical_size(0, 10)", "set_logical_size(10, 8193)",
                             "set_window_size(-5, 10)", "set_window_size(10, 2^53)"}) {
        CAPTURE(call);
        CHECK(bench.run(std::string("cairn.window.") + call).find(rule) != std::string::npos);
    }
    CHECK(bench.value(kSizes) == "1280x720 in 1280x720");
}

}  // namespace cairn::scripting::test
