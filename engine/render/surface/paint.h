// How the pixels of triangles are colored.
#pragma once

#include "render/backend.h"

namespace cairn::engine {

struct Paint {
    const Image* texture = nullptr;  ///< null: plain colors
    TextureFilter filter = TextureFilter::Linear;
    BlendMode blend = BlendMode::Alpha;
};

}  // namespace cairn::engine
