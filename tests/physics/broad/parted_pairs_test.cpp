// Pairs in lanes against pairs looked at one by one.
#include "broad/parted_pairs.h"

#include <bit>
#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include <cairn/physics/simd.h>

#include "broad/box_way.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using test::Random;

constexpr int kItems = 50;

// Boxes that touch to the bit, or lie far from the origin, and ways of all lengths, some of them none.
struct Crowd {
    explicit Crowd(std::uint64_t seed) : random(seed) {
        constexpr float kHuge = std::numeric_limits<float>::max();
        for (int item = 0; item < kItems; ++item) {
            const Vec2 lower{static_cast<float>(random.below(8)), static_cast<float>(random.below(8))};
            boxes.push_back({lower, lower + Vec2{static_cast<float>(random.below(4)), random.real_f(0, 3)}});
            Vec2 way = random.chance(0.3) ? Vec2{} : random.vector(-4, 4);
            if (random.chance(0.05)) way = {random.chance(0.5) ? kHuge : -kHuge, 0};
            ways.push_back(way);
        }
        boxes[0] = {};  // of an item that has none
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            a[lane] = random.below(kItems);
            b[lane] = random.below(kItems);
        }
        lanes = static_cast<unsigned>(random.below(1 << kLanes));
        // What is not wanted need not be an item.
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            if ((lanes >> lane & 1) == 0) a[lane] = b[lane] = -1;
        }
    }

    [[nodiscard]] unsigned parted_one_by_one(bool with_ways) const {
        unsigned parted = 0;
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            if ((lanes >> lane & 1) == 0) continue;
            const auto i = static_cast<std::size_t>(a[lane]);
            const auto j = static_cast<std::size_t>(b[lane]);
            const bool apart = !overlap(boxes[i], boxes[j]) ||
                               (with_ways && keep_apart(boxes[i], ways[i], boxes[j], ways[j]));
            parted |= (apart ? 1u : 0u) << lane;
        }
        return parted;
    }

    Random random;
    std::vector<Aabb> boxes;
    std::vector<Vec2> ways;
    alignas(32) Lanes<std::int32_t> a{};
    alignas(32) Lanes<std::int32_t> b{};
    unsigned lanes = 0;
};

}  // namespace

TEST_CASE("pairs in lanes have parted when their boxes have, or keep apart on their ways") {
    for (const SimdLevel level : available_simd_levels()) {
        INFO(name(level));
        force_simd_level(level).value();
        int apart = 0;
        int apart_by_ways = 0;
        int together = 0;
        for (std::uint64_t seed = 0; seed < 3'000; ++seed) {
            const Crowd crowd(seed);
            const unsigned standing = crowd.parted_one_by_one(false);
            const unsigned moving = crowd.parted_one_by_one(true);
            REQUIRE(parted_lanes(crowd.boxes, {}, crowd.a, crowd.b, crowd.lanes) == standing);
            REQUIRE(parted_lanes(crowd.boxes, crowd.ways, crowd.a, crowd.b, crowd.lanes) == moving);
            apart += std::popcount(standing);
            apart_by_ways += std::popcount(moving & ~standing);
            together += std::popcount(crowd.lanes & ~moving);
        }
        CHECK(apart > 2'000);
        CHECK(apart_by_ways > 100);
        CHECK(together > 1'000);
    }
    force_simd_level(available_simd_levels().back()).value();
}

}  // namespace cairn::physics
