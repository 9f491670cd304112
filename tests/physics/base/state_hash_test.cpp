#include "base/state_hash.h"

#include <catch2/catch.hpp>
#include <set>

namespace cairn::physics {
namespace {

std::uint64_t hash_of(std::initializer_list<std::uint64_t> words) {
    StateHash hash;
    for (const std::uint64_t word : words) hash.add(word);
    return hash.value();
}

}  // namespace

TEST_CASE("each single bit of a hashed word changes the hash to another value") {
    std::set<std::uint64_t> seen{hash_of({0, 0, 0})};
    for (int bit = 0; bit < 64; ++bit) {
        const std::uint64_t word = std::uint64_t{1} << bit;
        CHECK(seen.insert(hash_of({word, 0, 0})).second);
        CHECK(seen.insert(hash_of({0, word, 0})).second);
        CHECK(seen.insert(hash_of({0, 0, word})).second);
    }
}

TEST_CASE("a hash tells the order and the number of its words") {
    CHECK(hash_of({1, 2}) != hash_of({2, 1}));
    CHECK(hash_of({}) != hash_of({0}));
    CHECK(hash_of({0}) != hash_of({0, 0}));
}

TEST_CASE("one changed bit changes about half of the hash") {
    double changed = 0;
    for (int bit = 0; bit < 64; ++bit) {
        // A later word spreads the bit; the state of a world has thousands.
        changed += std::popcount(hash_of({std::uint64_t{1} << bit, 7}) ^ hash_of({0, 7}));
    }
    // 64 draws of a binomial with mean 32 and deviation 4: their mean deviates by 0.5; ten times that is
    // slack.
    CHECK(changed / 64 == Approx(32).margin(5));
}

TEST_CASE("the hash of numbers sees every bit: the last place and the sign of zero") {
    const auto of = [](Vec2 a) {
        StateHash hash;
        hash.add(a);
        return hash.value();
    };
    CHECK(of({1, 2}) != of({std::nextafter(1.0f, 2.0f), 2}));
    CHECK(of({1, 2}) != of({2, 1}));
    CHECK(of({0.0f, 0}) != of({-0.0f, 0}));
    CHECK(of({0, 0.0f}) != of({0, -0.0f}));
}

}  // namespace cairn::physics
