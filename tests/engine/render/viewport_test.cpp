// How a logical picture lies in windows of other shapes.
#include "render/viewport.h"

#include <catch2/catch.hpp>

using namespace cairn::engine;

TEST_CASE("a window of the same shape is filled") {
    const Viewport v = make_viewport({1280, 720}, {640, 360});
    CHECK(v.scale == 0.5f);
    CHECK_FALSE(v.has_bars());
    CHECK(v.to_logical({320, 180}) == Vec2{640, 360});
}

TEST_CASE("a window of another shape has bars at two sides") {
    const Viewport wide = make_viewport({100, 100}, {400, 200});
    CHECK(wide.scale == 2);
    CHECK(wide.offset == Vec2{100, 0});
    CHECK(wide.to_logical({100, 0}) == Vec2{0, 0});
    CHECK(wide.to_logical({300, 200}) == Vec2{100, 100});
    const Viewport high = make_viewport({100, 100}, {200, 400});
    CHECK(high.offset == Vec2{0, 100});
}

TEST_CASE("a picture of the window's points is magnified on a high-DPI screen") {
    const Viewport v = make_viewport({800, 600}, {1600, 1200});
    CHECK(v.logical == Size{800, 600});
    CHECK(v.scale == 2);
    CHECK_FALSE(v.has_bars());
}

TEST_CASE("a window without area gives a viewport that can still be computed with") {
    const Viewport v = make_viewport({100, 100}, {0, 0});
    CHECK(v.scale > 0);
    CHECK(v.output == Size{1, 1});
}
