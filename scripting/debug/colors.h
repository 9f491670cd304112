// The colors of panels over a game.
#pragma once

#include <cairn/engine/geometry.h>

namespace cairn::scripting::panel {

inline constexpr engine::Color kGround{0.07f, 0.09f, 0.12f, 0.86f};
inline constexpr engine::Color kText{0.92f, 0.93f, 0.94f, 1};
inline constexpr engine::Color kQuiet{0.65f, 0.70f, 0.75f, 1};

}  // namespace cairn::scripting::panel
