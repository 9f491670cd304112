// For oracles in double.
#pragma once

#include <numbers>

namespace cairn::physics::test {

inline constexpr double kPiD = std::numbers::pi;

constexpr double d(float x) {
    return static_cast<double>(x);
}

}  // namespace cairn::physics::test
