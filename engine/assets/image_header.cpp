// Reads the size that a PNG or JPEG file states, and looks whether it has an end, without decoding it.
// Invariant: never reads past the end of the file; a size is only returned when it lies in 1 ..
// kMaxImageSide. Source: PNG (Portable Network Graphics) Specification, 3rd edition, section 11.2.1 IHDR;
// ITU-T T.81, annex B.
#include <array>
#include <cstring>
#include <optional>

#include <cairn/engine/image.h>

#include "assets/image_end.h"

namespace cairn::engine {
namespace {

using Bytes = std::span<const std::byte>;

constexpr std::array<unsigned char, 8> kPngSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

unsigned big_endian(Bytes file, std::size_t at, int bytes) {
    unsigned value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8 | std::to_integer<unsigned>(file[at + i]);
    return value;
}

Error image_error(std::string_view name, std::string_view reason) {
    return Error{"image '" + std::string(name) + "': " + std::string(reason)};
}

struct StatedSize {
    unsigned width;
    unsigned height;
};

std::optional<StatedSize> png_size(Bytes file) {
    // Signature, length of the first chunk, its name, and then the two sizes.
    constexpr std::size_t kName = 12, kWidth = 16, kHeight = 20, kEnd = 24;
    if (file.size() < kEnd || std::memcmp(file.data() + kName, "IHDR", 4) != 0) return std::nullopt;
    return StatedSize{big_endian(file, kWidth, 4), big_endian(file, kHeight, 4)};
}

std::optional<StatedSize> jpeg_size(Bytes file) {
    // Walks the marker segments up to the start of frame, which holds the size.
    std::size_t at = 2;
    while (at + 4 <= file.size()) {
        if (std::to_integer<unsigned>(file[at]) != 0xff) return std::nullopt;
        const unsigned marker = std::to_integer<unsigned>(file[at + 1]);
        if (marker == 0xff) {  // a fill byte
            ++at;
            continue;
        }
        const unsigned segment_bytes = big_endian(file, at + 2, 2);
        // C4, C8 and CC lie in the range of the frame markers, but are tables.
        const bool starts_frame =
            marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (starts_frame) {
            if (at + 9 > file.size()) return std::nullopt;
            return StatedSize{big_endian(file, at + 7, 2), big_endian(file, at + 5, 2)};
        }
        if (segment_bytes < 2) return std::nullopt;
        at += 2 + segment_bytes;
    }
    return std::nullopt;
}

bool has_png_signature(Bytes file) {
    return file.size() >= kPngSignature.size() &&
           std::memcmp(file.data(), kPngSignature.data(), kPngSignature.size()) == 0;
}

}  // namespace

Result<Size> read_image_size(Bytes file, std::string_view name) {
    std::optional<StatedSize> size;
    if (has_png_signature(file))
        size = png_size(file);
    else if (file.size() >= 2 && big_endian(file, 0, 2) == 0xffd8)
        size = jpeg_size(file);
    else
        return image_error(name, "is neither a PNG nor a JPEG file");
    if (!size) return image_error(name, "is damaged: its header is incomplete");
    if (size->width < 1 || size->height < 1 || size->width > kMaxImageSide || size->height > kMaxImageSide)
        return image_error(name, "states a size of " + std::to_string(size->width) + " x " +
                                     std::to_string(size->height) + "; each side must be 1 to " +
                                     std::to_string(kMaxImageSide));
    return Size{static_cast<int>(size->width), static_cast<int>(size->height)};
}

Result<Size> check_image(Bytes file, std::string_view name) {
    Result<Size> size = read_image_size(file, name);
    if (!size) return size;
    const bool reaches_end = has_png_signature(file) ? reaches_end_of_png(file) : reaches_end_of_jpeg(file);
    if (!reaches_end) return image_error(name, "is damaged: it ends too early");
    return size;
}

}  // namespace cairn::engine
