#include "base/split_mix.h"

#include <catch2/catch.hpp>

namespace cairn::physics {
namespace {

TEST_CASE("Random numbers are those of SplitMix64", "[split_mix]") {
    // The reference values that its author's code prints for this seed.
    SplitMix random(1234567);
    CHECK(random.bits() == 6457827717110365317u);
    CHECK(random.bits() == 3203168211198807973u);
    CHECK(random.bits() == 9817491932198370423u);
}

TEST_CASE("Random reals fill their range evenly", "[split_mix]") {
    SplitMix random(1);
    double sum = 0;
    for (int i = 0; i < 10000; ++i) {
        const double x = random.real(-1, 3);
        REQUIRE(x >= -1);
        REQUIRE(x < 3);
        sum += x;
    }
    // The standard deviation of the mean is 4 / sqrt(12 * 10000).
    CHECK(sum / 10000 == Approx(1).margin(0.05));
}

}  // namespace
}  // namespace cairn::physics
