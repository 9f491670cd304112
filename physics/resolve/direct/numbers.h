// Shorthands of the direct solver's files: it works in doubles on structures that are stored in floats.
#pragma once

#include <cstddef>

namespace cairn::physics {

inline double d(float x) {
    return static_cast<double>(x);
}

inline std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

}  // namespace cairn::physics
