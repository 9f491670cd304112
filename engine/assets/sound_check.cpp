// The containers of sounds, from the first byte to the last.
// What of a WAV file is refused, SDL 2.26 and SDL_mixer 2.6 refuse too.
// Source: Microsoft and IBM, "Multimedia Programming Interface and Data Specifications 1.0" (RIFF WAVE); RFC
// 3533 (Ogg: pages, their checksum and flags).
#include "assets/sound_check.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>

#include <cairn/engine/audio.h>
#include <cairn/engine/files.h>

#include "assets/sound_header.h"

namespace cairn::engine {
namespace {

using Bytes = std::span<const std::byte>;
/// What is wrong; empty: nothing.
using Reason = std::string;

std::uint32_t word_at(Bytes file, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i > 0; --i) value = value << 8 | std::to_integer<std::uint32_t>(file[at + i - 1]);
    return value;
}

bool has_text(Bytes file, std::size_t at, std::string_view text) {
    return at + text.size() <= file.size() && std::memcmp(file.data() + at, text.data(), text.size()) == 0;
}

std::uint32_t half_at(Bytes file, std::size_t at) {
    return std::to_integer<std::uint32_t>(file[at]) | std::to_integer<std::uint32_t>(file[at + 1]) << 8;
}

/// A way to write samples that SDL reads.
struct Encoding {
    std::uint32_t code;
    const char* name;
    std::array<std::uint32_t, 4> bits;  ///< that a sample may have
    bool is_plain;                      ///< a sample is a number of bytes, and no part of a block
};
constexpr Encoding kEncodings[] = {{1, "PCM", {8, 16, 24, 32}, true}, {2, "Microsoft ADPCM", {4}, false},
                                   {3, "floats", {32}, true},         {6, "A-law", {8}, true},
                                   {7, "mu-law", {8}, true},          {17, "IMA ADPCM", {4}, false}};

/// What SDL would refuse of the samples' encoding, in the body of a format chunk. How many channels they
/// have, and which rate, is looked at with the header.
Reason encoding_fault(Bytes format) {
    constexpr std::uint32_t kExtensible = 0xfffe;  // the code stands further on
    constexpr std::size_t kShortest = 16, kExtended = 40, kExtendedCode = 24;
    constexpr std::size_t kChannels = 2, kFrameBytes = 12, kBits = 14;
    if (format.size() < kShortest) return "is damaged: its format takes less than 16 bytes";
    std::uint32_t code = half_at(format, 0);
    if (code == kExtensible && format.size() >= kExtended) code = half_at(format, kExtendedCode);
    const auto* encoding = std::find_if(std::begin(kEncodings), std::end(kEncodings),
                                        [&](const Encoding& known) { return known.code == code; });
    if (encoding == std::end(kEncodings)) {
        std::string all;
        for (const Encoding& known : kEncodings)
            all += (all.empty() ? "" : ", ") + std::to_string(known.code) + " (" + known.name + ')';
        return "has the encoding " + std::to_string(code) + ", but must have one of " + all;
    }
    const std::uint32_t bits = half_at(format, kBits);
    std::string allowed;
    bool is_allowed = false;
    for (const std::uint32_t possible : encoding->bits) {
        if (possible == 0) continue;
        allowed += (allowed.empty() ? "" : ", ") + std::to_string(possible);
        is_allowed = is_allowed || bits == possible;
    }
    if (!is_allowed)
        return "has " + std::to_string(bits) + " bits a sample, but as " + encoding->name + " must have " +
               (allowed.find(',') == std::string::npos ? "" : "one of ") + allowed;
    const std::uint32_t frame = half_at(format, kFrameBytes);
    const std::uint32_t right = half_at(format, kChannels) * bits / 8;
    // SDL takes parts of a frame for what a careless program meant as one.
    if (encoding->is_plain && (frame < 1 || right % frame != 0))
        return "has " + std::to_string(frame) + " bytes a frame, but must have " + std::to_string(right);
    return {};
}

Reason wav_fault(Bytes file) {
    constexpr std::size_t kRiffHeader = 12, kChunkHeader = 8;
    for (std::size_t chunk = kRiffHeader; chunk + kChunkHeader <= file.size();) {
        const std::size_t size = word_at(file, chunk + 4);
        const std::size_t present = file.size() - chunk - kChunkHeader;
        if (size > present) {
            const bool holds_samples = has_text(file, chunk, "data");
            return "is cut off: its " + std::string(holds_samples ? "samples" : "header") + " should take " +
                   std::to_string(size) + " bytes, and " + std::to_string(present) + " are there";
        }
        if (has_text(file, chunk, "fmt ")) {
            if (Reason reason = encoding_fault(file.subspan(chunk + kChunkHeader, size)); !reason.empty())
                return reason;
        }
        chunk += kChunkHeader + size + (size & 1);  // chunks start at even places
    }
    return {};
}

/// CRC-32 with the polynomial 0x04c11db7, from the highest bit on, starting from 0.
constexpr std::array<std::uint32_t, 256> kCrcTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t crc = i << 24;
        for (int bit = 0; bit < 8; ++bit) crc = crc << 1 ^ ((crc >> 31) != 0 ? 0x04c11db7u : 0);
        table[i] = crc;
    }
    return table;
}();

Reason ogg_fault(Bytes file) {
    constexpr std::size_t kPageHeader = 27, kFlags = 5, kChecksum = 22, kSegments = 26;
    constexpr std::byte kLastPage{4};
    bool has_end = false;
    for (std::size_t page = 0; page < file.size();) {
        const std::string place = "the page at byte " + std::to_string(page);
        if (!has_text(file, page, "OggS"))
            return "is damaged: at byte " + std::to_string(page) + " a page should begin";
        std::size_t length = kPageHeader;
        if (page + length <= file.size()) {
            const auto segments = std::to_integer<std::size_t>(file[page + kSegments]);
            for (std::size_t i = 0; i < segments && page + kPageHeader + i < file.size(); ++i)
                length += std::to_integer<std::size_t>(file[page + kPageHeader + i]);
            length += segments;
        }
        if (length > file.size() - page)
            return "is cut off: " + place + " goes on behind the end of the file";
        std::uint32_t crc = 0;
        for (std::size_t i = 0; i < length; ++i) {
            const bool is_checksum = i >= kChecksum && i < kChecksum + 4;  // counts as 0
            const auto byte = is_checksum ? 0 : std::to_integer<std::uint32_t>(file[page + i]);
            crc = crc << 8 ^ kCrcTable[(crc >> 24) ^ byte];
        }
        if (crc != word_at(file, page + kChecksum))
            return "is damaged: " + place + " does not have the checksum that it states";
        has_end = (file[page + kFlags] & kLastPage) != std::byte{0};
        page += length;
    }
    return has_end ? "" : "is cut off: its last page is not the end of the stream";
}

}  // namespace

Result<void> check_sound_bytes(Bytes file, std::string_view name) {
    if (const auto header = read_sound_duration_s(file, name); !header) return header.error();
    const Reason reason = has_text(file, 0, "RIFF") ? wav_fault(file) : ogg_fault(file);
    if (reason.empty()) return {};
    return Error{"sound '" + std::string(name) + "': " + reason};
}

Result<void> check_sound(const Files& files, std::string_view path) {
    const auto file = files.read_bytes(path);
    if (!file) return Error{"sound '" + std::string(path) + "' cannot be loaded: " + file.error().message};
    return check_sound_bytes(*file, path);
}

}  // namespace cairn::engine
