// Draws into an SDL window.
// Invariant: with a graphics driver SDL draws the triangles; without one our own rasterizer does, and SDL
// only shows the finished picture, because SDL's software renderer does not draw smooth edges.
#pragma once

#include <memory>

#include <cairn/engine/platform.h>

#include "render/backend.h"

struct SDL_Window;

namespace cairn::engine {

/// The window must outlive the back-end.
Result<std::unique_ptr<RenderBackend>> make_window_backend(SDL_Window* window, const WindowDef& def);

/// The viewport of a window that has `output` pixels.
Viewport window_viewport(SDL_Window* window, const WindowDef& def, Size output);

}  // namespace cairn::engine
