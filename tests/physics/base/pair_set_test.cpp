#include "base/pair_set.h"

#include <catch2/catch.hpp>
#include <set>
#include <utility>

#include "physics/support/random.h"

namespace cairn::physics {

TEST_CASE("a pair is the same in either order") {
    PairSet pairs;
    CHECK(pairs.insert(3, 5));
    CHECK_FALSE(pairs.insert(5, 3));
    CHECK(pairs.contains(5, 3));
    pairs.erase(5, 3);
    CHECK_FALSE(pairs.contains(3, 5));
}

TEST_CASE("an empty pair set holds nothing and lets nothing be erased") {
    PairSet pairs;
    CHECK_FALSE(pairs.contains(0, 1));
    pairs.erase(0, 1);
    CHECK(pairs.insert(0, 1));
}

TEST_CASE("a pair set agrees with a sorted set under random insertion, removal and lookup") {
    test::Random random(1);
    PairSet pairs;
    std::set<std::pair<int, int>> expected;
    // Few indices, so that removals hit; far apart ones, so that both halves of the key count.
    const auto draw = [&] { return random.below(40) * (random.chance(0.5) ? 1 : 50'000'000); };
    for (int operation = 0; operation < 200'000; ++operation) {
        const int a = draw();
        const int b = draw();
        if (a == b) continue;
        const std::pair<int, int> key = std::minmax(a, b);
        switch (random.below(3)) {
            case 0:
                REQUIRE(pairs.insert(a, b) == expected.insert(key).second);
                break;
            case 1:
                pairs.erase(a, b);
                expected.erase(key);
                break;
            default:
                REQUIRE(pairs.contains(a, b) == (expected.count(key) == 1));
        }
    }
    for (const auto& [a, b] : expected) REQUIRE(pairs.contains(a, b));
}

}  // namespace cairn::physics
