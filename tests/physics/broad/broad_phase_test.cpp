// Pair finding against a comparison of every box with every other, before and after each search.
#include "broad/broad_phase.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <catch2/catch.hpp>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "base/slot_map.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

// More threads than groups in small cases.
TaskPool tasks(3);

using test::Random;
using Pair = std::pair<int, int>;
using Pairs = std::set<Pair>;

struct Entry {
    Layer layer = Layer::Awake;
    Aabb box;
    bool touched = false;
    Vec2 way{};
    bool moved = true;  // since the last search
    int kin = 0;
};
using Entries = std::map<int, Entry>;  // by item

// All at once would be a poor test: most boxes overlap few others.
Aabb random_box(Random& random, double extent, double large = 0.03) {
    const Vec2 lower = random.vector(-extent, extent);
    const double size = random.chance(large) ? extent : 2;
    const float width = random.real_f(0.2, size);
    return {lower, lower + Vec2{width, random.real_f(0.2, size)}};
}

Layer random_layer(Random& random) {
    return kLayers[random.below(static_cast<int>(kLayers.size()))];
}

struct Overlaps {
    Pairs pairs;
    Pairs beside;  // that keep apart
};

Overlaps find_overlaps(const Entries& entries) {
    Overlaps all;
    for (auto a = entries.begin(); a != entries.end(); ++a) {
        for (auto b = std::next(a); b != entries.end(); ++b) {
            const auto& [item_a, of_a] = *a;
            const auto& [item_b, of_b] = *b;
            if (of_a.layer == Layer::Static && of_b.layer == Layer::Static) continue;
            if (of_a.kin != 0 && of_a.kin == of_b.kin) continue;
            if (!overlap(of_a.box, of_b.box)) continue;
            if (!keep_apart(of_a.box, of_a.way, of_b.box, of_b.way)) {
                all.pairs.emplace(item_a, item_b);
            } else if (of_a.moved || of_b.moved) {
                all.beside.emplace(item_a, item_b);
            }
        }
    }
    return all;
}

// What a caller keeps who takes every pair that is not marked, and looks the others up. Checks that no pair
// is reported twice, and that those reported are exactly the new ones.
class Model {
  public:
    BroadPhase broad;
    Entries entries;

    void add(int item, Layer layer, const Aabb& box) {
        broad.add(item, layer, box);
        entries[item] = {layer, box, false};
    }
    void remove(int item) {
        broad.remove(item);
        entries.erase(item);
        std::erase_if(known_, [&](const Pair& p) { return p.first == item || p.second == item; });
    }
    void move(int item, const Aabb& box, Vec2 way = {}) {
        broad.move(item, box);
        if (way != Vec2{}) broad.set_way(item, way);
        entries[item].box = box;
        entries[item].way = way;
        entries[item].moved = true;
    }
    // What has a way goes on, some of it another way than before.
    void go_on(Random& random) {
        for (auto& [item, entry] : entries) {
            if (entry.way == Vec2{}) continue;
            const Aabb box{entry.box.lower - 0.5f * entry.way, entry.box.upper - 0.5f * entry.way};
            move(item, box, random.chance(0.8) ? entry.way : Vec2{});
        }
    }
    void touch(int item) {
        broad.touch(item);
        entries[item].touched = entries[item].moved = true;
    }
    void set_kin(int item, int kin) {
        broad.set_kin(item, kin);
        entries[item].kin = kin;
        touch(item);
    }
    void set_layer(int item, Layer layer) {
        broad.set_layer(item, layer);
        entries[item].layer = layer;
        if (layer != Layer::Awake) entries[item].way = {};
    }

