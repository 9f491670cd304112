// The order along the curve: complete, the same for the same input, and local.
#include "broad/morton_order.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "base/slot_map.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using test::Random;

struct Places {
    std::vector<BoxGroup> groups;
    std::vector<int> items;

    void append(const Aabb& box, int item) {
        const std::size_t place = items.size();
        if (place % kGroupSize == 0) groups.emplace_back();
        groups.back().set_box(static_cast<int>(place % kGroupSize), box);
        items.push_back(item);
    }
};

std::vector<int> order_of(const Places& places) {
    MortonOrder order;
    std::vector<int> items;
    for (const std::uint64_t key : order.sort(places.groups, places.items))
        items.push_back(places.items[MortonOrder::place(key)]);
    return items;
}

// Unit squares around the middles of the cells of a square grid, shuffled.
Places grid(Random& random, int side, Vec2 corner) {
    std::vector<Vec2> middles;
    for (int x = 0; x < side; ++x) {
        for (int y = 0; y < side; ++y)
            middles.push_back(corner + Vec2{static_cast<float>(x), static_cast<float>(y)});
    }
    for (int i = side * side - 1; i > 0; --i) std::swap(middles[i], middles[random.below(i + 1)]);
    Places places;
    for (int i = 0; i < side * side; ++i)
        places.append({middles[i] - Vec2{0.5f, 0.5f}, middles[i] + Vec2{0.5f, 0.5f}}, i);
    return places;
}

// What the tree pays for: the perimeters of the boxes around each eight in a row.
double cost(const Places& places, const std::vector<int>& items) {
    double sum = 0;
    for (std::size_t i = 0; i < items.size(); i += kGroupSize) {
        Aabb all;
        for (std::size_t k = i; k < std::min(i + kGroupSize, items.size()); ++k)
            all = merged(all, places.groups[items[k] / kGroupSize].box(items[k] % kGroupSize));
        sum += static_cast<double>(half_perimeter(all));
    }
    return sum / static_cast<double>(items.size());
}

}  // namespace

TEST_CASE("an order holds each item once and no free lane, for few boxes and for many") {
    Random random(1);
    for (const int count : {0, 1, 7, 8, 9, 100, 255, 256, 257, 5'000}) {
        Places places;
        std::vector<int> expected;
        for (int i = 0; i < count; ++i) {
            const bool free = random.chance(0.2);
            const Vec2 at = random.vector(-100, 100);
            places.append(free ? Aabb{} : Aabb{at, at + random.vector(0, 3)}, free ? kNone : i);
            if (!free) expected.push_back(i);
        }
        std::vector<int> items = order_of(places);
        REQUIRE(items == order_of(places));
        std::sort(items.begin(), items.end());
        REQUIRE(items == expected);
    }
}

TEST_CASE("boxes in one cell keep the order they had") {
    Places places;
    for (int i = 0; i < 1'000; ++i) places.append({{1, 1}, {2, 2}}, i);
    const std::vector<int> items = order_of(places);
    CHECK(std::is_sorted(items.begin(), items.end()));
}

TEST_CASE("eight boxes in a row are neighbours") {
    Random random(2);
    const Places places = grid(random, 64, {-20, 30});
    // A block of 4 x 2 unit squares has a half perimeter of 6. Shuffled as they are: most of the grid's, 128.
    std::vector<int> as_they_are(64 * 64);
    for (int i = 0; i < 64 * 64; ++i) as_they_are[i] = i;
    CHECK(kGroupSize * cost(places, as_they_are) > 80);
    CHECK(kGroupSize * cost(places, order_of(places)) < 8);
}

TEST_CASE("neither one that flew off nor a large one, nor the distance from the origin, coarsens the order") {
    Random random(3);
    for (const Vec2 corner : {Vec2{-20, 30}, Vec2{-1e5f, 1e5f}}) {
        Places places = grid(random, 64, corner);
        places.append({{3e8f, -2e7f}, {3e8f, -2e7f}}, 64 * 64);
        places.append({{-1e4f, -1e4f}, {1e4f, 1e4f}}, 64 * 64 + 1);
        std::vector<int> items = order_of(places);
        std::erase_if(items, [](int item) { return item >= 64 * 64; });
        CHECK(kGroupSize * cost(places, items) < 10);
    }
}

}  // namespace cairn::physics
