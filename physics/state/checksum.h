// A checksum of bytes, made for speed: it is taken with every snapshot. Invariant: any single word that
// changes changes it, and so do words that change places; it is the same at every SIMD level. It finds damage
// and is no protection against those who mean harm.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace cairn::physics {

std::uint64_t checksum(std::span<const std::byte> bytes);

}  // namespace cairn::physics
