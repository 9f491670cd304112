// Plays a piece of sound faster or slower, which also changes its pitch.
// Invariant: the result has round(frames / ratio) frames, at least one; it is computed once per pitch and
// then kept, because SDL2_mixer cannot change the speed of a channel while it plays.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cairn::engine {

/// Interleaved 16-bit stereo. Linear interpolation: its loss of treble is not heard in thuds and cracks, and
/// the steps that are used lie within two octaves.
std::vector<std::int16_t> resample_stereo(std::span<const std::int16_t> samples, double ratio);

}  // namespace cairn::engine
