// Decodes PNG files with libpng. Invariant: nothing reaches standard error; a file that cannot be read is an
// error in libpng's words.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include <cairn/engine/image.h>

namespace cairn::engine {

bool is_png(std::span<const std::byte> file);

/// `size` is what the header states, which was found to be sane. `name` is for messages.
Result<Image> decode_png(std::span<const std::byte> file, Size size, std::string_view name);

}  // namespace cairn::engine
