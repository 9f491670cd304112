// Numbers of eight things side by side, for SIMD. Kernels take a whole array at once where registers hold
// eight floats, and in parts where they hold fewer.
#pragma once

#include <array>
#include <cstdint>

namespace cairn::physics {

/// Wider registers gain nothing: the limit is memory; narrower ones take two rounds or more.
inline constexpr int kLanes = 8;

template <class T>
using Lanes = std::array<T, kLanes>;

/// One bit per lane.
using LaneBits = std::uint8_t;

constexpr void set_lane_bit(LaneBits& bits, int lane, bool on) {
    bits = static_cast<LaneBits>((bits & ~(1 << lane)) | (on ? 1 : 0) << lane);
}

constexpr void copy_lane_bit(LaneBits& to, int to_lane, LaneBits from, int from_lane) {
    set_lane_bit(to, to_lane, (from >> from_lane & 1) != 0);
}

}  // namespace cairn::physics
