#include "islands/islands.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <vector>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using Groups = std::vector<std::vector<int>>;

Groups resting(Islands& islands, const std::vector<float>& rest_times, float time) {
    Groups groups;
    islands.for_each_resting(rest_times, time, [&](std::span<const int> members) {
        groups.emplace_back(members.begin(), members.end());
    });
    return groups;
}

}  // namespace

TEST_CASE("bodies without links are islands of their own") {
    Islands islands;
    islands.reset(3);
    CHECK(resting(islands, {1, 0, 1}, 0.5f) == Groups{{0}, {2}});
    CHECK_FALSE(islands.together(0, 2));
}

TEST_CASE("one restless body keeps its whole island awake") {
    Islands islands;
    islands.reset(5);
    islands.link(4, 1);
    islands.link(1, 2);
    CHECK(islands.together(2, 4));
    CHECK(resting(islands, {0, 1, 1, 0, 1}, 0.5f) == Groups{{1, 2, 4}});
    CHECK(resting(islands, {0, 1, 0.4f, 0, 1}, 0.5f) == Groups{});
}

TEST_CASE("islands are the connected components of the links, in order of their smallest members") {
    test::Random random(1);
    for (int round = 0; round < 200; ++round) {
        const int count = 1 + random.below(60);
        Islands islands;
        islands.reset(count);
        std::vector<std::vector<int>> neighbours(count);
        for (int links = random.below(count + 10); links > 0; --links) {
            const int a = random.below(count);
            const int b = random.below(count);
            islands.link(a, b);
            neighbours[a].push_back(b);
            neighbours[b].push_back(a);
        }
        std::vector<float> rest_times(count);
        for (float& time : rest_times) time = random.chance(0.9) ? 1 : 0;

        // The second implementation: flood fill from each body that is not in a component yet.
        Groups expected;
        std::vector<bool> seen(count, false);
        for (int start = 0; start < count; ++start) {
            if (seen[start]) continue;
            std::vector<int> component{start};
            seen[start] = true;
            for (std::size_t i = 0; i < component.size(); ++i) {
                for (const int next : neighbours[component[i]]) {
                    if (!seen[next]) component.push_back(next);
                    seen[next] = true;
                }
            }
            std::sort(component.begin(), component.end());
            const bool rests = std::all_of(component.begin(), component.end(),
                                           [&](int body) { return rest_times[body] >= 0.5f; });
            if (rests) expected.push_back(component);
        }
        REQUIRE(resting(islands, rest_times, 0.5f) == expected);
    }
}

}  // namespace cairn::physics
