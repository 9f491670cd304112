// Linear resampling. Invariant: every sample that is read lies inside the input.
#include "audio/sdl/resample.h"

#include <algorithm>
#include <cmath>

namespace cairn::engine {

std::vector<std::int16_t> resample_stereo(std::span<const std::int16_t> samples, double ratio) {
    const std::size_t frames = samples.size() / 2;
    if (frames == 0) return {};
    const auto out_frames =
        std::max<std::size_t>(1, static_cast<std::size_t>(std::llround(static_cast<double>(frames) / ratio)));
    std::vector<std::int16_t> out(2 * out_frames);
    for (std::size_t i = 0; i < out_frames; ++i) {
        const double at = std::min(static_cast<double>(i) * ratio, static_cast<double>(frames - 1));
        const auto before = static_cast<std::size_t>(at);
        const std::size_t after = std::min(before + 1, frames - 1);
        const double share = at - static_cast<double>(before);
        for (std::size_t side = 0; side < 2; ++side) {
            const double low = samples[2 * before + side];
            const double high = samples[2 * after + side];
            out[2 * i + side] = static_cast<std::int16_t>(std::lround(low + (high - low) * share));
        }
    }
    return out;
}

}  // namespace cairn::engine
