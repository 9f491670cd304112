// Pair finding against a comparison of every box with every other.
#include "broad/broad_phase.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <vector>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using test::Random;
using Pairs = std::vector<std::pair<int, int>>;

struct Item {
    Layer layer = Layer::Moving;
    int proxy = kNone;
    Aabb box;
    bool moved = true;
};
using Items = std::map<int, Item>;

Aabb random_box(Random& random) {
    const Vec2 lower = random.vector(-15, 15);
    const float width = random.real_f(0.2, 3);
    return {lower, lower + Vec2{width, random.real_f(0.2, 3)}};
}

Pairs expected_pairs(Items& items) {
    Pairs pairs;
    for (const auto& [i, a] : items) {
        for (const auto& [j, b] : items) {
            if (i >= j || (a.layer == Layer::Fixed && b.layer == Layer::Fixed)) continue;
            if ((a.moved || b.moved) && overlap(a.box, b.box)) pairs.emplace_back(i, j);
        }
    }
    for (auto& [i, item] : items) item.moved = false;
    return pairs;
}

}  // namespace

TEST_CASE("every new pair is reported once, sorted, while boxes come, go, move and are touched") {
    Random random(1);
    BroadPhase broad;
    Items items;
    int next = 0;
    int reported = 0;
    for (int round = 0; round < 500; ++round) {
        for (int change = random.below(12); change > 0; --change) {
            const double choice = random.real(0, 1);
            if (items.empty() || choice < 0.3) {
                // Numbers are given again, as slots are.
                int number = random.chance(0.5) ? random.below(next + 1) : next;
                if (items.count(number) != 0) number = next;
                next = std::max(next, number + 1);
                Item item{random.chance(0.3) ? Layer::Fixed : Layer::Moving, kNone, random_box(random), true};
                item.proxy = broad.add(item.layer, item.box, number);
                items[number] = item;
                continue;
            }
            auto chosen = items.begin();
            std::advance(chosen, random.below(static_cast<int>(items.size())));
            Item& item = chosen->second;
            if (choice < 0.5) {
                broad.remove(item.layer, item.proxy);
                items.erase(chosen);
            } else if (choice < 0.9) {
                item.box = random_box(random);
                item.moved = true;
                broad.move(item.layer, item.proxy, item.box);
            } else {
                item.moved = true;
                broad.touch(item.layer, item.proxy);
            }
        }
        const Pairs expected = expected_pairs(items);
        REQUIRE(broad.find_new_pairs() == expected);
        reported += static_cast<int>(expected.size());
        REQUIRE(broad.find_new_pairs().empty());
        REQUIRE(broad.tree(Layer::Fixed).is_valid());
        REQUIRE(broad.tree(Layer::Moving).is_valid());
    }
    CHECK(reported > 1000);
}

TEST_CASE("fixed boxes never pair with each other") {
    BroadPhase broad;
    const Aabb box{{0, 0}, {1, 1}};
    broad.add(Layer::Fixed, box, 0);
    broad.add(Layer::Fixed, box, 1);
    CHECK(broad.find_new_pairs().empty());
    broad.add(Layer::Moving, box, 2);
    CHECK(broad.find_new_pairs() == Pairs{{0, 2}, {1, 2}});
}

TEST_CASE("a fixed box that moves onto a moving one is a new pair") {
    BroadPhase broad;
    const int proxy = broad.add(Layer::Fixed, {{0, 0}, {1, 1}}, 0);
    broad.add(Layer::Moving, {{5, 0}, {6, 1}}, 1);
    REQUIRE(broad.find_new_pairs().empty());
    broad.move(Layer::Fixed, proxy, {{5.5f, 0}, {6.5f, 1}});
    CHECK(broad.find_new_pairs() == Pairs{{0, 1}});
}

TEST_CASE("the order of pairs does not depend on the order in which boxes were added") {
    Random random(2);
    std::vector<Aabb> boxes;
    std::vector<int> order;
    for (int i = 0; i < 100; ++i) {
        boxes.push_back(random_box(random));
        order.push_back(i);
    }
    Pairs first;
    for (int round = 0; round < 20; ++round) {
        BroadPhase broad;
        for (const int i : order) broad.add(i % 3 == 0 ? Layer::Fixed : Layer::Moving, boxes[i], i);
        const Pairs pairs = broad.find_new_pairs();
        if (round == 0) first = pairs;
        REQUIRE(pairs == first);
        for (int i = 99; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
    }
    CHECK(first.size() > 30);
}

}  // namespace cairn::physics
