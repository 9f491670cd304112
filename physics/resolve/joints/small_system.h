// Symmetric systems of up to three equations, as single joints have them.
#pragma once

#include <array>
#include <utility>

#include "resolve/joints/joint_constraint.h"

namespace cairn::physics {

using SmallMatrix = std::array<std::array<float, kMaxDirections>, kMaxDirections>;
using SmallVector = std::array<float, kMaxDirections>;

/// Solves K x = b by LDL^T, the greatest pivot first. What cannot be moved, a pivot of at most `least` or
/// lost in rounding, gets 0: locked axes and directions that say the same twice have no impulse of their own.
/// K is the N rows and columns of `all` from `first` on; of it the lower triangle counts.
template <int N>
SmallVector solve_small(const SmallMatrix& all, int first, SmallVector b, float least) {
    constexpr float kLost = 1e-6f;
    if constexpr (N == 1) {
        const float k = all[first][first];
        return {k > least && k > 0 ? b[0] / k : 0};
    }
    SmallMatrix k{};
    std::array<int, N> order{};
    std::array<float, N> start{};
    for (int i = 0; i < N; ++i) {
        for (int j = 0; j <= i; ++j) k[i][j] = k[j][i] = all[first + i][first + j];
        order[i] = i;
        start[i] = k[i][i];
    }
    int rank = 0;
    for (; rank < N; ++rank) {
        int best = rank;
        for (int i = rank + 1; i < N; ++i) {
            if (k[order[i]][order[i]] > k[order[best]][order[best]]) best = i;
        }
        std::swap(order[rank], order[best]);
        const int p = order[rank];
        if (!(k[p][p] > least && k[p][p] > kLost * start[p])) break;
        for (int i = rank + 1; i < N; ++i) {
            const int r = order[i];
            const float factor = k[r][p] / k[p][p];
            for (int j = rank + 1; j < N; ++j) k[r][order[j]] -= factor * k[p][order[j]];
            b[r] -= factor * b[p];
        }
    }
    SmallVector x{};
    for (int i = rank - 1; i >= 0; --i) {
        const int p = order[i];
        float sum = b[p];
        for (int j = i + 1; j < rank; ++j) sum -= k[p][order[j]] * x[order[j]];
        x[p] = sum / k[p][p];
    }
    return x;
}

inline SmallVector solve_small(const SmallMatrix& all, int first, int size, const SmallVector& b,
                               float least) {
    if (size == 1) return solve_small<1>(all, first, b, least);
    if (size == 2) return solve_small<2>(all, first, b, least);
    return solve_small<3>(all, first, b, least);
}

}  // namespace cairn::physics
