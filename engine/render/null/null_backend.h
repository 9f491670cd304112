// Draws nothing: for games that run headlessly without pictures.
// Invariant: everything that can be asked has the same answer as with the surface back-end of the same size,
// except read_pixels, which is an error.
#pragma once

#include <memory>

#include "render/backend.h"

namespace cairn::engine {

std::unique_ptr<RenderBackend> make_null_backend(AskViewport viewport);

}  // namespace cairn::engine
