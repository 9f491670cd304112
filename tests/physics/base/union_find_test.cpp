#include "base/union_find.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/random.h"

namespace cairn::physics {

TEST_CASE("the root of a set is its smallest member, whatever the order of unions") {
    test::Random random(1);
    constexpr int kCount = 200;
    for (int round = 0; round < 50; ++round) {
        UnionFind sets;
        sets.reset(kCount);
        // The second implementation: a label for each element, relabelled by walking through all of them.
        std::vector<int> label(kCount);
        for (int i = 0; i < kCount; ++i) label[i] = i;
        for (int unions = random.below(250); unions > 0; --unions) {
            const int a = random.below(kCount);
            const int b = random.below(kCount);
            sets.unite(a, b);
            const int low = std::min(label[a], label[b]);
            const int high = std::max(label[a], label[b]);
            for (int& l : label) {
                if (l == high) l = low;
            }
        }
        for (int i = 0; i < kCount; ++i) REQUIRE(sets.find(i) == label[i]);
    }
}

TEST_CASE("after a reset every element is alone again") {
    UnionFind sets;
    sets.reset(4);
    sets.unite(0, 3);
    sets.reset(6);
    for (int i = 0; i < 6; ++i) CHECK(sets.find(i) == i);
}

}  // namespace cairn::physics