    void search() {
        const Overlaps overlaps = find_overlaps(entries);
        const Pairs& expected = overlaps.pairs;
        std::vector<ItemPair> fresh;
        std::vector<PairsBeside> beside;
        broad.search(0, broad.start_search(tasks), {fresh, beside});
        broad.end_search(fresh);
        Pairs found_beside;
        for (const PairsBeside& pairs : beside) {
            for (LaneMask lanes = pairs.lanes; lanes != 0; lanes &= lanes - 1) {
                const int other =
                    broad.group_items()[static_cast<std::size_t>(pairs.group)][std::countr_zero(lanes)];
                REQUIRE(
                    found_beside.emplace(std::min(pairs.item, other), std::max(pairs.item, other)).second);
            }
        }
        REQUIRE(found_beside == overlaps.beside);
        beside_ += found_beside.size();
        Pairs reported;
        for (const ItemPair& pair : fresh) {
            REQUIRE(pair.a < pair.b);
            const Pair key{pair.a, pair.b};
            REQUIRE(reported.insert(key).second);
            REQUIRE(expected.count(key) == 1);
            if (!pair.may_be_known) REQUIRE(known_.count(key) == 0);
        }
        for (const Pair& pair : expected) {
            const bool touched = entries[pair.first].touched || entries[pair.second].touched;
            if (touched || known_.count(pair) == 0) REQUIRE(reported.count(pair) == 1);
        }
        reported_ += reported.size();
        for (auto& [item, entry] : entries) entry.touched = entry.moved = false;
        // Contacts are ended by looking at those that are active: one of the two awake.
        known_.merge(reported);
        std::erase_if(known_, [&](const Pair& p) {
            const bool active =
                entries[p.first].layer == Layer::Awake || entries[p.second].layer == Layer::Awake;
            return active && expected.count(p) == 0;
        });
    }

    [[nodiscard]] std::size_t reported() const { return reported_; }
    [[nodiscard]] std::size_t beside() const { return beside_; }

    void check_trees() const {
        int held = 0;
        for (const Layer layer : kLayers) {
            REQUIRE(broad.tree(layer).is_valid());
            held += broad.tree(layer).size();
        }
        REQUIRE(held == static_cast<int>(entries.size()));
        for (const auto& [item, entry] : entries) {
            REQUIRE(broad.layer(item) == entry.layer);
            REQUIRE(broad.box(item).lower == entry.box.lower);
            REQUIRE(broad.box(item).upper == entry.box.upper);
        }
    }

  private:
    Pairs known_;
    std::size_t reported_ = 0;
    std::size_t beside_ = 0;
};

void change_at_random(Random& random, Model& model, double extent) {
    Entries& entries = model.entries;
    const double choice = random.real(0, 1);
    if (entries.size() < 5 || (choice < 0.15 && entries.size() < 150)) {
        // Numbers are given again, as slots are.
        const int item = random.below(200);
        if (entries.count(item) == 0) model.add(item, random_layer(random), random_box(random, extent));
        return;
    }
    auto chosen = entries.begin();
    std::advance(chosen, random.below(static_cast<int>(entries.size())));
    const int item = chosen->first;
    const Layer layer = chosen->second.layer;
    if (choice < 0.25) return model.remove(item);
    if (choice < 0.28) return model.touch(item);
    if (choice < 0.32) return model.set_kin(item, random.below(4) - 1);
    if (choice < 0.5 && layer != Layer::Static) {
        return model.set_layer(item, layer == Layer::Awake ? Layer::Asleep : Layer::Awake);
    }
    // What sleeps wakes before it moves.
    if (layer == Layer::Asleep) model.set_layer(item, Layer::Awake);
    const Aabb old = chosen->second.box;
    const Vec2 by = random.vector(-1, 1);
    const Aabb box = random.chance(0.3) ? random_box(random, extent) : Aabb{old.lower + by, old.upper + by};
    if (model.entries[item].layer != Layer::Awake || random.chance(0.4)) return model.move(item, box);
    // Most go along with each other.
    const Vec2 way = random.chance(0.8) ? Vec2{3, 2} + random.vector(-0.2, 0.2) : random.vector(-3, 3);
    model.move(item, merged(box, {box.lower + way, box.upper + way}), way);
}

Pairs found(BroadPhase& broad) {
    Pairs pairs;
    for (const ItemPair& pair : broad.find_new_pairs(tasks)) REQUIRE(pairs.emplace(pair.a, pair.b).second);
    return pairs;
}

}  // namespace

