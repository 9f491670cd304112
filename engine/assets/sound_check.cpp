// The containers of sounds, from the first byte to the last.
// Source: Microsoft and IBM, "Multimedia Programming Interface and Data Specifications 1.0" (RIFF WAVE); RFC
// 3533 (Ogg: pages, their checksum and flags).
#include "assets/sound_check.h"

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

std::uint32_t half_word_at(Bytes file, std::size_t at) {
    return std::to_integer<std::uint32_t>(file[at]) | std::to_integer<std::uint32_t>(file[at + 1]) << 8;
}

/// Of a WAV file: what SDL and its mixer play.
Reason format_fault(Bytes format) {
    constexpr std::uint32_t kMostChannels = 8, kMostRate_hz = 0x7fffffff;
    const std::uint32_t channels = half_word_at(format, 2);
    const std::uint32_t rate_hz = word_at(format, 4);
    const auto states = [](std::uint32_t value, const std::string& what, const std::string& rule) {
        return "has a header that states " + std::to_string(value) + what + "; must be " + rule;
    };
    if (channels < 1 || channels > kMostChannels)
        return states(channels, " channels", "1 to " + std::to_string(kMostChannels));
    if (rate_hz < 1 || rate_hz > kMostRate_hz)
        return states(rate_hz, " samples a second", "1 to " + std::to_string(kMostRate_hz));
    return {};
}

Reason wav_fault(Bytes file) {
    constexpr std::size_t kRiffHeader = 12, kChunkHeader = 8, kFormat = 16;
    for (std::size_t chunk = kRiffHeader; chunk + kChunkHeader <= file.size();) {
        const std::size_t size = word_at(file, chunk + 4);
        const std::size_t present = file.size() - chunk - kChunkHeader;
        if (size > present) {
            const bool holds_samples = has_text(file, chunk, "data");
            return "is cut off: its " + std::string(holds_samples ? "samples" : "header") + " should take " +
                   std::to_string(size) + " bytes, and " + std::to_string(present) + " are there";
        }
        if (has_text(file, chunk, "fmt ") && size >= kFormat) {
            Reason fault = format_fault(file.subspan(chunk + kChunkHeader, size));
            if (!fault.empty()) return fault;
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
