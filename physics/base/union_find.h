// Disjoint sets over 0..n-1. Invariant: the root of a set is its smallest member, whatever the order of
// unions, so sets come out in a fixed order. Source: Tarjan 1975, with path halving.
#pragma once

#include <numeric>
#include <vector>

#include "base/ample.h"

namespace cairn::physics {

class UnionFind {
  public:
    void reset(int count) {
        resize_amply(parent_, static_cast<std::size_t>(count));
        std::iota(parent_.begin(), parent_.end(), 0);
    }
    int find(int i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }
    void unite(int a, int b) {
        a = find(a);
        b = find(b);
        if (a < b) {
            parent_[b] = a;
        } else {
            parent_[a] = b;
        }
    }

  private:
    std::vector<int> parent_;
};

}  // namespace cairn::physics
