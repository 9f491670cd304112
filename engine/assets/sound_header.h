// Reads how long a WAV or Ogg Vorbis file plays, without decoding it, and refuses headers that sound
// libraries cannot take. Invariant: never reads past the end of the file, and needs no sound library, so a
// headless run knows when a sound ends.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include <cairn/engine/result.h>

namespace cairn::engine {

/// `name` is for the error message.
Result<double> read_sound_duration_s(std::span<const std::byte> file, std::string_view name);

}  // namespace cairn::engine
