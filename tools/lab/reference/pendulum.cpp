// Lagrange's equations. With c_ik what link k does to the centre of link i (its whole length before i, half
// of it at i), the kinetic energy is 1/2 sum_jk M_jk w_j w_k with
//   M_jk = sum_i m c_ij c_ik cos(t_j - t_k) + I [j = k],
// and the equations of motion are
//   sum_k M_jk w'_k = - sum_k (sum_i m c_ij c_ik) sin(t_j - t_k) w_k^2 - g (sum_i m c_ij) sin t_j.
#include "reference/pendulum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace cairn::lab::reference {

double elliptic_k(double k) {
    double a = 1, b = std::sqrt(1 - k * k);
    while (std::fabs(a - b) > 1e-15) {
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    return std::numbers::pi / (2 * a);
}

double pendulum_period_s(double length_m, double gravity_m_s2, double amplitude_rad) {
    return 4 * std::sqrt(length_m / gravity_m_s2) * elliptic_k(std::sin(amplitude_rad / 2));
}

State HungBars::derivative(const State& state) const {
    const auto n = static_cast<std::size_t>(count);
    const auto reach = [&](std::size_t i, std::size_t k) {
        return k < i ? length_m : k == i ? length_m / 2 : 0.0;
    };
    std::vector<State> matrix(n, State(n));
    State right(n);
    for (std::size_t j = 0; j < n; ++j) {
        double weight_arm = 0;
        for (std::size_t i = j; i < n; ++i) weight_arm += mass_kg * reach(i, j);
        right[j] = -gravity_m_s2 * weight_arm * std::sin(state[j]);
        for (std::size_t k = 0; k < n; ++k) {
            double coupling = 0;
            for (std::size_t i = std::max(j, k); i < n; ++i) coupling += mass_kg * reach(i, j) * reach(i, k);
            matrix[j][k] = coupling * std::cos(state[j] - state[k]) + (j == k ? inertia_kg_m2 : 0);
            right[j] -= coupling * std::sin(state[j] - state[k]) * state[n + k] * state[n + k];
        }
    }
    const State acceleration = solve_linear(std::move(matrix), std::move(right));
    State derivative(2 * n);
    for (std::size_t j = 0; j < n; ++j) {
        derivative[j] = state[n + j];
        derivative[n + j] = acceleration[j];
    }
    return derivative;
}

std::vector<physics::Position> HungBars::centers(const State& state) const {
    std::vector<physics::Position> found;
    physics::Position hinge{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const double x = length_m * std::sin(state[i]), y = -length_m * std::cos(state[i]);
        found.push_back({hinge.x + x / 2, hinge.y + y / 2});
        hinge = {hinge.x + x, hinge.y + y};
    }
    return found;
}

double HungBars::energy_j(const State& state) const {
    const auto n = static_cast<std::size_t>(count);
    double sum = 0, hinge_vx = 0, hinge_vy = 0;
    const std::vector<physics::Position> places = centers(state);
    for (std::size_t i = 0; i < n; ++i) {
        const double w = state[n + i];
        const double vx = length_m * std::cos(state[i]) * w, vy = length_m * std::sin(state[i]) * w;
        const double cx = hinge_vx + vx / 2, cy = hinge_vy + vy / 2;
        sum += 0.5 * mass_kg * (cx * cx + cy * cy) + 0.5 * inertia_kg_m2 * w * w +
               mass_kg * gravity_m_s2 * places[i].y;
        hinge_vx += vx;
        hinge_vy += vy;
    }
    return sum;
}

}  // namespace cairn::lab::reference
