// Asks for memory that will be read soon. It changes no result.
#pragma once

#include <cstddef>

namespace cairn::physics {

inline constexpr std::size_t kCacheLine_B = 64;

/// `size` bytes from there on. Where hardware would not foresee it: blocks of a colour stand apart in their
/// pool.
inline void prefetch(const void* from, std::size_t size) {
    const char* bytes = static_cast<const char*>(from);
    for (std::size_t at = 0; at < size; at += kCacheLine_B) __builtin_prefetch(bytes + at);
}

/// One line, which is also taken from the cache of another core, for it will be written.
inline void prefetch_to_write(const void* at) {
    __builtin_prefetch(at, 1);
}

/// How many blocks ahead: far enough for memory to answer, near enough for the cache to hold all of them.
inline constexpr std::size_t kBlocksAhead = 6;

}  // namespace cairn::physics
