// Draws into an SDL window.
// Invariant: with a graphics driver SDL draws the triangles; without one our own rasterizer does, and SDL
// only shows the finished picture, because SDL's software renderer does not draw smooth edges.
#pragma once

#include <memory>

#include "platform/sdl/sdl_window.h"
#include "render/backend.h"

namespace cairn::engine {

/// The window must outlive the back-end.
Result<std::unique_ptr<RenderBackend>> make_window_backend(const SdlWindow& window);

}  // namespace cairn::engine
