// Invariant: never reads past the end of the file.
#include "assets/image_end.h"

#include <algorithm>
#include <cstring>

namespace cairn::engine {

bool reaches_end_of_jpeg(std::span<const std::byte> file) {
    constexpr unsigned kEndOfImage = 0xd9, kStartOfScan = 0xda;
    const auto byte = [&](std::size_t at) { return std::to_integer<unsigned>(file[at]); };
    const auto is_restart = [](unsigned marker) { return marker >= 0xd0 && marker <= 0xd7; };
    std::size_t at = 2;
    bool in_scan = false;
    while (at + 2 <= file.size()) {
        if (in_scan) {
            // Coded data up to the next marker; 0xff in them is followed by 0.
            const auto rest = file.subspan(at);
            at +=
                static_cast<std::size_t>(std::find(rest.begin(), rest.end(), std::byte{0xff}) - rest.begin());
            if (at + 2 > file.size()) return false;
        }
        if (byte(at) != 0xff) return false;
        const unsigned marker = byte(at + 1);
        if (marker == kEndOfImage) return true;
        if (marker == 0xff) {  // a fill byte
            ++at;
        } else if (in_scan && (marker == 0 || is_restart(marker))) {
            at += 2;
        } else {
            if (at + 4 > file.size()) return false;
            const std::size_t segment_bytes = byte(at + 2) << 8 | byte(at + 3);
            if (segment_bytes < 2) return false;
            at += 2 + segment_bytes;
            in_scan = marker == kStartOfScan;
        }
    }
    return false;
}

bool reaches_end_of_png(std::span<const std::byte> file) {
    // A chunk is its length, its name, so many bytes, and a checksum.
    constexpr std::size_t kSignature = 8, kName = 4, kFrame = 12;
    std::size_t at = kSignature;
    while (at + kFrame <= file.size()) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < kName; ++i)
            length = length << 8 | std::to_integer<unsigned>(file[at + i]);
        if (length > file.size() - at - kFrame) return false;
        if (std::memcmp(file.data() + at + kName, "IEND", 4) == 0) return true;
        at += kFrame + length;
    }
    return false;
}

}  // namespace cairn::engine
