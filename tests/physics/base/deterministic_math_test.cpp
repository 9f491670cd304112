// The own elementary functions against the C library, whose errors (below 1e-15) are far under the 1e-12 that
// is promised.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include <cairn/physics/math.h>

#include "physics/support/precise.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using namespace test;
namespace own = deterministic;

constexpr double kPromised = 1e-12;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Largest relative error of f against the reference over random arguments.
template <class Function, class Reference, class Draw>
double worst_error(Function f, Reference reference, Draw draw, int count = 100'000) {
    Random random(1);
    double worst = 0;
    for (int i = 0; i < count; ++i) {
        const double x = draw(random);
        const double expected = reference(x);
        const double error = std::fabs(f(x) - expected) / std::fabs(expected);
        // A NaN must not slip through the comparison.
        if (!(error <= worst)) worst = error;
    }
    return worst;
}

double signed_power(Random& random, double low_exponent, double high_exponent) {
    const double magnitude = std::pow(10, random.real(low_exponent, high_exponent));
    return random.chance(0.5) ? magnitude : -magnitude;
}

}  // namespace

TEST_CASE("sine, cosine and tangent agree with the C library for small, usual and large angles") {
    const auto draw = [](Random& random) { return signed_power(random, -12, 6); };
    CHECK(worst_error(
              own::sin, [](double x) { return std::sin(x); }, draw) < kPromised);
    CHECK(worst_error(
              own::cos, [](double x) { return std::cos(x); }, draw) < kPromised);
    CHECK(worst_error(
              own::tan, [](double x) { return std::tan(x); }, draw) < kPromised);
}

