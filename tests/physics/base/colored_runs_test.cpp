// Runs of blocks in colours: each block once, and each colour after those before it.
#include "base/colored_runs.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/random.h"

namespace cairn::physics {

TEST_CASE("each block of runs in colours is worked on once, when all of the colours before it are done") {
    constexpr std::size_t kMostRuns = 64;
    test::Random random(3);
    for (const int threads : {1, 2, 4}) {
        TaskPool tasks(threads);
        for (int round = 0; round < 200; ++round) {
            std::vector<ColoredRun> runs;
            int color = 0;
            for (int i = random.below(30); i > 0; --i) {
                color += random.chance(0.7) ? 1 : 0;
                runs.push_back({color, random.chance(0.5) ? random.below(4) : random.below(300)});
            }
            std::vector<std::vector<std::atomic<int>>> visits;
            for (const ColoredRun& run : runs) visits.emplace_back(static_cast<std::size_t>(run.count));
            std::vector<std::atomic<int>> left(static_cast<std::size_t>(color) + 1);  // blocks, by colour
            for (const ColoredRun& run : runs) left[static_cast<std::size_t>(run.color)] += run.count;
            std::atomic<int> too_early{0};
            const auto run_at = [&](int run) { return runs[static_cast<std::size_t>(run)]; };
            const int all = static_cast<int>(runs.size());
            for_colored_runs<kMostRuns>(all, run_at, 8, tasks, [&](int run, int first, int count) {
                const auto own = static_cast<std::size_t>(runs[static_cast<std::size_t>(run)].color);
                for (std::size_t before = 0; before < own; ++before) too_early += left[before] != 0 ? 1 : 0;
                for (int i = first; i < first + count; ++i)
                    ++visits[static_cast<std::size_t>(run)][static_cast<std::size_t>(i)];
                left[own] -= count;
            });
            INFO(threads << " threads, round " << round);
            REQUIRE(too_early == 0);
            for (const auto& of_run : visits) {
                for (const auto& visited : of_run) REQUIRE(visited == 1);
            }
        }
    }
}

TEST_CASE(
    "runs of a domain are worked on whole and in their order, and those of none when all domains are done") {
    test::Random random(4);
    for (const int threads : {1, 2, 4}) {
        TaskPool tasks(threads);
        for (int round = 0; round < 100; ++round) {
            std::vector<ColoredRun> runs;
            const int domains = random.below(9);
            for (int domain = 1; domain <= domains; ++domain) {
                for (int color = 0; color < 6; ++color) {
                    if (random.chance(0.8)) runs.push_back({color, random.below(200), domain});
                }
            }
            const std::size_t in_domains = runs.size();
            for (int color = 0; color < 4; ++color) runs.push_back({color, 1 + random.below(100)});
            std::vector<std::atomic<int>> done(runs.size());
            std::atomic<int> wrong{0};
            const auto run_at = [&](int run) { return runs[static_cast<std::size_t>(run)]; };
            const int all = static_cast<int>(runs.size());
            for_colored_runs<8>(all, run_at, 8, tasks, [&](int run, int first, int count) {
                const auto own = static_cast<std::size_t>(run);
                const bool is_shared = own >= in_domains;
                if (!is_shared && (first != 0 || count != runs[own].count)) ++wrong;
                for (std::size_t before = 0; before < own; ++before) {
                    const bool must_be_done = is_shared || runs[before].domain == runs[own].domain;
                    if (must_be_done && done[before] != runs[before].count) ++wrong;
                }
                done[own] += count;
            });
            INFO(threads << " threads, round " << round);
            CHECK(wrong == 0);
            for (std::size_t run = 0; run < runs.size(); ++run) REQUIRE(done[run] == runs[run].count);
        }
    }
}

}  // namespace cairn::physics
