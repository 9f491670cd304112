// Whether a WAV or Ogg Vorbis file is whole.
// Invariant: never reads past the end of the file, and needs no sound library.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include <cairn/engine/result.h>

namespace cairn::engine {

/// Reads all of it: of WAV the chunks, of Ogg each page with its checksum, which covers every byte. Players
/// are more lenient, and play silence or nothing where a file is cut off. `name` is for the error message.
Result<void> check_sound_bytes(std::span<const std::byte> file, std::string_view name);

}  // namespace cairn::engine
