// The tree against a plain list of boxes.
#include "broad/box_tree.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using test::Random;
using Entries = std::map<int, Aabb>;  // by item

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr Aabb kEverywhere{{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};

Aabb random_box(Random& random) {
    const Vec2 lower = random.vector(-50, 50);
    const float largest = random.chance(0.02) ? 60 : 4;
    const float width = random.real_f(0, largest);
    return {lower, lower + Vec2{width, random.real_f(0, largest)}};
}

std::vector<int> items_in(const BoxTree& tree, const Aabb& box) {
    std::vector<int> items;
    tree.query(box, [&](int item) { items.push_back(item); });
    std::sort(items.begin(), items.end());
    return items;
}

std::vector<int> items_in(const Entries& entries, const Aabb& box) {
    std::vector<int> items;
    for (const auto& [item, own] : entries) {
        if (overlap(own, box)) items.push_back(item);
    }
    return items;
}

void change_at_random(Random& random, BoxTree& tree, Entries& entries, OrderScratch& scratch, double growth) {
    const double choice = random.real(0, 1);
    if (entries.empty() || choice < growth) {
        // Numbers are given again, as slots are.
        const int item = random.below(2 * static_cast<int>(entries.size()) + 2);
        if (entries.count(item) != 0) return;
        const Aabb box = random_box(random);
        tree.insert(item, box, scratch);
        entries[item] = box;
        return;
    }
    auto chosen = entries.begin();
    std::advance(chosen, random.below(static_cast<int>(entries.size())));
    if (choice < 0.7) {
        tree.remove(chosen->first, scratch);
        entries.erase(chosen);
    } else if (choice < 0.995) {
        chosen->second = random_box(random);
        tree.move(chosen->first, chosen->second);
    } else {
        tree.rebuild(scratch);
    }
}

BoxTree row_of(int count, OrderScratch& scratch) {
    BoxTree tree;
    for (int item = 0; item < count; ++item) {
        const auto x = static_cast<float>(item);
        tree.insert(item, {{x, 0}, {x + 0.9f, 1}}, scratch);
    }
    return tree;
}

// How many groups a query looks at.
int visited_groups(const BoxTree& tree, const Aabb& box) {
    int visited = 0;
    tree.walk(
        [&](BoxTree::Node, const BoxGroup& boxes) {
            ++visited;
            return overlapping(boxes, box);
        },
        [](int, LaneMask) {});
    return visited;
}

}  // namespace

TEST_CASE("eight boxes compared at once give what eight comparisons give") {
    Random random(5);
    for (int round = 0; round < 2'000; ++round) {
        BoxGroup group;
        LaneMask expected = 0;
        const Aabb asked = random_box(random);
        Aabb all;
        for (int lane = 0; lane < kGroupSize; ++lane) {
            if (random.chance(0.2)) continue;
            const Aabb box = random_box(random);
            group.set_box(lane, box);
            all = merged(all, box);
            if (overlap(box, asked)) expected |= 1u << lane;
        }
        REQUIRE(overlapping(group, asked) == expected);
        REQUIRE(bounds(group).lower == all.lower);
        REQUIRE(bounds(group).upper == all.upper);
    }
    const BoxGroup touching = [] {
        BoxGroup group;
        group.set_box(3, {{1, 0}, {2, 1}});
        return group;
    }();
    CHECK(overlapping(touching, {{0, 0}, {1, 1}}) == 1u << 3);
    CHECK(overlapping(touching, {{0, 0}, {0.999f, 1}}) == 0);
}

TEST_CASE("an empty tree answers with nothing") {
    const BoxTree tree;
    CHECK(tree.is_valid());
    CHECK(tree.size() == 0);
    CHECK(items_in(tree, kEverywhere).empty());
    tree.cast_box({0, 0}, {}, {1, 1}, 1, [](int) -> float { throw std::logic_error("no leaf to visit"); });
    tree.query_segment({0, 0}, {1, 1}, [](int) { throw std::logic_error("no leaf to visit"); });
}

