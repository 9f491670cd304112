// Random numbers that are the same on every machine, so that a failing case can be run again.
// The distributions of the standard library differ between implementations. Source: SplitMix64, Steele 2014.
// Draw once per call expression or within braces: compilers evaluate the arguments of a call in any order.
#pragma once

#include <cstdint>

#include <cairn/physics/math.h>

namespace cairn::physics::test {

class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// From 0 up to, and without, count.
    int below(int count) { return static_cast<int>(bits() % static_cast<std::uint64_t>(count)); }
    bool chance(double probability) { return real(0, 1) < probability; }
    double real(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
    }
    float real_f(double low, double high) { return static_cast<float>(real(low, high)); }
    Vec2 vector(double low, double high) {
        const float x = real_f(low, high);
        return {x, real_f(low, high)};
    }

  private:
    std::uint64_t state_;
};

}  // namespace cairn::physics::test
