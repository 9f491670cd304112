// Sounds made in memory. Invariant: the files follow the formats' specifications, byte by byte.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

/// Of more than 8 bytes the rest is 0.
inline void append_little_endian(std::string& out, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i, value >>= 8) out += static_cast<char>(value & 0xff);
}

/// A WAV file with two bytes of its format replaced: at 20 the encoding, at 22 the channels, at 24 and 26 the
/// rate, at 32 the bytes of a frame, at 34 the bits of a sample.
inline std::string with_format(std::string wav, std::size_t at, std::uint64_t value) {
    std::string bytes;
    append_little_endian(bytes, value, 2);
    return wav.replace(at, 2, bytes);
}

/// A 440 Hz tone as 16-bit mono WAV at 8,000 Hz.
inline std::string tone_wav(double duration_s) {
    constexpr int kRate = 8000;
    const int frames = static_cast<int>(duration_s * kRate);
    std::string out = "RIFF";
    append_little_endian(out, 36 + 2 * static_cast<std::uint64_t>(frames), 4);
    out += "WAVEfmt ";
    append_little_endian(out, 16, 4);
    append_little_endian(out, 1, 2);  // PCM
    append_little_endian(out, 1, 2);  // mono
    append_little_endian(out, kRate, 4);
    append_little_endian(out, 2 * kRate, 4);
    append_little_endian(out, 2, 2);
    append_little_endian(out, 16, 2);
    out += "data";
    append_little_endian(out, 2 * static_cast<std::uint64_t>(frames), 4);
    for (int i = 0; i < frames; ++i) {
        const double value = 8000 * std::sin(2 * std::numbers::pi * 440 * i / kRate);
        append_little_endian(out, static_cast<std::uint16_t>(static_cast<std::int16_t>(value)), 2);
    }
    return out;
}

/// Of an Ogg page: division of its bits by the polynomial, one by one.
inline std::uint32_t remainder_of(const std::string& page) {
    std::uint32_t crc = 0;
    for (const char c : page) {
        for (int bit = 7; bit >= 0; --bit) {
            const bool carry = ((crc >> 31) ^ (static_cast<unsigned char>(c) >> bit & 1u)) != 0;
            crc = crc << 1 ^ (carry ? 0x04c11db7u : 0);
        }
    }
    return crc;
}

inline std::string ogg_page(int flags, std::uint64_t granule, const std::string& body) {
    std::string text = "OggS";
    append_little_endian(text, 0, 1);
    append_little_endian(text, static_cast<std::uint64_t>(flags), 1);
    append_little_endian(text, granule, 8);
    append_little_endian(text, 0, 12);
    append_little_endian(text, 1, 1);
    append_little_endian(text, body.size(), 1);
    text += body;
    std::string checksum;
    append_little_endian(checksum, remainder_of(text), 4);
    return text.replace(22, 4, checksum);
}

/// One second, whole as a container; what its packets hold is nothing that can be decoded.
inline std::string vorbis() {
    std::string packet = "\x01vorbis";
    append_little_endian(packet, 0, 5);
    append_little_endian(packet, 48000, 4);
    packet += std::string(14, '\0');
    return ogg_page(2, 0, packet) + ogg_page(0, 24000, "some") + ogg_page(4, 48000, "more of it");
}
