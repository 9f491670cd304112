// A checksum of bytes, eight words at a time in chains of their own, so that it costs little more than
// reading them. Every single changed word changes it; it is no protection against those who mean harm.
// Source: the multiply-and-shift round of Murmur (Appleby 2008), as base/state_hash.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace cairn::physics {

inline std::uint64_t checksum(std::span<const std::byte> bytes) {
    constexpr std::size_t kChains = 8;
    constexpr std::uint64_t kFactor = 0x87c37b91114253d5u;
    using Words = std::array<std::uint64_t, kChains>;
    Words chains;
    for (std::size_t i = 0; i < kChains; ++i) chains[i] = 0x9e3779b97f4a7c15u * (i + 1);
    const auto round = [](std::uint64_t state, std::uint64_t word) {
        state = (state ^ word) * kFactor;
        return state ^ state >> 32;
    };
    std::size_t at = 0;
    for (; at + sizeof(Words) <= bytes.size(); at += sizeof(Words)) {
        Words words;
        std::memcpy(words.data(), bytes.data() + at, sizeof words);
        for (std::size_t i = 0; i < kChains; ++i) chains[i] = round(chains[i], words[i]);
    }
    Words rest{};
    if (at < bytes.size()) std::memcpy(rest.data(), bytes.data() + at, bytes.size() - at);
    std::uint64_t sum = bytes.size();
    for (std::size_t i = 0; i < kChains; ++i) sum = round(sum, round(chains[i], rest[i]));
    return sum;
}

}  // namespace cairn::physics
