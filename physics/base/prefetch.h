// Asks for memory that will be read soon. It changes no result.
#pragma once

#include <algorithm>
#include <cstddef>

namespace cairn::physics {

inline constexpr std::size_t kCacheLine_B = 64;

/// `size` bytes from there on, more than none. Where hardware would not foresee it: blocks of a colour stand
/// apart in their pool.
template <class T>
inline void prefetch(const T* from, std::size_t size) {
    const char* bytes = reinterpret_cast<const char*>(from);
    for (std::size_t at = 0; at < size; at += kCacheLine_B) __builtin_prefetch(bytes + at);
    // What does not start where a line does may end in one more.
    if ((size - 1) % kCacheLine_B >= alignof(T)) __builtin_prefetch(bytes + size - 1);
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

/// The same in three stages: half as far ahead, ask_next(item) asks for what the first told of, and a quarter
/// as far, ask_last(item) for what the second did.
template <class Items, class Ask, class AskNext, class AskLast, class Visit>
void visit_asking_ahead(const Items& items, std::size_t ahead, const Ask& ask, const AskNext& ask_next,
                        const AskLast& ask_last, const Visit& visit) {
    const std::size_t next = ahead / 2;
    const std::size_t last = ahead / 4;
    const std::size_t count = items.size();
    for (std::size_t i = 0; i < std::min(ahead, count); ++i) ask(items[i]);
    for (std::size_t i = 0; i < std::min(next, count); ++i) ask_next(items[i]);
    for (std::size_t i = 0; i < std::min(last, count); ++i) ask_last(items[i]);
    for (std::size_t i = 0; i < count; ++i) {
        if (i + ahead < count) ask(items[i + ahead]);
        if (i + next < count) ask_next(items[i + next]);
        if (i + last < count) ask_last(items[i + last]);
        visit(items[i]);
    }
}

/// In two stages.
template <class Items, class Ask, class AskNext, class Visit>
void visit_asking_ahead(const Items& items, std::size_t ahead, const Ask& ask, const AskNext& ask_next,
                        const Visit& visit) {
    visit_asking_ahead(
        items, ahead, ask, ask_next, [](const auto&) {}, visit);
}

/// How many blocks ahead: far enough for memory to answer, near enough for the cache to hold all of them.
inline constexpr std::size_t kBlocksAhead = 6;

}  // namespace cairn::physics
