// What a voice sounds like from one buffer of the device to the next: a decoded sound, read as fast as its
// pitch asks for, which may change while it plays.
// Invariant: every sample that is read lies inside the sound; behind its end there is silence.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>

namespace cairn::engine {

/// `fill` is called by the audio thread, `set_pitch` and `is_over` by any; `start` only while nobody fills.
class VoiceStream {
  public:
    /// Interleaved 16-bit stereo, which must stay where it is until nobody fills any more.
    void start(std::span<const std::int16_t> samples, float pitch, bool loop);
    /// Frames of the sound for each frame of the device.
    void set_pitch(float pitch) { pitch_ = pitch; }
    /// Linear interpolation: its loss of treble is not heard in thuds and engines.
    void fill(std::span<std::int16_t> out);
    [[nodiscard]] bool is_over() const { return is_over_; }

  private:
    std::span<const std::int16_t> samples_;
    std::atomic<float> pitch_ = 1;
    std::atomic<bool> is_over_ = true;
    bool loop_ = false;
    double at_ = 0;  ///< frames, where the next one is read
};

}  // namespace cairn::engine
