#include "base/radix_sort.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/random.h"

namespace cairn::physics {

TEST_CASE("keys of any number and width come out as from a comparing sort") {
    test::Random random(1);
    RadixSort radix;
    for (const int count : {0, 1, 2, 255, 256, 257, 5'000}) {
        for (const int bits : {0, 1, 11, 12, 38, 63, 64}) {
            const int shift = random.below(65 - bits);
            std::vector<std::uint64_t> keys;
            for (int i = 0; i < count; ++i)
                keys.push_back(bits == 0 ? 7 : random.bits() >> (64 - bits) << shift);
            std::vector<std::uint64_t> expected = keys;
            std::sort(expected.begin(), expected.end());
            radix.sort(keys);
            REQUIRE(keys == expected);
        }
    }
}

}  // namespace cairn::physics
