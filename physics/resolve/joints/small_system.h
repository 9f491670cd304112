// Symmetric systems of up to three equations, as single joints have them.
#pragma once

#include <array>
#include <cmath>

#include "resolve/joints/joint_constraint.h"

namespace cairn::physics {

struct SmallSystem {
    int size = 0;
    std::array<std::array<float, kMaxDirections>, kMaxDirections> k{};  // the lower triangle counts
};

/// Solves K x = b by LDL^T, the greatest pivot first. What cannot be moved, a pivot of at most `least` or
/// lost in rounding, gets 0: locked axes and directions that say the same twice have no impulse of their own.
inline std::array<float, kMaxDirections> solve(SmallSystem system, std::array<float, kMaxDirections> b,
                                               float least) {
    auto& k = system.k;
    const int n = system.size;
    for (int i = 0; i < n; ++i) {
        for (int j = i + 1; j < n; ++j) k[i][j] = k[j][i];
    }
    constexpr float kLost = 1e-6f;
    std::array<int, kMaxDirections> order{0, 1, 2};
    std::array<float, kMaxDirections> start{};
    for (int i = 0; i < n; ++i) start[i] = k[i][i];
    int rank = 0;
    for (; rank < n; ++rank) {
        int best = rank;
        for (int i = rank + 1; i < n; ++i) {
            if (k[order[i]][order[i]] > k[order[best]][order[best]]) best = i;
        }
        std::swap(order[rank], order[best]);
        const int p = order[rank];
        if (!(k[p][p] > least && k[p][p] > kLost * start[p])) break;
        for (int i = rank + 1; i < n; ++i) {
            const int r = order[i];
            const float factor = k[r][p] / k[p][p];
            for (int j = rank + 1; j < n; ++j) k[r][order[j]] -= factor * k[p][order[j]];
            b[r] -= factor * b[p];
        }
    }
    std::array<float, kMaxDirections> x{};
    for (int i = rank - 1; i >= 0; --i) {
        const int p = order[i];
        float sum = b[p];
        for (int j = i + 1; j < rank; ++j) sum -= k[p][order[j]] * x[order[j]];
        x[p] = sum / k[p][p];
    }
    return x;
}

}  // namespace cairn::physics
