// The choice of the platform. Invariant: this is the only place that knows all of them.
#include <cairn/engine/platform.h>

#include "platform/headless/headless_platform.h"
#include "platform/sdl/sdl_platform.h"

namespace cairn::engine {

Result<std::unique_ptr<Platform>> Platform::create(const PlatformDef& def) {
    for (const auto& [width, height] : {def.window.size, def.window.window_size.value_or(def.window.size)}) {
        if (width < 1 || height < 1 || width > kMaxWindowSide || height > kMaxWindowSide)
            return Error{"window: size " + std::to_string(width) + " x " + std::to_string(height) +
                         " must be 1 to " + std::to_string(kMaxWindowSide) + " on each side"};
    }
    if (def.headless) return make_headless_platform(def);
    return make_sdl_platform(def);
}

}  // namespace cairn::engine
