// Whether a JPEG file goes on to its end. Decoders fill what is missing with grey and say nothing.
#pragma once

#include <cstddef>
#include <span>

namespace cairn::engine {

/// Of a file that begins with the start of an image: walks its segments and scans up to the end of the image,
/// behind which there may be anything. Images in segments, as small previews are, do not count.
/// Source: ITU-T T.81, annex B.
bool reaches_end_of_jpeg(std::span<const std::byte> file);

}  // namespace cairn::engine
