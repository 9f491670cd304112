// Chains and beams at rest, by the equations that they must satisfy.
#include "reference/statics.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace cairn::lab::reference {

TEST_CASE("a hanging chain spans what it should, and its tangents grow evenly") {
    const HangingChain chain = hanging_chain(20, 0.5, 0.5, 7);
    double x = 0, y = 0;
    for (const double angle : chain.angle_rad) {
        x += 0.5 * std::cos(angle);
        y += 0.5 * std::sin(angle);
    }
    CHECK(x == Approx(7).epsilon(1e-12));
    CHECK(std::fabs(y) < 1e-12);
    const double step = std::tan(chain.angle_rad[1]) - std::tan(chain.angle_rad[0]);
    for (std::size_t i = 1; i + 1 < chain.angle_rad.size(); ++i) {
        CHECK(std::tan(chain.angle_rad[i + 1]) - std::tan(chain.angle_rad[i]) == Approx(step));
    }
    CHECK(chain.end_tension_n == Approx(std::hypot(0.5 / step, 5)));
}

TEST_CASE("many links hang as the catenary does") {
    // a cosh(x / a): half span x = a asinh(s / a) for half length s.
    const double a = 3, half = 5;
    const HangingChain chain = hanging_chain(1000, 2 * half / 1000, 0.01, 2 * a * std::asinh(half / a));
    CHECK(chain.sag_m == Approx(std::hypot(a, half) - a).epsilon(1e-5));
}

TEST_CASE("a stiff cantilever sags by the formula of small angles, a soft one by less") {
    const double n = 10, l = 0.5, w = 1;
    const auto small = [&](double k) { return -w * l * l * l * n * n * (n + 1) * (n + 1) / (8 * k); };
    CHECK(cantilever_tip_m(10, l, w, 1e6) == Approx(small(1e6)).epsilon(1e-6));
    CHECK(cantilever_tip_m(10, l, w, 200) > small(200));
    CHECK(cantilever_tip_m(1, 2, 3, 1e6) == Approx(-3.0 * 2 * 1 / 1e6 * 2).epsilon(1e-6));
}

}  // namespace cairn::lab::reference
