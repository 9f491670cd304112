// PCG-XSH-RR 64/32. Invariant: increment is odd, which gives the underlying generator its full period of
// 2^64. Source: M. O'Neill 2014 (see the header); seeding as in the author's reference implementation,
// pcg32_srandom.
#include <cassert>

#include <cairn/engine/random.h>

namespace cairn::engine {

Random::Random(std::uint64_t seed, std::uint64_t stream) {
    state_.state = 0;
    state_.increment = (stream << 1) | 1;
    next_u32();
    state_.state += seed;
    next_u32();
}

std::uint32_t Random::next_u32() {
    const std::uint64_t old = state_.state;
    state_.state = old * 6364136223846793005ull + state_.increment;
    const auto xorshifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
    const auto rotation = static_cast<std::uint32_t>(old >> 59);
    return (xorshifted >> rotation) | (xorshifted << ((32 - rotation) & 31));
}

std::uint64_t Random::next_u64() {
    const std::uint64_t high = next_u32();
    return (high << 32) | next_u32();
}

double Random::uniform() {
    return static_cast<double>(next_u64() >> 11) * 0x1p-53;
}

double Random::uniform(double low, double high) {
    const double value = low + (high - low) * uniform();
    // Rounding can land on the upper end, which is not part of the interval.
    return value < high ? value : low;
}

std::int64_t Random::range(std::int64_t low, std::int64_t high) {
    assert(low <= high);
    const std::uint64_t span = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
    if (span == 0) return static_cast<std::int64_t>(next_u64());  // all 2^64 values
    // Values below 2^64 mod span would make the low results likelier than the others: draw again.
    const std::uint64_t unfair = (0 - span) % span;
    std::uint64_t value = next_u64();
    while (value < unfair) value = next_u64();
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + value % span);
}

void Random::set_state(const RandomState& state) {
    state_ = state;
    state_.increment |= 1;
}

}  // namespace cairn::engine
