// Pendulums against values from tables, against each other, and by their energy.
#include "reference/pendulum.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace cairn::lab::reference {

TEST_CASE("the elliptic integral has the values of the tables") {
    CHECK(elliptic_k(0) == Approx(std::numbers::pi / 2).epsilon(1e-14));
    // Abramowitz and Stegun, table 17.1: m = k^2 = 0.5.
    CHECK(elliptic_k(std::sqrt(0.5)) == Approx(1.854074677301372).epsilon(1e-14));
}

TEST_CASE("a small swing takes 2 pi sqrt(L / g), a large one longer") {
    CHECK(pendulum_period_s(2.5, 10, 1e-5) == Approx(std::numbers::pi).epsilon(1e-9));
    CHECK(pendulum_period_s(1, 10, std::numbers::pi / 2) / pendulum_period_s(1, 10, 1e-5) ==
          Approx(1.18034).epsilon(1e-5));
}

TEST_CASE("one hung bar swings as a pendulum of its reduced length") {
    HungBars bar;
    bar.count = 1;
    const Derivative f = [&](double, const State& y) { return bar.derivative(y); };
    const double period = pendulum_period_s(2.0 / 3, bar.gravity_m_s2, 1.2);  // I / (m L/2) about the hinge
    const State half = integrate(f, {1.2, 0}, 0, period / 2);
    CHECK(half[0] == Approx(-1.2).epsilon(1e-9));
    CHECK(std::fabs(half[1]) < 1e-8);
}

TEST_CASE("hung bars keep their energy, and the first ones hang from the origin") {
    HungBars bars;
    bars.count = 3;
    const Derivative f = [&](double, const State& y) { return bars.derivative(y); };
    const State start{1.5, 0.4, -0.3, 0, 2, 1};
    const State end = integrate(f, start, 0, 2);
    CHECK(bars.energy_j(end) == Approx(bars.energy_j(start)).epsilon(1e-9));
    CHECK(std::hypot(bars.centers(end)[0].x, bars.centers(end)[0].y) == Approx(0.5));
    CHECK(std::fabs(end[0] - start[0]) > 0.1);  // it has moved
}

}  // namespace cairn::lab::reference
