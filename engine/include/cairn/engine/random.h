// Repeatable random numbers: the same seed gives the same sequence on every machine and compiler.
// Invariant: all state is in RandomState, so a saved state continues the sequence exactly.
// Source: M. O'Neill, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for Random
// Number Generation", 2014, generator PCG-XSH-RR 64/32.
#pragma once

#include <cstdint>

namespace cairn::engine {

struct RandomState {
    std::uint64_t state = 0;
    std::uint64_t increment = 1;  ///< selects the stream; always odd

    friend bool operator==(const RandomState&, const RandomState&) = default;
};

class Random {
  public:
    /// Generators with the same seed and different streams are independent.
    explicit Random(std::uint64_t seed = 0, std::uint64_t stream = 0);

    std::uint32_t next_u32();
    std::uint64_t next_u64();

    /// In [0, 1), a multiple of 2^-53.
    double uniform();
    /// In [low, high); low when both are equal.
    double uniform(double low, double high);
    /// In [low, high], both included and all equally likely; asserts low <= high.
    std::int64_t range(std::int64_t low, std::int64_t high);

    RandomState state() const { return state_; }
    void set_state(const RandomState& state);

  private:
    RandomState state_;
};

}  // namespace cairn::engine
