// Pictures in memory, and reading and writing them as files. PNG and JPEG are read, PNG is written.
// Invariant: rgba holds width * height * 4 bytes, rows from the top, alpha not premultiplied.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/geometry.h>
#include <cairn/engine/result.h>

namespace cairn::engine {

struct Image {
    Size size;
    std::vector<std::uint8_t> rgba;

    /// Asserts that the pixel lies inside.
    const std::uint8_t* pixel(int x, int y) const;
};

/// The widest and highest picture that is decoded: what every graphics processor of the last decade takes as
/// a texture; with 4 bytes per pixel it also bounds what a small, malicious file can make us allocate (256
/// MiB).
inline constexpr int kMaxImageSide = 8192;

/// The size that the file's header states, without decoding. `name` is for the error message.
Result<Size> read_image_size(std::span<const std::byte> file, std::string_view name);
/// The same of a file that is not cut short either; what stands between its header and its end is not looked
/// at.
Result<Size> check_image(std::span<const std::byte> file, std::string_view name);
Result<Image> decode_image(std::span<const std::byte> file, std::string_view name);

Result<std::vector<std::byte>> encode_png(const Image& image);
/// Writes to a path of the operating system, not to a virtual one: for the command line's screenshots.
Result<void> save_png(const Image& image, const std::string& native_path);

}  // namespace cairn::engine
