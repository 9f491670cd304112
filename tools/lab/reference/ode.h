// Integration of ordinary differential equations in double, to a tolerance far below what a physics engine
// reaches. Source: Dormand and Prince 1980, pair of orders 5 and 4; step control after Hairer, Norsett and
// Wanner, "Solving Ordinary Differential Equations I".
#pragma once

#include <functional>
#include <vector>

namespace cairn::lab::reference {

using State = std::vector<double>;
/// dy/dt at time t.
using Derivative = std::function<State(double t, const State& y)>;

/// y at time `to`, from y at time `from`. The error of a step is at most `tolerance` times 1 + |y|, in each
/// component.
State integrate(const Derivative& f, State y, double from, double to, double tolerance = 1e-13);

/// The x of A x = b, for a small dense A by rows. Gauss with pivots.
State solve_linear(std::vector<State> a, State b);

}  // namespace cairn::lab::reference
