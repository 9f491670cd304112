// Fits the logical picture into the output. Invariant: the picture's offset is whole pixels, so that an
// unscaled picture stays sharp.
#include "render/viewport.h"

#include <algorithm>
#include <cmath>

namespace cairn::engine {
namespace {

Size at_least_one(Size size) {
    return {std::max(size.width, 1), std::max(size.height, 1)};
}

}  // namespace

Viewport make_viewport(Size logical, Size output) {
    Viewport viewport;
    viewport.output = at_least_one(output);
    viewport.logical = at_least_one(logical);
    const auto width = static_cast<float>(viewport.logical.width);
    const auto height = static_cast<float>(viewport.logical.height);
    const auto output_width = static_cast<float>(viewport.output.width);
    const auto output_height = static_cast<float>(viewport.output.height);
    viewport.scale = std::min(output_width / width, output_height / height);
    viewport.offset = {std::floor(0.5f * (output_width - viewport.scale * width)),
                       std::floor(0.5f * (output_height - viewport.scale * height))};
    return viewport;
}

}  // namespace cairn::engine
