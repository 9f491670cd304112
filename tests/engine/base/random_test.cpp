// The generator against the published output of its reference implementation, and its uses against counts.
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include <cairn/engine/random.h>

using cairn::engine::Random;

TEST_CASE("Random gives the sequence that the reference implementation of PCG32 publishes") {
    // pcg32-demo.c with its fixed seed, pcg32_srandom(42, 54), round 1.
    Random random(42, 54);
    for (const std::uint32_t expected :
         {0xa15c02b7u, 0x7b47f409u, 0xba1d3330u, 0x83d2f293u, 0xbfa4784bu, 0xcbed606eu})
        CHECK(random.next_u32() == expected);
}

TEST_CASE("Random continues exactly from a saved state") {
    Random random(7);
    (void)random.next_u64();
    const auto saved = random.state();
    const std::uint64_t next = random.next_u64();
    Random other(1234, 9);
    other.set_state(saved);
    CHECK(other.next_u64() == next);
}

TEST_CASE("Random streams with one seed differ") {
    CHECK(Random(1, 0).next_u64() != Random(1, 1).next_u64());
    CHECK(Random(1, 0).next_u64() != Random(2, 0).next_u64());
}

TEST_CASE("Random::uniform stays below 1 and fills the interval evenly") {
    Random random(3);
    constexpr int kDraws = 100'000;
    std::array<int, 10> counts = {};
    for (int i = 0; i < kDraws; ++i) {
        const double value = random.uniform();
        REQUIRE(value >= 0);
        REQUIRE(value < 1);
        ++counts[static_cast<std::size_t>(value * 10)];
    }
    // Standard deviation of a count: sqrt(n p (1 - p)) = 95; the seed is fixed, so this cannot fail by
    // chance.
    for (const int count : counts) CHECK(std::abs(count - kDraws / 10) < 5 * 95);
}

TEST_CASE("Random::uniform between bounds keeps to them") {
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const double value = random.uniform(-2, 3);
        REQUIRE(value >= -2);
        REQUIRE(value < 3);
    }
    CHECK(random.uniform(5, 5) == 5);
}

TEST_CASE("Random::range includes both ends and prefers none") {
    Random random(5);
    constexpr int kDraws = 60'000;
    std::array<int, 6> counts = {};
    for (int i = 0; i < kDraws; ++i) {
        const std::int64_t die = random.range(1, 6);
        REQUIRE(die >= 1);
        REQUIRE(die <= 6);
        ++counts[static_cast<std::size_t>(die - 1)];
    }
    for (const int count : counts) CHECK(std::abs(count - kDraws / 6) < 5 * 91);
}

TEST_CASE("Random::range has no modulo bias where it would show most") {
    // Over three quarters of all 64-bit values, a plain remainder would make the lowest third twice as
    // likely.
    constexpr std::int64_t kLow = std::numeric_limits<std::int64_t>::min();
    constexpr std::int64_t kHigh = (1ll << 62) - 1;
    constexpr std::int64_t kThird = kLow + (1ll << 62);
    Random random(6);
    constexpr int kDraws = 30'000;
    int in_lowest_third = 0;
    for (int i = 0; i < kDraws; ++i)
        if (random.range(kLow, kHigh) < kThird) ++in_lowest_third;
    CHECK(std::abs(in_lowest_third - kDraws / 3) < 5 * 82);
}

TEST_CASE("Random::range covers a single value and all values") {
    Random random(8);
    CHECK(random.range(-3, -3) == -3);
    bool negative = false;
    bool positive = false;
    for (int i = 0; i < 64; ++i) {
        const std::int64_t value =
            random.range(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max());
        negative = negative || value < 0;
        positive = positive || value > 0;
    }
    CHECK(negative);
    CHECK(positive);
}
