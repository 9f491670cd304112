// Colors times alpha, for pictures. Invariant: alpha stays, and no component is greater than it afterwards.
#include "render/backend.h"

namespace cairn::engine {

void premultiply(Image& image) {
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const unsigned alpha = image.rgba[i + 3];
        for (std::size_t k = 0; k < 3; ++k)
            image.rgba[i + k] = static_cast<std::uint8_t>((image.rgba[i + k] * alpha + 127) / 255);
    }
}

}  // namespace cairn::engine
