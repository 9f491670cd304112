#include "reference/ode.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace cairn::lab::reference {
namespace {

constexpr int kStages = 7;
constexpr std::array<double, kStages> kC{0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1};
constexpr std::array<std::array<double, kStages - 1>, kStages> kA{{
    {},
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
}};
// Of order 4, whose difference to the last row above tells the error.
constexpr std::array<double, kStages> kB4{
    5179.0 / 57600, 0, 7571.0 / 16695, 393.0 / 640, -92097.0 / 339200, 187.0 / 2100, 1.0 / 40};

}  // namespace

State integrate(const Derivative& f, State y, double from, double to, double tolerance) {
    const std::size_t n = y.size();
    std::array<State, kStages> k;
    double t = from;
    double h = (to - from) / 100;
    while (t < to) {
        h = std::min(h, to - t);
        State next = y;
        for (int stage = 0; stage < kStages; ++stage) {
            next = y;
            for (int j = 0; j < stage; ++j) {
                for (std::size_t i = 0; i < n; ++i) next[i] += h * kA[stage][j] * k[j][i];
            }
            k[stage] = f(t + kC[stage] * h, next);
        }
        // `next` is now the value of order 5: the last stage is taken there.
        double error = 0;
        for (std::size_t i = 0; i < n; ++i) {
            double fourth = y[i];
            for (int j = 0; j < kStages; ++j) fourth += h * kB4[j] * k[j][i];
            error = std::max(error, std::fabs(next[i] - fourth) / (tolerance * (1 + std::fabs(y[i]))));
        }
        if (error <= 1) {
            t = h < to - t ? t + h : to;
            y = std::move(next);
        }
        h *= std::clamp(0.9 * std::pow(std::max(error, 1e-10), -0.2), 0.2, 5.0);
    }
    return y;
}

State solve_linear(std::vector<State> a, State b) {
    const std::size_t n = b.size();
    for (std::size_t column = 0; column < n; ++column) {
        std::size_t pivot = column;
        for (std::size_t row = column + 1; row < n; ++row) {
            if (std::fabs(a[row][column]) > std::fabs(a[pivot][column])) pivot = row;
        }
        std::swap(a[column], a[pivot]);
        std::swap(b[column], b[pivot]);
        for (std::size_t row = column + 1; row < n; ++row) {
            const double factor = a[row][column] / a[column][column];
            for (std::size_t i = column; i < n; ++i) a[row][i] -= factor * a[column][i];
            b[row] -= factor * b[column];
        }
    }
    for (std::size_t row = n; row-- > 0;) {
        for (std::size_t i = row + 1; i < n; ++i) b[row] -= a[row][i] * b[i];
        b[row] /= a[row][row];
    }
    return b;
}

}  // namespace cairn::lab::reference