TEST_CASE("every new pair is reported once while boxes come, go, move, sleep, wake and are touched") {
    for (const double extent : {4.0, 15.0}) {
        Random random(1);
        Model model;
        for (int round = 0; round < 1'500; ++round) {
            for (int change = random.below(20); change > 0; --change) change_at_random(random, model, extent);
            INFO("extent " << extent << ", round " << round);
            model.search();
            model.check_trees();
            if (random.chance(0.2)) REQUIRE(model.broad.find_new_pairs(tasks).empty());
            model.go_on(random);
        }
        CHECK(model.reported() > 2'000);
        CHECK(model.beside() > 500);
    }
}

TEST_CASE("boxes that keep apart on their ways do so at all times, and others come near along both axes") {
    Random random(3);
    int apart = 0;
    for (int trial = 0; trial < 20'000; ++trial) {
        const auto thing = [&](Vec2 way, double extent) {
            const Vec2 lower = random.vector(-extent, extent);
            const Aabb start{lower, lower + random.vector(0.1, 1)};
            return std::pair(start, merged(start, {start.lower + way, start.upper + way}));
        };
        const Vec2 way_a = random.vector(-8, 8);
        const Vec2 way_b = random.chance(0.2) ? Vec2{} : random.chance(0.5) ? way_a : random.vector(-8, 8);
        const auto [start_a, box_a] = thing(way_a, 2);
        const auto [start_b, box_b] = thing(way_b, 2);
        const bool keeps_apart = keep_apart(box_a, way_a, box_b, way_b);
        REQUIRE(keep_apart(box_b, way_b, box_a, way_a) == keeps_apart);
        apart += keeps_apart && overlap(box_a, box_b) ? 1 : 0;
        // The least gap along each axis at any time, with what rounding may add.
        constexpr double kRounding = 1e-5;
        double least = std::numeric_limits<double>::infinity();
        std::array<double, 2> least_along{least, least};
        for (int i = 0; i <= 1'000; ++i) {
            const double t = i / 1'000.0;
            const auto gap = [&](float low_1, float high_1, float low_2, float high_2, float way_1,
                                 float way_2) {
                const double shift = t * (static_cast<double>(way_1) - static_cast<double>(way_2));
                return std::max(static_cast<double>(low_1) + shift - static_cast<double>(high_2),
                                static_cast<double>(low_2) - static_cast<double>(high_1) - shift);
            };
            const double x =
                gap(start_a.lower.x, start_a.upper.x, start_b.lower.x, start_b.upper.x, way_a.x, way_b.x);
            const double y =
                gap(start_a.lower.y, start_a.upper.y, start_b.lower.y, start_b.upper.y, way_a.y, way_b.y);
            least = std::min(least, std::max(x, y));
            least_along = {std::min(least_along[0], x), std::min(least_along[1], y)};
        }
        if (keeps_apart) REQUIRE(least > -kRounding);
        if (!keeps_apart) {
            // Between two samples a gap changes by less than this.
            REQUIRE(least_along[0] < kRounding + 16.0 / 1'000);
            REQUIRE(least_along[1] < kRounding + 16.0 / 1'000);
        }
    }
    CHECK(apart > 1'000);
}

TEST_CASE("few boxes, on both sides of a group's size, find their pairs") {
    for (const int count : {0, 1, 2, 7, 8, 9, 16, 17, 64, 65}) {
        BroadPhase broad;
        // Each overlaps the next.
        for (int i = 0; i < count; ++i) {
            const auto x = static_cast<float>(i);
            broad.add(i, Layer::Awake, {{x, 0}, {x + 1.5f, 1}});
        }
        Pairs expected;
        for (int i = 0; i + 1 < count; ++i) expected.emplace(i, i + 1);
        CHECK(found(broad) == expected);
        CHECK(found(broad).empty());
    }
}

TEST_CASE("boxes in one place find each other, and the layers count") {
    BroadPhase broad;
    const Aabb box{{0, 0}, {1, 1}};
    Pairs expected;
    for (int i = 0; i < 30; ++i) {
        broad.add(i, kLayers[i % 3], box);
        for (int j = 0; j < i; ++j) {
            if (i % 3 != 0 || j % 3 != 0) expected.emplace(j, i);
        }
    }
    CHECK(found(broad) == expected);
    CHECK(found(broad).empty());
}

TEST_CASE("a static box that moves onto another box is a new pair, wherever that one stands") {
    for (const Layer layer : kLayers) {
        BroadPhase broad;
        broad.add(0, Layer::Static, {{0, 0}, {1, 1}});
        broad.add(1, layer, {{5, 0}, {6, 1}});
        REQUIRE(found(broad).empty());
        broad.move(0, {{5.5f, 0}, {6.5f, 1}});
        CHECK(found(broad).size() == (layer == Layer::Static ? 0 : 1));
    }
}

TEST_CASE("falling asleep and waking is not a new pair") {
    BroadPhase broad;
    for (int i = 0; i < 100; ++i)
        broad.add(i, Layer::Awake,
                  {{0.8f * static_cast<float>(i), 0}, {0.8f * static_cast<float>(i) + 1, 1}});
    REQUIRE(found(broad).size() == 99);
    for (int i = 0; i < 100; ++i) broad.set_layer(i, Layer::Asleep);
    CHECK(found(broad).empty());
    for (int i = 0; i < 100; i += 2) broad.set_layer(i, Layer::Awake);
    CHECK(found(broad).empty());
}

TEST_CASE("a box that was elsewhere between two searches is no new pair") {
    BroadPhase broad;
    broad.add(0, Layer::Awake, {{0, 0}, {1, 1}});
    broad.add(1, Layer::Awake, {{0, 0}, {1, 1}});
    REQUIRE(found(broad).size() == 1);
    broad.move(0, {{9, 9}, {10, 10}});
    broad.move(0, {{0.5f, 0}, {1, 1}});
    CHECK(found(broad).empty());
    broad.move(0, {{9, 9}, {10, 10}});
    CHECK(found(broad).empty());
    broad.move(0, {{0.5f, 0}, {1, 1}});
    CHECK(found(broad).size() == 1);
}

TEST_CASE("pairs are sorted, whatever the order in which boxes were added") {
    Random random(2);
    std::vector<Aabb> boxes;
    std::vector<int> order;
    for (int i = 0; i < 300; ++i) {
        boxes.push_back(random_box(random, 10));
        order.push_back(i);
    }
    std::vector<Pair> first;
    for (int round = 0; round < 20; ++round) {
        BroadPhase broad;
        for (const int i : order) broad.add(i, kLayers[i % 3], boxes[i]);
        std::vector<Pair> pairs;
        for (const ItemPair& pair : broad.find_new_pairs(tasks)) pairs.emplace_back(pair.a, pair.b);
        REQUIRE(std::is_sorted(pairs.begin(), pairs.end()));
        if (round == 0) first = pairs;
        REQUIRE(pairs == first);
        for (int i = 299; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
    }
    CHECK(first.size() > 300);
}

TEST_CASE("boxes that are told all at once, on several threads, make the pairs of boxes told one by one") {
    constexpr int kItems = 600;
    Random random(11);
    BroadPhase one_by_one;
    BroadPhase at_once;
    const auto for_both = [&](auto&& change) {
        change(one_by_one);
        change(at_once);
    };
    for (int i = 0; i < kItems; ++i) {
        const Aabb box = random_box(random, 10);
        const Layer layer = i < 50 ? Layer::Static : Layer::Awake;
        for_both([&](BroadPhase& broad) { broad.add(i, layer, box); });
    }
    std::vector<Aabb> boxes(kItems);
    std::size_t all = 0;
    ChunkedList<int> first_moves;
    for (int round = 0; round < 60; ++round) {
        const Pairs expected = found(one_by_one);
        REQUIRE(found(at_once) == expected);
        all += expected.size();
        // Few, many or all of those awake.
        std::vector<int> moved;
        for (int i = 50; i < kItems; ++i) {
            if (random.below(3) <= round % 3) moved.push_back(i);
        }
        // What has a way is moved again before the search after the next.
        const bool some_go = round % 3 == 1;
        std::vector<Vec2> ways(kItems);
        for (const int i : moved) {
            if (some_go && random.chance(0.7)) ways[i] = random.vector(-1, 1);
            boxes[i] = random_box(random, 10);
            one_by_one.move(i, boxes[i]);
            one_by_one.set_way(i, ways[i]);
        }
        const int count = static_cast<int>(moved.size());
        first_moves.start(count, 16, tasks);
        if (some_go) at_once.make_room_for_ways();
        std::atomic<int> more_ways = 0;
        tasks.parallel_for(count, 16, [&](const Chunk& chunk) {
            ChunkedList<int>::Appender first(first_moves, chunk);
            for (int n = chunk.begin; n < chunk.end; ++n) {
                const int i = moved[n];
                const BroadPhase::Shifted shifted = at_once.shift(i, boxes[i], ways[i]);
                if (shifted.is_first) first.items().push_back(i);
                more_ways += shifted.more_ways;
            }
        });
        at_once.end_shifts(first_moves, more_ways);
        REQUIRE(at_once.tree(Layer::Awake).is_valid());
        REQUIRE(at_once.has_ways() == one_by_one.has_ways());
    }
    CHECK(all > 5'000);
}

TEST_CASE("searching in parts gives what the whole gives") {
    const auto report = [](int parts) {
        Random random(3);
        BroadPhase broad;
        std::vector<ItemPair> all;
        std::vector<ItemPair> found_now;
        std::vector<PairsBeside> beside;
        for (int i = 0; i < 400; ++i) broad.add(i, random_layer(random), random_box(random, 10));
        for (int round = 0; round < 30; ++round) {
            const int groups = broad.start_search(tasks);
            found_now.clear();
            // The last part first: threads end in any order.
            for (int part = parts - 1; part >= 0; --part)
                broad.search(groups * part / parts, groups * (part + 1) / parts, {found_now, beside});
            broad.end_search(found_now);
            all.insert(all.end(), found_now.begin(), found_now.end());
            for (int i = 0; i < 100; ++i) broad.move(random.below(400), random_box(random, 10));
        }
        std::vector<Pair> pairs;
        for (const ItemPair& pair : all) pairs.emplace_back(pair.a, pair.b);
        return pairs;
    };
    const std::vector<Pair> whole = report(1);
    CHECK(whole.size() > 1'000);
    CHECK(report(7) == whole);
}

TEST_CASE("the pairs of a hundred thousand boxes, far from the origin too, are those of a sweep along x") {
    for (const double offset : {0.0, 1e7}) {
        Random random(4);
        BroadPhase broad;
        std::vector<Aabb> boxes;
        for (int i = 0; i < 100'000; ++i) {
            const Position at{offset + random.real(0, 600), offset + random.real(0, 600)};
            boxes.push_back(make_aabb(at, {}, random.vector(0.5, 1.5)));
            broad.add(i, Layer::Awake, boxes.back());
        }
        std::vector<int> by_x(boxes.size());
        for (int i = 0; i < 100'000; ++i) by_x[i] = i;
        std::sort(by_x.begin(), by_x.end(),
                  [&](int a, int b) { return boxes[a].lower.x < boxes[b].lower.x; });
        std::vector<Pair> expected;
        for (std::size_t i = 0; i < by_x.size(); ++i) {
            const Aabb& box = boxes[by_x[i]];
            for (std::size_t j = i + 1; j < by_x.size() && boxes[by_x[j]].lower.x <= box.upper.x; ++j) {
                if (overlap(box, boxes[by_x[j]])) expected.emplace_back(std::minmax(by_x[i], by_x[j]));
            }
        }
        std::vector<Pair> pairs;
        for (const ItemPair& pair : broad.find_new_pairs(tasks)) pairs.emplace_back(pair.a, pair.b);
        std::sort(expected.begin(), expected.end());
        std::sort(pairs.begin(), pairs.end());
        CHECK(pairs.size() > 50'000);
        CHECK(pairs == expected);
    }
}

TEST_CASE("a world in which nothing moved is searched without looking at a group") {
    Random random(5);
    BroadPhase broad;
    for (int i = 0; i < 1'000; ++i) broad.add(i, random_layer(random), random_box(random, 10));
    REQUIRE(broad.find_new_pairs(tasks).size() > 100);
    const auto ordered = [&] {
        std::int64_t sum = 0;
        for (const Layer layer : kLayers) sum += broad.tree(layer).ordered_count();
        return sum;
    };
    const std::int64_t before = ordered();
    std::vector<ItemPair> none;
    CHECK(broad.start_search(tasks) == 0);
    broad.end_search(none);
    CHECK(ordered() == before);
    broad.move(7, {{100, 100}, {101, 101}});
    CHECK(broad.start_search(tasks) == 1);
}

}  // namespace cairn::physics
