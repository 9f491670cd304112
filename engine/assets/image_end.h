// Whether the file of a picture goes on to its end, without decoding it. Decoders of JPEG fill what is
// missing with grey and say nothing.
#pragma once

#include <cstddef>
#include <span>

namespace cairn::engine {

/// Of a file that begins with the start of an image: walks its segments and scans up to the end of the image,
/// behind which there may be anything. Images in segments, as small previews are, do not count.
/// Source: ITU-T T.81, annex B.
bool reaches_end_of_jpeg(std::span<const std::byte> file);

/// Of a file that begins with the signature: walks its chunks up to the one that ends it, behind which there
/// may be anything. Source: PNG (Portable Network Graphics) Specification, 3rd edition, section 5.
bool reaches_end_of_png(std::span<const std::byte> file);

}  // namespace cairn::engine
