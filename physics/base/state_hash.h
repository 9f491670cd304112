// A 64-bit hash of numbers by their bits. Source: the multiply-and-mix round of Murmur (Appleby 2008), one
// per word.
#pragma once

#include <bit>
#include <cstdint>

#include <cairn/physics/math.h>

namespace cairn::physics {

class StateHash {
  public:
    void add(std::uint64_t word) {
        word *= 0x87c37b91114253d5u;
        word ^= word >> 32;
        state_ = (state_ ^ word) * 0x4cf5ad432745937fu;
        state_ ^= state_ >> 29;
    }
    void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
    void add(float a, float b) {
        add(std::uint64_t{std::bit_cast<std::uint32_t>(a)} << 32 | std::bit_cast<std::uint32_t>(b));
    }
    void add(Vec2 a) { add(a.x, a.y); }
    void add(Rotation q) { add(q.c, q.s); }
    void add(Position p) {
        add(p.x);
        add(p.y);
    }
    [[nodiscard]] std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 0x9e3779b97f4a7c15u;
};

}  // namespace cairn::physics
