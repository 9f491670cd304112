// Asks for memory that will be read soon. It changes no result.
#pragma once

#include <algorithm>
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

/// Calls visit(item) for all, and ask(item) some items ahead of it, to ask for what the visit will read.
template <class Items, class Ask, class Visit>
void visit_asking_ahead(const Items& items, std::size_t ahead, const Ask& ask, const Visit& visit) {
    const std::size_t count = items.size();
    for (std::size_t i = 0; i < std::min(ahead, count); ++i) ask(items[i]);
    for (std::size_t i = 0; i < count; ++i) {
        if (i + ahead < count) ask(items[i + ahead]);
        visit(items[i]);
    }
}

/// The same in two stages: half as far ahead, ask_next(item) asks for what the first told of.
template <class Items, class Ask, class AskNext, class Visit>
void visit_asking_ahead(const Items& items, std::size_t ahead, const Ask& ask, const AskNext& ask_next,
                        const Visit& visit) {
    const std::size_t next = ahead / 2;
    const std::size_t count = items.size();
    for (std::size_t i = 0; i < std::min(ahead, count); ++i) ask(items[i]);
    for (std::size_t i = 0; i < std::min(next, count); ++i) ask_next(items[i]);
    for (std::size_t i = 0; i < count; ++i) {
        if (i + ahead < count) ask(items[i + ahead]);
        if (i + next < count) ask_next(items[i + next]);
        visit(items[i]);
    }
}

/// How many blocks ahead: far enough for memory to answer, near enough for the cache to hold all of them.
inline constexpr std::size_t kBlocksAhead = 6;

}  // namespace cairn::physics
