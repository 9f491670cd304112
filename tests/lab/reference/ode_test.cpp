// The reference integrator against closed forms.
#include "reference/ode.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace cairn::lab::reference {

TEST_CASE("an oscillator comes back to where it began, to a billionth of a thousandth") {
    const Derivative f = [](double, const State& y) { return State{y[1], -y[0]}; };
    const State end = integrate(f, {1, 0}, 0, 20 * std::numbers::pi);
    CHECK(std::fabs(end[0] - 1) < 1e-11);
    CHECK(std::fabs(end[1]) < 1e-11);
}

TEST_CASE("an equation that knows the time is integrated to the end, not beyond") {
    const Derivative f = [](double t, const State&) { return State{std::cos(t)}; };
    CHECK(integrate(f, {0}, 0, 1)[0] == Approx(std::sin(1.0)).epsilon(1e-13));
    CHECK(integrate(f, {5}, 2, 2)[0] == 5);
}

TEST_CASE("a Kepler orbit closes") {
    const Derivative f = [](double, const State& y) {
        const double r = std::hypot(y[0], y[1]);
        return State{y[2], y[3], -y[0] / (r * r * r), -y[1] / (r * r * r)};
    };
    const State end =
        integrate(f, {1.5, 0, 0, std::sqrt(1 / 3.0)}, 0, 2 * std::numbers::pi);  // a = 1, e = 1/2
    CHECK(std::fabs(end[0] - 1.5) < 1e-10);
    CHECK(std::fabs(end[1]) < 1e-10);
}

TEST_CASE("linear equations are solved, with a zero on the diagonal too") {
    const State x = solve_linear({{0, 2, 1}, {1, -1, 0}, {3, 0, -2}}, {7, -1, -3});
    CHECK(x[0] == Approx(1));
    CHECK(x[1] == Approx(2));
    CHECK(x[2] == Approx(3));
}

}  // namespace cairn::lab::reference
