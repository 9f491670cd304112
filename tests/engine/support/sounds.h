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
