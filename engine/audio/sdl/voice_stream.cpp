// The place in the sound is a double: a minute has 2.6 million frames, so it is exact to far less than one.
#include "audio/sdl/voice_stream.h"

#include <algorithm>
#include <cmath>

namespace cairn::engine {

void VoiceStream::start(std::span<const std::int16_t> samples, float pitch, bool loop) {
    samples_ = samples;
    pitch_ = pitch;
    loop_ = loop;
    at_ = 0;
    is_over_ = samples.size() < 2;
}

void VoiceStream::fill(std::span<std::int16_t> out) {
    const std::size_t frames = samples_.size() / 2;
    const auto end = static_cast<double>(frames);
    const double step = static_cast<double>(pitch_.load());
    std::size_t i = 0;
    for (; i + 1 < out.size() && !is_over_; i += 2) {
        const auto before = static_cast<std::size_t>(at_);
        const std::size_t next = before + 1 < frames ? before + 1 : loop_ ? 0 : before;
        const double share = at_ - static_cast<double>(before);
        for (std::size_t side = 0; side < 2; ++side) {
            const double low = samples_[2 * before + side];
            const double high = samples_[2 * next + side];
            out[i + side] = static_cast<std::int16_t>(std::lround(low + (high - low) * share));
        }
        at_ += step;
        if (at_ < end) continue;
        if (loop_) {
            at_ = std::fmod(at_, end);
        } else {
            is_over_ = true;
        }
    }
    std::fill(out.begin() + static_cast<std::ptrdiff_t>(i), out.end(), std::int16_t{0});
}

}  // namespace cairn::engine
