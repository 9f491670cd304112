// The tree against a plain list of boxes.
#include "broad/aabb_tree.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <vector>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using test::Random;

struct Entry {
    int item;
    Aabb box;
};
using Entries = std::map<int, Entry>;  // by proxy

Aabb random_box(Random& random) {
    const Vec2 lower = random.vector(-50, 50);
    const float width = random.real_f(0, 4);
    return {lower, lower + Vec2{width, random.real_f(0, 4)}};
}

std::vector<int> items_in(const AabbTree& tree, const Aabb& box) {
    std::vector<int> items;
    tree.query(box, [&](int item) { items.push_back(item); });
    std::sort(items.begin(), items.end());
    return items;
}

std::vector<int> items_in(const Entries& entries, const Aabb& box) {
    std::vector<int> items;
    for (const auto& [proxy, entry] : entries) {
        if (overlap(entry.box, box)) items.push_back(entry.item);
    }
    std::sort(items.begin(), items.end());
    return items;
}

// Where the segment enters the box; above 1 when it does not.
double entry_fraction(const Aabb& box, Position origin, Vec2 translation) {
    double enter = 0;
    double leave = 1;
    const double from[] = {origin.x, origin.y};
    const double along[] = {static_cast<double>(translation.x), static_cast<double>(translation.y)};
    const double low[] = {static_cast<double>(box.lower.x), static_cast<double>(box.lower.y)};
    const double high[] = {static_cast<double>(box.upper.x), static_cast<double>(box.upper.y)};
    for (int axis = 0; axis < 2; ++axis) {
        const double t1 = (low[axis] - from[axis]) / along[axis];
        const double t2 = (high[axis] - from[axis]) / along[axis];
        enter = std::max(enter, std::min(t1, t2));
        leave = std::min(leave, std::max(t1, t2));
    }
    return enter <= leave ? enter : 2;
}

void change_at_random(Random& random, AabbTree& tree, Entries& entries, int& next_item) {
    const double choice = random.real(0, 1);
    if (entries.empty() || choice < 0.35) {
        const Aabb box = random_box(random);
        const int proxy = tree.insert(box, next_item);
        REQUIRE(entries.emplace(proxy, Entry{next_item, box}).second);
        ++next_item;
        return;
    }
    auto chosen = entries.begin();
    std::advance(chosen, random.below(static_cast<int>(entries.size())));
    if (choice < 0.65) {
        tree.remove(chosen->first);
        entries.erase(chosen);
    } else {
        chosen->second.box = random_box(random);
        tree.move(chosen->first, chosen->second.box);
    }
}

}  // namespace

TEST_CASE("an empty tree answers with nothing") {
    const AabbTree tree;
    CHECK(tree.is_valid());
    CHECK(tree.height() == 0);
    CHECK(items_in(tree, {{-1e9f, -1e9f}, {1e9f, 1e9f}}).empty());
    tree.cast_ray({0, 0}, {1, 1}, [](int) -> float { throw std::logic_error("no leaf to visit"); });
}

TEST_CASE("a tree finds the same overlaps as a list while boxes come, go and move") {
    Random random(1);
    AabbTree tree;
    Entries entries;
    int next_item = 0;
    for (int operation = 0; operation < 20'000; ++operation) {
        change_at_random(random, tree, entries, next_item);
        if (operation % 20 != 0) continue;
        REQUIRE(tree.is_valid());
        const Aabb asked = random_box(random);
        REQUIRE(items_in(tree, asked) == items_in(entries, asked));
    }
    for (const auto& [proxy, entry] : entries) {
        REQUIRE(tree.item(proxy) == entry.item);
        REQUIRE(tree.box(proxy).lower == entry.box.lower);
        REQUIRE(tree.box(proxy).upper == entry.box.upper);
    }
    while (!entries.empty()) {
        tree.remove(entries.begin()->first);
        entries.erase(entries.begin());
        REQUIRE(tree.is_valid());
    }
    CHECK(items_in(tree, {{-1e9f, -1e9f}, {1e9f, 1e9f}}).empty());
}

TEST_CASE("a ray through a tree meets the same nearest box as in a list") {
    Random random(2);
    AabbTree tree;
    std::vector<Entry> boxes;
    for (int item = 0; item < 400; ++item) {
        boxes.push_back({item, random_box(random)});
        tree.insert(boxes.back().box, item);
    }
    int met = 0;
    for (int ray = 0; ray < 2'000; ++ray) {
        const Position origin{random.real(-60, 60), random.real(-60, 60)};
        const Vec2 translation = random.vector(-60, 60);
        double expected = 2;
        for (const Entry& entry : boxes)
            expected = std::min(expected, entry_fraction(entry.box, origin, translation));
        double nearest = 2;
        tree.cast_ray(origin, translation, [&](int item) {
            nearest = std::min(nearest, entry_fraction(boxes[item].box, origin, translation));
            // Rounded up, so that a box which is nearer by less than a place of float is still visited.
            return round_up(std::min(nearest, 1.0));
        });
        REQUIRE(nearest == expected);
        met += nearest <= 1 ? 1 : 0;
    }
    CHECK(met > 500);
}

TEST_CASE("a ray visits nothing beyond the fraction that a visit returns") {
    AabbTree tree;
    for (int item = 0; item < 100; ++item) {
        const auto x = static_cast<float>(item);
        tree.insert({{x, -1}, {x + 0.5f, 1}}, item);
    }
    // Once a box has been visited, the segment is cut off where that box begins: later boxes lie behind.
    int nearest = 100;
    tree.cast_ray({-1, 0}, {1000, 0}, [&](int item) {
        CHECK(item < nearest);
        nearest = item;
        return static_cast<float>(item + 1) / 1000;
    });
    CHECK(nearest == 0);
}

TEST_CASE("a tree of a row of boxes inserted in order stays shallow") {
    AabbTree tree;
    for (int item = 0; item < 1024; ++item) {
        const auto x = static_cast<float>(item);
        tree.insert({{x, 0}, {x + 0.9f, 1}}, item);
    }
    // A perfect tree has height 10; without rotations sorted insertion gives one of 1023.
    CHECK(tree.height() <= 30);
}

}  // namespace cairn::physics
