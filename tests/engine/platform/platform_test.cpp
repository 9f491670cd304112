// The headless platform: nothing happens by itself.
#include <catch2/catch.hpp>

#include <cairn/engine/audio.h>

#include "engine/support/drawing.h"

using namespace cairn::engine;

TEST_CASE_METHOD(Drawing,
                 "a headless platform has no events, no time and a window of the size that was asked for") {
    std::vector<InputEvent> events;
    platform->poll_events(events);
    CHECK(events.empty());
    CHECK(platform->is_headless());
    CHECK(platform->now_s() == 0);
    CHECK(platform->window().logical_size() == Size{64, 48});
    CHECK(platform->window().is_visible());
    platform->window().set_title("t");
    platform->window().set_fullscreen(true);
    CHECK(platform->window().title() == "t");
    CHECK(platform->window().is_fullscreen());
    CHECK(platform->set_clipboard_text("x"));
}

TEST_CASE("a window without area or beyond all screens is an error that names the size") {
    for (const Size size : {Size{0, 10}, {10, -1}, {100000, 10}}) {
        PlatformDef def;
        def.headless = true;
        for (const bool is_own : {false, true}) {
            def.window.size = is_own ? Size{10, 10} : size;
            if (is_own) def.window.window_size = size;
            const auto platform = Platform::create(def);
            REQUIRE_FALSE(platform);
            CHECK_THAT(platform.error().message, Catch::Contains(std::to_string(size.width)));
        }
    }
}

TEST_CASE("a headless window tells of a size that its game gave it, when the picture is to follow") {
    for (const WindowScaling scaling : {WindowScaling::Fit, WindowScaling::Follow}) {
        PlatformDef def;
        def.headless = true;
        def.window.size = {320, 200};
        def.window.scaling = scaling;
        const auto platform = Platform::create(def);
        REQUIRE(platform);
        Window& window = (*platform)->window();
        window.set_size({320, 200});  // as it is
        std::vector<InputEvent> events;
        (*platform)->poll_events(events);
        CHECK(events.empty());
        window.set_size({500, 300});
        (*platform)->poll_events(events);
        (*platform)->poll_events(events);
        CHECK(window.size() == Size{500, 300});
        CHECK(window.logical_size() == Size{320, 200});
        REQUIRE(events.size() == (scaling == WindowScaling::Follow ? 1 : 0));
        if (!events.empty()) CHECK(to_text(events[0]) == "window_resized 500 300");
    }
}

TEST_CASE_METHOD(Drawing, "a screenshot saved as PNG decodes to the pixels that were drawn") {
    renderer->begin_frame({0.2f, 0.4f, 0.6f, 1});
    renderer->fill_circle({30, 20}, 12, {1, 0.5f, 0, 1});
    const Image picture = capture();
    put_png("shot.png", picture);
    const auto file = files->read_bytes("shot.png");
    REQUIRE(file);
    const auto decoded = decode_image(*file, "shot.png");
    REQUIRE(decoded);
    CHECK(decoded->size == Size{64, 48});
    CHECK(decoded->rgba == picture.rgba);
}
