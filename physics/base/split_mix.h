// Random numbers that depend on their seed alone: the same on every compiler and machine.
// The distributions of the standard library differ between implementations. Source: SplitMix64, Steele 2014.
// Draw once per statement or within braces: compilers evaluate the arguments of a call in any order.
#pragma once

#include <cstdint>

namespace cairn::physics {

class SplitMix {
  public:
    explicit SplitMix(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// From low up to, and without, high.
    double real(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
    }

  private:
    std::uint64_t state_;
};

}  // namespace cairn::physics
