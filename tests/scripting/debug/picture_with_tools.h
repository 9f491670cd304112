// Pictures of a game with the tools over it.
#pragma once

#include "debug/developer_tools.h"
#include "scripting/support/drawing.h"

namespace cairn::scripting::test {

inline engine::Image picture_with(LuaBench& bench, DeveloperTools& tools) {
    engine::Renderer& renderer = *bench.machine().renderer;
    renderer.begin_frame({0, 0, 0, 1});
    REQUIRE_FALSE(bench.game().draw(1));
    tools.draw(bench.game());
    auto image = renderer.capture();
    renderer.end_frame();
    REQUIRE(image);
    return *std::move(image);
}

}  // namespace cairn::scripting::test
