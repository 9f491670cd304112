// How vectors grow.
#include "base/ample.h"

#include <catch2/catch.hpp>

namespace cairn::physics {

TEST_CASE("a vector that grows one by one leaves a fifth of its room empty at most, and moves seldom") {
    std::vector<int> values;
    int moves = 0;
    std::size_t capacity = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        push_amply(values, i);
        if (values.capacity() == capacity) continue;
        capacity = values.capacity();
        ++moves;
        if (capacity > 1024)
            CHECK(static_cast<double>(capacity) <= 1.25 * static_cast<double>(values.size()));
    }
    // Doubling up to 256, by 256 up to 1,024, then by a quarter: log(1e6 / 1024) / log(1.25) times.
    CHECK(moves <= 9 + 3 + 31);
    CHECK(values.back() == 999'999);
}

TEST_CASE("sizes that creep up seldom ask for room, and one that jumps gets what it asks for") {
    CHECK(ample_capacity(0, 1) == 1);
    CHECK(ample_capacity(1, 2) == 2);
    CHECK(ample_capacity(100, 101) == 200);
    CHECK(ample_capacity(400, 401) == 656);
    CHECK(ample_capacity(4000, 4001) == 5000);
    CHECK(ample_capacity(4000, 9000) == 9000);
    std::vector<int> values;
    cover_amply(values, 3, 7);
    cover_amply(values, 2, 8);  // there are as many already
    cover_amply(values, 4, 9);
    CHECK(values == std::vector{7, 7, 7, 9});
}

}  // namespace cairn::physics
