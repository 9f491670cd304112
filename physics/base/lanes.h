// Numbers of eight things side by side, for SIMD. Kernels take a whole array at once where registers hold
// eight floats, and in parts where they hold fewer.
#pragma once

#include <array>

namespace cairn::physics {

/// Wider registers gain nothing: the limit is memory; narrower ones take two rounds or more.
inline constexpr int kLanes = 8;

template <class T>
using Lanes = std::array<T, kLanes>;

}  // namespace cairn::physics