TEST_CASE("sine keeps its relative accuracy beside the multiples of pi") {
    Random random(2);
    for (int i = 0; i < 20'000; ++i) {
        const double angle = random.below(300'000) * kPiD + signed_power(random, -9, -1);
        INFO("angle " << angle);
        REQUIRE(std::fabs(own::sin(angle) - std::sin(angle)) <= kPromised * std::fabs(std::sin(angle)));
    }
}

TEST_CASE("sine and cosine lie on the unit circle and keep their symmetries") {
    Random random(3);
    for (int i = 0; i < 20'000; ++i) {
        const double x = signed_power(random, -3, 18);
        const double s = own::sin(x);
        const double c = own::cos(x);
        REQUIRE(s * s + c * c == Approx(1).epsilon(kPromised));
        REQUIRE(own::sin(-x) == Approx(-s).epsilon(kPromised).margin(1e-300));
        REQUIRE(own::cos(-x) == Approx(c).epsilon(kPromised).margin(1e-300));
    }
}

TEST_CASE("sine and cosine have the right sign in each quadrant") {
    const double middles[] = {kPiD / 4, 3 * kPiD / 4, -3 * kPiD / 4, -kPiD / 4};
    const double h = std::sqrt(0.5);
    const double sines[] = {h, h, -h, -h};
    const double cosines[] = {h, -h, -h, h};
    for (int turns = -3; turns <= 3; ++turns) {
        for (int q = 0; q < 4; ++q) {
            const double angle = middles[q] + 2 * kPiD * turns;
            CHECK(own::sin(angle) == Approx(sines[q]).epsilon(kPromised));
            CHECK(own::cos(angle) == Approx(cosines[q]).epsilon(kPromised));
        }
    }
}

TEST_CASE("sine and cosine of no number and of infinity are no number") {
    for (const double x : {kNaN, kInfinity, -kInfinity}) {
        CHECK(std::isnan(own::sin(x)));
        CHECK(std::isnan(own::cos(x)));
        CHECK(std::isnan(own::tan(x)));
    }
    CHECK(own::sin(0) == 0);
    CHECK(own::cos(0) == 1);
}

TEST_CASE("atan2 agrees with the C library in all quadrants and for all ratios") {
    Random random(4);
    for (int i = 0; i < 100'000; ++i) {
        const double y = signed_power(random, -10, 10);
        const double x = signed_power(random, -10, 10);
        INFO("atan2(" << y << ", " << x << ")");
        REQUIRE(own::atan2(y, x) == Approx(std::atan2(y, x)).epsilon(kPromised));
    }
}

TEST_CASE("atan2 of axes, signed zeros and infinities is that of the C library") {
    const double values[] = {0.0, -0.0, 1.0, -1.0, kInfinity, -kInfinity};
    for (const double y : values) {
        for (const double x : values) {
            INFO("atan2(" << y << ", " << x << ")");
            const double expected = std::atan2(y, x);
            CHECK(own::atan2(y, x) == Approx(expected).epsilon(kPromised));
            CHECK(std::signbit(own::atan2(y, x)) == std::signbit(expected));
        }
    }
    CHECK(std::isnan(own::atan2(kNaN, 1)));
    CHECK(std::isnan(own::atan2(1, kNaN)));
}

TEST_CASE("arc sine and arc cosine agree with the C library, also beside their ends") {
    const auto inside = [](Random& random) {
        const double edge = std::pow(10, random.real(-15, 0));
        const double x = random.chance(0.5) ? 1 - edge : edge;
        return random.chance(0.5) ? x : -x;
    };
    CHECK(worst_error(
              own::asin, [](double x) { return std::asin(x); }, inside) < kPromised);
    CHECK(worst_error(
              own::acos, [](double x) { return std::acos(x); }, inside) < kPromised);
    CHECK(own::asin(1) == Approx(kPiD / 2).epsilon(1e-15));
    CHECK(own::acos(-1) == Approx(kPiD).epsilon(1e-15));
    CHECK(own::acos(1) == 0);
    CHECK(std::isnan(own::asin(1.0000001)));
    CHECK(std::isnan(own::acos(-1.0000001)));
    CHECK(std::isnan(own::acos(kNaN)));
}

TEST_CASE("the exponential agrees with the C library from underflow to overflow") {
    const auto draw = [](Random& random) {
        return random.chance(0.5) ? random.real(-708, 709) : signed_power(random, -15, 1);
    };
    CHECK(worst_error(
              own::exp, [](double x) { return std::exp(x); }, draw) < kPromised);
    CHECK(own::exp(0) == 1);
    CHECK(own::exp(710) == kInfinity);
    CHECK(own::exp(kInfinity) == kInfinity);
    CHECK(own::exp(-746) == 0);
    CHECK(own::exp(-kInfinity) == 0);
    CHECK(std::isnan(own::exp(kNaN)));
    // Below the smallest normal number only the spacing of the subnormal ones limits the result.
    CHECK(std::fabs(own::exp(-740) - std::exp(-740)) <= 5e-324);
}

TEST_CASE("the logarithm agrees with the C library, also beside 1 and for subnormal numbers") {
    const auto wide = [](Random& random) { return std::pow(10, random.real(-320, 308)); };
    const auto beside_one = [](Random& random) { return 1 + signed_power(random, -15, -0.5); };
    const auto reference = [](double x) { return std::log(x); };
    CHECK(worst_error(own::log, reference, wide) < kPromised);
    CHECK(worst_error(own::log, reference, beside_one) < kPromised);
    CHECK(own::log(1) == 0);
    CHECK(own::log(0) == -kInfinity);
    CHECK(own::log(kInfinity) == kInfinity);
    CHECK(std::isnan(own::log(-1)));
    CHECK(std::isnan(own::log(kNaN)));
}

TEST_CASE("powers agree with the C library") {
    Random random(5);
    for (int i = 0; i < 100'000; ++i) {
        const double base = std::pow(10, random.real(-5, 5));
        const double exponent = random.chance(0.3) ? random.below(121) - 60 : random.real(-60, 60);
        INFO("pow(" << base << ", " << exponent << ")");
        REQUIRE(own::pow(base, exponent) == Approx(std::pow(base, exponent)).epsilon(kPromised));
    }
}

TEST_CASE("powers with special arguments are those of the C library") {
    const double values[] = {0.0, -0.0, 1.0, -1.0, 0.5,       -0.5,       2.0,  -2.0,
                             3.0, -3.0, 2.5, 101,  kInfinity, -kInfinity, kNaN, -101};
    for (const double base : values) {
        for (const double exponent : values) {
            const double expected = std::pow(base, exponent);
            const double actual = own::pow(base, exponent);
            INFO("pow(" << base << ", " << exponent << ") = " << actual << ", expected " << expected);
            if (std::isnan(expected)) {
                CHECK(std::isnan(actual));
            } else {
                CHECK(actual == Approx(expected).epsilon(kPromised));
                CHECK(std::signbit(actual) == std::signbit(expected));
            }
        }
    }
}

TEST_CASE("whole powers of small numbers are exact") {
    CHECK(own::pow(3, 20) == 3486784401.0);
    CHECK(own::pow(-2, 31) == -2147483648.0);
    CHECK(own::pow(2, -10) == 0x1p-10);
    CHECK(own::pow(10, 15) == 1e15);
}

TEST_CASE("a rotation gives its angle back") {
    Random random(6);
    for (int i = 0; i < 10'000; ++i) {
        const double angle = random.real(-3.14159, 3.14159);
        const Rotation q = Rotation::from_angle(angle);
        // Cosine and sine rounded to float: at most half a unit in the last place each, 2^-24 < 1e-7.
        REQUIRE(static_cast<double>(q.angle_rad()) == Approx(angle).margin(2e-7).epsilon(1e-7));
    }
}

}  // namespace cairn::physics
