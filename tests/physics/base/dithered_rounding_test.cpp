#include "base/dithered_rounding.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace cairn::physics {
namespace {

TEST_CASE("what a float can hold is rounded to itself, whatever the threshold") {
    for (const float x : {0.0f, 1.0f, -1.0f, 0.1f, -3e38f, 1e-45f, 16777216.0f}) {
        for (const double threshold : {1e-9, 0.5, 1 - 1e-9}) {
            CHECK(rounded_at(static_cast<double>(x), threshold) == x);
        }
    }
}

TEST_CASE("other numbers become one of their two neighbours, and mirrored ones the mirrored") {
    const float one_up = std::nextafter(1.0f, 2.0f);
    const float one_down = std::nextafter(1.0f, 0.0f);
    const double above = 1 + 0.25 * (static_cast<double>(one_up) - 1);
    const double below = 1 - 0.25 * (1 - static_cast<double>(one_down));
    CHECK(rounded_at(above, 0.2) == one_up);
    CHECK(rounded_at(above, 0.3) == 1);
    CHECK(rounded_at(below, 0.7) == 1);
    CHECK(rounded_at(below, 0.8) == one_down);
    CHECK(rounded_at(-above, 0.2) == -one_up);
    CHECK(rounded_at(-below, 0.8) == -one_down);
}

TEST_CASE("what is beyond all floats is infinite, and what is no number stays none") {
    CHECK(rounded_at(1e300, 0.5) == std::numeric_limits<float>::infinity());
    CHECK(rounded_at(-1e300, 0.5) == -std::numeric_limits<float>::infinity());
    CHECK(std::isnan(rounded_at(std::numeric_limits<double>::quiet_NaN(), 0.5)));
}

TEST_CASE("thresholds of consecutive steps are spread evenly") {
    // Of any 1000 in a row, each tenth of the interval has 100; the golden ratio's discrepancy is below 3.
    for (const std::uint64_t first : {std::uint64_t{0}, std::uint64_t{123456789012}}) {
        int counts[10] = {};
        for (std::uint64_t i = 0; i < 1000; ++i) {
            const double threshold = rounding_threshold(first + i);
            REQUIRE(threshold > 0);
            REQUIRE(threshold < 1);
            ++counts[static_cast<int>(10 * threshold)];
        }
        for (const int count : counts) CHECK(std::abs(count - 100) <= 3);
    }
}

TEST_CASE("a small number added many times adds up") {
    // Each nearest rounding here errs by a third of a unit in the last place, always to the same side.
    const double small = 1.0 / 6;
    const double unit = std::ldexp(1.0, -21);  // in the last place, from 4 to 8
    float sum = 4;
    for (std::uint64_t step = 0; step < 23; ++step)
        sum = rounded_at(static_cast<double>(sum) + small, rounding_threshold(step));
    CHECK(std::fabs(static_cast<double>(sum) - (4 + 23 * small)) < 2 * unit);
    float nearest = 4;
    for (int step = 0; step < 23; ++step) nearest += static_cast<float>(small);
    CHECK(std::fabs(static_cast<double>(nearest) - (4 + 23 * small)) > 5 * unit);
}

}  // namespace
}  // namespace cairn::physics
