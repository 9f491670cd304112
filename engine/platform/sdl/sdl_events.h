// Translates SDL's events into plain input values. Invariant: an event that has no meaning for games gives
// nothing.
#pragma once

#include <optional>

#include <cairn/engine/input.h>

#include "platform/sdl/sdl_window.h"

union SDL_Event;

namespace cairn::engine {

std::optional<InputEvent> translate(const SDL_Event& event, const SdlWindow& window);

}  // namespace cairn::engine