TEST_CASE("trees of any size hold all their boxes, and lose them one by one") {
    OrderScratch scratch;
    for (const int count : {1, 7, 8, 9, 63, 64, 65, 511, 512, 513, 5'000}) {
        BoxTree tree = row_of(count, scratch);
        for (const bool in_order : {false, true}) {
            if (in_order) tree.rebuild(scratch);
            REQUIRE(tree.is_valid());
            REQUIRE(static_cast<int>(items_in(tree, kEverywhere).size()) == count);
            for (int item = 0; item < count; item += 1 + count / 50) {
                const auto x = static_cast<float>(item);
                REQUIRE(items_in(tree, {{x + 0.1f, 0}, {x + 0.8f, 0}}) == std::vector{item});
            }
        }
        for (int item = 0; item < count; ++item) {
            tree.remove(item, scratch);
            if (item % (1 + count / 20) != 0) continue;
            REQUIRE(tree.is_valid());
            REQUIRE(static_cast<int>(items_in(tree, kEverywhere).size()) == count - item - 1);
        }
        REQUIRE(tree.size() == 0);
    }
}

TEST_CASE("a tree finds the same overlaps as a list while boxes come, go and move") {
    Random random(1);
    OrderScratch scratch;
    BoxTree tree;
    Entries entries;
    std::size_t most = 0;
    for (int operation = 0; operation < 30'000; ++operation) {
        // It grows to hundreds, shrinks to few, and again.
        change_at_random(random, tree, entries, scratch, operation / 5'000 % 2 == 0 ? 0.6 : 0.1);
        most = std::max(most, entries.size());
        if (operation % 20 != 0) continue;
        REQUIRE(tree.is_valid());
        const Aabb asked = random_box(random);
        REQUIRE(items_in(tree, asked) == items_in(entries, asked));
    }
    CHECK(most > 500);
    for (const auto& [item, box] : entries) {
        REQUIRE(tree.box(item).lower == box.lower);
        REQUIRE(tree.box(item).upper == box.upper);
    }
}

TEST_CASE("a hundred thousand boxes, many of them in one place, are found") {
    Random random(6);
    OrderScratch scratch;
    BoxTree tree;
    Entries entries;
    for (int item = 0; item < 100'000; ++item) {
        const Vec2 at = item % 4 == 0 ? Vec2{7, 7} : random.vector(-300, 300);
        entries[item] = {at, at + Vec2{1, 1}};
        tree.insert(item, entries[item], scratch);
    }
    tree.rebuild(scratch);
    REQUIRE(tree.is_valid());
    for (const Vec2 at : {Vec2{0, 0}, Vec2{7.5f, 7.5f}, Vec2{-300, 200}, Vec2{1000, 0}}) {
        const Aabb asked{at, at + Vec2{3, 3}};
        REQUIRE(items_in(tree, asked) == items_in(entries, asked));
    }
}

TEST_CASE("boxes far from the origin, infinite ones and runaways are found") {
    Random random(7);
    OrderScratch scratch;
    BoxTree tree;
    Entries entries;
    for (int item = 0; item < 500; ++item) {
        const double far = item % 3 == 0 ? 1e7 : item % 3 == 1 ? -3e37 : 0;
        entries[item] = make_aabb({far + random.real(-20, 20), random.real(-20, 20)}, {}, {1, 1});
        tree.insert(item, entries[item], scratch);
    }
    entries[500] = {{-kInfinity, -1}, {kInfinity, 1}};
    tree.insert(500, entries[500], scratch);
    entries[501] = make_aabb({1e300, -1e300}, {}, {1, 1});
    tree.insert(501, entries[501], scratch);
    for (const bool in_order : {false, true}) {
        if (in_order) tree.rebuild(scratch);
        REQUIRE(tree.is_valid());
        REQUIRE(items_in(tree, kEverywhere).size() == 502);
        for (const auto& [item, box] : entries) REQUIRE(items_in(tree, box) == items_in(entries, box));
    }
}

TEST_CASE("a ray through a tree meets the same nearest box as in a list") {
    Random random(2);
    OrderScratch scratch;
    BoxTree tree;
    Entries entries;
    for (int item = 0; item < 400; ++item) {
        entries[item] = random_box(random);
        tree.insert(item, entries[item], scratch);
    }
    int met = 0;
    for (int ray = 0; ray < 4'000; ++ray) {
        if (ray == 2'000) tree.rebuild(scratch);
        const Position origin{random.real(-60, 60), random.real(-60, 60)};
        const Vec2 half = ray % 2 == 0 ? Vec2{} : random.vector(0, 3);
        const Vec2 translation = random.vector(-60, 60);
        const BoxCast cast(origin, half, translation);
        double expected = 2;
        for (const auto& [item, box] : entries) expected = std::min(expected, cast.enter(box));
        double nearest = 2;
        tree.cast_box(origin, half, translation, 1, [&](int item) {
            nearest = std::min(nearest, cast.enter(entries[item]));
            // Rounded up, so that a box which is nearer by less than a place of float is still visited.
            return round_up(std::min(nearest, 1.0));
        });
        REQUIRE(nearest == expected);
        met += nearest <= 1 ? 1 : 0;
    }
    CHECK(met > 1'000);
}

TEST_CASE("a ray whose visits shorten nothing meets each box on it once") {
    Random random(8);
    OrderScratch scratch;
    BoxTree tree;
    Entries entries;
    for (int item = 0; item < 400; ++item) {
        entries[item] = random_box(random);
        tree.insert(item, entries[item], scratch);
    }
    for (int ray = 0; ray < 500; ++ray) {
        const Position origin{random.real(-60, 60), random.real(-60, 60)};
        const Vec2 translation = random.chance(0.1) ? Vec2{} : random.vector(-60, 60);
        const float fraction = random.real_f(0, 1);
        std::vector<int> expected;
        for (const auto& [item, box] : entries) {
            if (BoxCast(origin, {}, translation).enter(box) <= static_cast<double>(fraction))
                expected.push_back(item);
        }
        std::vector<int> items;
        tree.cast_box(origin, {}, translation, fraction, [&](int item) {
            items.push_back(item);
            return fraction;
        });
        std::sort(items.begin(), items.end());
        REQUIRE(items == expected);
    }
}

TEST_CASE("a segment meets the boxes that a ray of its length meets, from near and far") {
    Random random(10);
    OrderScratch scratch;
    BoxTree tree;
    Entries entries;
    for (int item = 0; item < 400; ++item) {
        entries[item] = random_box(random);
        tree.insert(item, entries[item], scratch);
    }
    int met = 0;
    for (int segment = 0; segment < 2'000; ++segment) {
        const bool is_far = segment % 4 == 0;
        const Position origin = is_far ? Position{random.real(-1e7, -9e6), random.real(9e6, 1e7)}
                                       : Position{random.real(-60, 60), random.real(-60, 60)};
        Vec2 translation = is_far ? Vec2{static_cast<float>(-2 * origin.x), static_cast<float>(-2 * origin.y)}
                                  : random.vector(-60, 60);
        if (random.chance(0.1)) translation = {};
        if (random.chance(0.1)) translation.x = 0;
        std::vector<int> expected;
        for (const auto& [item, box] : entries) {
            if (BoxCast(origin, {}, translation).enter(box) <= 1) expected.push_back(item);
        }
        std::vector<int> items;
        tree.query_segment(origin, translation, [&](int item) { items.push_back(item); });
        std::sort(items.begin(), items.end());
        REQUIRE(items == expected);
        met += static_cast<int>(items.size());
    }
    CHECK(met > 2'000);
}

TEST_CASE("a ray visits nothing beyond the fraction that a visit returns") {
    OrderScratch scratch;
    const BoxTree tree = row_of(100, scratch);
    // Once a box has been visited, the segment is cut off where that box begins: later boxes lie behind.
    int nearest = 100;
    int visits = 0;
    tree.cast_box({-1, 0.5}, {}, {1000, 0}, 1, [&](int item) {
        CHECK(item < nearest);
        nearest = item;
        ++visits;
        return static_cast<float>(item + 1) / 1000;
    });
    CHECK(nearest == 0);
    // The nearest child is entered first, so in a row the first visit is the last.
    CHECK(visits == 1);
}

TEST_CASE("queries of a tree that has just grown, shrunk or moved look at few groups") {
    Random random(9);
    OrderScratch scratch;
    BoxTree tree;
    constexpr int kCount = 20'000;
    const auto unit_box = [&](double side) {
        const Vec2 at = random.vector(0, side);
        return Aabb{at, at + Vec2{1, 1}};
    };
    // One box per square metre whatever the number: a query of a unit box then meets about four.
    const double side = std::sqrt(static_cast<double>(kCount));
    // Appended without order, a query would look at one group in eight boxes: 2,500.
    int worst = 0;
    for (int item = 0; item < kCount; ++item) {
        tree.insert(item, unit_box(side), scratch);
        if (item % 100 == 99) worst = std::max(worst, visited_groups(tree, unit_box(side)));
    }
    CHECK(worst < 150);
    for (int item = 0; item < kCount - 100; ++item) {
        tree.remove(item, scratch);
        if (item % 100 == 99) worst = std::max(worst, visited_groups(tree, unit_box(side)));
    }
    CHECK(worst < 150);
}

TEST_CASE("bulk insertion and removal order each box as often as the tree has levels") {
    Random random(10);
    OrderScratch scratch;
    for (const int count : {1'000, 10'000, 100'000}) {
        BoxTree tree;
        for (int item = 0; item < count; ++item) {
            const Vec2 at = random.vector(0, 1000);
            tree.insert(item, {at, at + Vec2{1, 1}}, scratch);
        }
        const auto levels = static_cast<std::int64_t>(std::ceil(std::log2(count) / 3));
        CHECK(tree.ordered_count() <= levels * count);
        const std::int64_t after_insertion = tree.ordered_count();
        for (int item = 0; item < count; ++item) tree.remove(item, scratch);
        // Each rebuild follows as many removals as it leaves boxes.
        CHECK(tree.ordered_count() - after_insertion <= count);
    }
}

TEST_CASE("a box that comes and goes for ever does not make the tree grow") {
    OrderScratch scratch;
    BoxTree tree = row_of(100, scratch);
    for (int round = 0; round < 10'000; ++round) {
        tree.insert(100, {{5, 5}, {6, 6}}, scratch);
        tree.remove(100, scratch);
    }
    CHECK(tree.items().size() <= 256);
    CHECK(tree.is_valid());
}

TEST_CASE("boxes that are shifted together are found where they are, and nodes are made just large enough") {
    for (const int count : {1, 7, 8, 9, 64, 65, 700}) {
        Random random(static_cast<std::uint64_t>(count));
        OrderScratch scratch;
        BoxTree tree;
        Entries entries;
        for (int item = 0; item < count; ++item) {
            entries[item] = random_box(random);
            tree.insert(item, entries[item], scratch);
        }
        tree.rebuild(scratch);
        for (int round = 0; round < 20; ++round) {
            Aabb all;
            for (auto& [item, box] : entries) {
                const Vec2 way = random.vector(-30, 30);
                box = {box.lower + way, box.upper + way};
                all = merged(all, box);
                tree.shift(item, box);
            }
            tree.refit();
            INFO(count << " boxes, round " << round);
            REQUIRE(tree.is_valid());
            const Aabb root = bounds(tree.level(tree.level_count() - 1)[0]);
            REQUIRE(root.lower == all.lower);
            REQUIRE(root.upper == all.upper);
            for (int i = 0; i < 20; ++i) {
                const Aabb box = random_box(random);
                REQUIRE(items_in(tree, box) == items_in(entries, box));
            }
        }
    }
}

TEST_CASE("a tree is worn when its boxes have scattered, and not when they move along together") {
    Random random(5);
    OrderScratch scratch;
    BoxTree tree;
    Entries entries;
    for (int item = 0; item < 700; ++item) {
        entries[item] = random_box(random);
        tree.insert(item, entries[item], scratch);
    }
    tree.rebuild(scratch);
    const auto shift_all = [&](auto&& way_of) {
        for (auto& [item, box] : entries) {
            const Vec2 way = way_of();
            box = {box.lower + way, box.upper + way};
            tree.shift(item, box);
        }
        tree.refit();
    };
    for (int i = 0; i < 100; ++i) shift_all([] { return Vec2{1, -2}; });
    CHECK_FALSE(tree.is_worn());
    shift_all([&] { return random.vector(-30, 30); });
    CHECK(tree.is_worn());
    tree.rebuild(scratch);
    CHECK_FALSE(tree.is_worn());
}

}  // namespace cairn::physics
