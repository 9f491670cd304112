// Color bleeding. Invariant: only pixels with alpha 0 are written, and only ones with alpha above 0 are read.
#include "render/bleed.h"

#include <algorithm>
#include <array>

namespace cairn::engine {

void bleed_into_transparent(Image& image) {
    for (int y = 0; y < image.size.height; ++y)
        for (int x = 0; x < image.size.width; ++x) {
            if (image.pixel(x, y)[3] != 0) continue;
            std::array<int, 3> sum = {};
            int visible = 0;
            for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, image.size.height - 1); ++ny)
                for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, image.size.width - 1); ++nx) {
                    const std::uint8_t* neighbour = image.pixel(nx, ny);
                    if (neighbour[3] == 0) continue;
                    for (std::size_t i = 0; i < 3; ++i) sum[i] += neighbour[i];
                    ++visible;
                }
            if (visible == 0) continue;
            std::uint8_t* pixel = image.rgba.data() + (image.pixel(x, y) - image.rgba.data());
            for (std::size_t i = 0; i < 3; ++i) pixel[i] = static_cast<std::uint8_t>(sum[i] / visible);
        }
}

}  // namespace cairn::engine
