// The platform on SDL2: a window, its events, real time. Invariant: SDL's video runs exactly as long as the
// platform lives.
#pragma once

#include <cairn/engine/platform.h>

namespace cairn::engine {

Result<std::unique_ptr<Platform>> make_sdl_platform(const PlatformDef& def);

}  // namespace cairn::engine
