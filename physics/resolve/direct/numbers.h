// Shorthands of the direct solver's files: it works in doubles on structures that are stored in floats, and
// on blocks of a few sizes.
#pragma once

#include <cstddef>
#include <type_traits>

namespace cairn::physics {

inline double d(float x) {
    return static_cast<double>(x);
}

inline std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Calls work(count), with the count as a constant where it is that of most blocks: pins, welds and bodies.
template <class Work>
void with_count(int count, const Work& work) {
    switch (count) {
        case 1:
            return work(std::integral_constant<int, 1>{});
        case 2:
            return work(std::integral_constant<int, 2>{});
        case 3:
            return work(std::integral_constant<int, 3>{});
        default:
            return work(count);
    }
}

}  // namespace cairn::physics
