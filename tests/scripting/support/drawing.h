// Pictures of what a game draws, in memory.
#pragma once

#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>

#include <cairn/engine/image.h>

#include "bind/graphics_objects.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {

/// Runs `code` as cairn.draw and gives the picture; with `keeps_callback`, the cairn.draw that is there.
inline engine::Image picture_of(LuaBench& bench, const std::string& code, bool keeps_callback = false) {
    if (!keeps_callback) REQUIRE(bench.run("function cairn.draw() " + code + " end") == "");
    engine::Renderer& renderer = *bench.machine().renderer;
    renderer.begin_frame({0, 0, 0, 1});
    const auto error = bench.game().draw(1);
    if (error) FAIL(error->to_text());
    auto image = renderer.capture();
    renderer.end_frame();
    if (!image) FAIL(image.error().message);
    return *std::move(image);
}

/// The message with which `code` fails as cairn.draw, or nothing.
inline std::string draw_error(LuaBench& bench, const std::string& code) {
    REQUIRE(bench.run("function cairn.draw() " + code + " end") == "");
    bench.machine().renderer->begin_frame({});
    const auto error = bench.game().draw(1);
    bench.machine().renderer->end_frame();
    return error ? error->message : "";
}

inline void is_color(const engine::Image& image, int x, int y, int r, int g, int b) {
    const std::uint8_t* p = image.pixel(x, y);
    INFO("pixel " << x << ' ' << y << " is " << int(p[0]) << ' ' << int(p[1]) << ' ' << int(p[2]));
    CHECK(std::abs(p[0] - r) <= 2);
    CHECK(std::abs(p[1] - g) <= 2);
    CHECK(std::abs(p[2] - b) <= 2);
}

}  // namespace cairn::scripting::test
