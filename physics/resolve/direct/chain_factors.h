// Symmetric positive definite systems that are block-tridiagonal with blocks of two, as chains of pins have
// them, factored as block L D L^T.
//
// Elimination starts at both ends and meets in the middle: each step waits for the one before, so two that do
// not know each other take little longer than one. Invariant: quantities of all blocks stand in arrays of
// their own, so that what is not a recursion is done on several at once. Source: van der Vorst, "Large
// Tridiagonal and Block Tridiagonal Linear Systems on Vector and Parallel Computers" (1987), for the order.
#pragma once

#include <vector>

namespace cairn::physics {

class ChainFactors {
  public:
    void resize(int blocks);
    [[nodiscard]] int size() const { return size_; }

    // What to factor, to be set: a block [xx xy; xy yy] of the diagonal, and beside it, in its rows and the
    // columns of the next one, [a b; c d].
    std::vector<double> xx, xy, yy;
    std::vector<double> a, b, c, d;

    void factor();
    /// In place for a right-hand side of x and y of each block.
    void solve(double* x, double* y) const;

  private:
    // A block when it is eliminated: S = L D L^T, and G = S^-1 O with O beside it, towards the middle.
    struct Pivot {
        double by_x = 0, l = 0, by_y = 0;  // 1/D and L
        double xx = 0, xy = 0, yx = 0, yy = 0;
    };
    // The diagonal as what was eliminated leaves it.
    struct Rest {
        double xx, xy, yy;
    };

    [[nodiscard]] Rest rest(int block) const;
    static void invert(Pivot& p, const Rest& s);

    std::vector<Pivot> pivots_;
    int size_ = 0;
};

}  // namespace cairn::physics
