// The headers of WAV and Ogg Vorbis files. Invariant: a duration that is returned is finite and not negative.
// Source: Microsoft and IBM, "Multimedia Programming Interface and Data Specifications 1.0" (RIFF WAVE); RFC
// 3533 (Ogg); Xiph.Org, "Vorbis I specification", section 4.2.2 (identification header).
#include "assets/sound_header.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

namespace cairn::engine {
namespace {

using Bytes = std::span<const std::byte>;

std::uint64_t little_endian(Bytes file, std::size_t at, std::size_t bytes) {
    std::uint64_t value = 0;
    for (std::size_t i = bytes; i > 0; --i)
        value = value << 8 | std::to_integer<std::uint64_t>(file[at + i - 1]);
    return value;
}

bool has_text(Bytes file, std::size_t at, std::string_view text) {
    return at + text.size() <= file.size() && std::memcmp(file.data() + at, text.data(), text.size()) == 0;
}

Error sound_error(std::string_view name, std::string_view reason) {
    return Error{"sound '" + std::string(name) + "': " + std::string(reason)};
}

/// What of a format SDL refuses, or SDL_mixer divides by when the file is music; empty: nothing. Every chunk
/// of this kind is looked at, because one library takes the first and the other the last.
std::string wav_format_fault(Bytes file) {
    constexpr std::uint64_t kMostChannels = 8;
    // Where SDL's resampler counts in 32 bits: the highest one by its 512 samples for each zero crossing.
    constexpr std::uint64_t kHighest_hz = 4194303;
    for (std::size_t chunk = 12; chunk + 8 <= file.size();) {
        const std::size_t body = chunk + 8;
        const std::uint64_t present =
            std::min<std::uint64_t>(little_endian(file, chunk + 4, 4), file.size() - body);
        if (has_text(file, chunk, "fmt ") && present >= 16) {
            const std::uint64_t channels = little_endian(file, body + 2, 2);
            const std::uint64_t rate_hz = little_endian(file, body + 4, 4);
            if (channels < 1 || channels > kMostChannels)
                return "has " + std::to_string(channels) + " channels, but must have from 1 to " +
                       std::to_string(kMostChannels);
            if (rate_hz < 1 || rate_hz > kHighest_hz)
                return "has a sample rate of " + std::to_string(rate_hz) +
                       " Hz, but must have one from 1 to " + std::to_string(kHighest_hz) + " Hz";
        }
        chunk = body + present + (present & 1);  // chunks start at even places
    }
    return {};
}

std::optional<double> wav_duration_s(Bytes file) {
    std::uint64_t bytes_per_second = 0;
    std::size_t chunk = 12;
    while (chunk + 8 <= file.size()) {
        const std::uint64_t stated = little_endian(file, chunk + 4, 4);
        const std::size_t body = chunk + 8;
        const std::uint64_t present = std::min<std::uint64_t>(stated, file.size() - body);
        if (has_text(file, chunk, "fmt ") && present >= 16)
            bytes_per_second = little_endian(file, body + 8, 4);
        if (has_text(file, chunk, "data") && bytes_per_second > 0)
            return static_cast<double>(present) / static_cast<double>(bytes_per_second);
        chunk = body + present + (present & 1);  // chunks start at even places
    }
    return std::nullopt;
}

std::optional<double> ogg_duration_s(Bytes file) {
    // A page: 27 bytes, as many segment lengths as byte 26 says, and the segments.
    constexpr std::size_t kPageHeader = 27, kGranule = 6;
    if (file.size() < kPageHeader + 1) return std::nullopt;
    const std::size_t packet = kPageHeader + std::to_integer<std::size_t>(file[26]);
    constexpr std::size_t kRate = 12;
    if (!has_text(file, packet, "\x01vorbis") || packet + kRate + 4 > file.size()) return std::nullopt;
    const std::uint64_t rate = little_endian(file, packet + kRate, 4);
    if (rate == 0) return std::nullopt;

    // The last page says how many samples came before its end.
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    const std::size_t last_page = text.rfind("OggS");
    if (last_page + kPageHeader > file.size()) return std::nullopt;
    const std::uint64_t samples = little_endian(file, last_page + kGranule, 8);
    if (samples >> 63) return std::nullopt;  // -1: no packet ends on the page
    return static_cast<double>(samples) / static_cast<double>(rate);
}

}  // namespace

Result<double> read_sound_duration_s(Bytes file, std::string_view name) {
    std::optional<double> duration_s;
    if (has_text(file, 0, "RIFF") && has_text(file, 8, "WAVE")) {
        if (const std::string fault = wav_format_fault(file); !fault.empty()) return sound_error(name, fault);
        duration_s = wav_duration_s(file);
    } else if (has_text(file, 0, "OggS")) {
        duration_s = ogg_duration_s(file);
    } else {
        return sound_error(name, "is neither an Ogg Vorbis nor a WAV file");
    }
    if (!duration_s)
        return sound_error(name, "is damaged: its header is incomplete, or it is not Vorbis or PCM");
    return *duration_s;
}

}  // namespace cairn::engine
