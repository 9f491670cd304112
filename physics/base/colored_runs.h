// Loops over runs of blocks, colour by colour, on several threads (docs/adr/010-contact-lanes.md).
// What is of one colour may be worked on at once, whatever its kind: it is one loop. Each loop ends with a
// wait for the slowest, of about half a microsecond, and colours differ in size by a factor of hundreds: a
// body with many neighbours has a colour for each. So small colours that follow one another are worked on by
// one thread, as one loop, in their order.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "base/assert.h"
#include "base/task_pool.h"

namespace cairn::physics {

struct ColoredRun {
    int color;
    int count;  // of blocks
};

/// Calls pass(run, first, count) for parts of all runs: those of a colour after all of the colours before it,
/// and otherwise in any order and at once. A thread takes up to `grain` blocks at once; small colours are not
/// shared.
template <std::size_t kMostRuns, class RunPass>
void for_colored_runs(std::span<const ColoredRun> runs, int grain, TaskPool& tasks, const RunPass& pass) {
    struct Part {
        const RunPass* pass;
        std::span<const ColoredRun> runs;
        int first_run;
    };
    const auto body = [](const void* context, const Chunk& chunk) noexcept {
        const Part& part = *static_cast<const Part*>(context);
        int at = 0;
        int run = part.first_run;
        for (const ColoredRun& r : part.runs) {
            const int first = std::max(chunk.begin - at, 0);
            const int last = std::min(chunk.end - at, r.count);
            if (first < last) (*part.pass)(run, first, last - first);
            at += r.count;
            ++run;
        }
    };
    // Of blocks, some 0.2 us each.
    constexpr int kFewestShared = 32;
    CAIRN_ASSERT(runs.size() <= kMostRuns, "no more runs than there is room for");
    std::array<Part, kMostRuns> parts;
    std::array<ParallelLoop, kMostRuns> loops;
    std::size_t loop = 0;
    bool last_is_small = false;
    for (std::size_t first = 0; first < runs.size();) {
        std::size_t last = first;
        int count = 0;
        for (; last < runs.size() && runs[last].color == runs[first].color; ++last) count += runs[last].count;
        const bool is_small = count < kFewestShared;
        if (is_small && last_is_small) {
            const auto begin = static_cast<std::size_t>(parts[loop - 1].first_run);
            parts[loop - 1].runs = runs.subspan(begin, last - begin);
            loops[loop - 1].count += count;
            loops[loop - 1].grain = std::max(loops[loop - 1].count, 1);
        } else {
            parts[loop] = {&pass, runs.subspan(first, last - first), static_cast<int>(first)};
            loops[loop] = {body, &parts[loop], count,
                           is_small ? std::max(count, 1) : std::min(grain, (count + 1) / 2)};
            ++loop;
        }
        last_is_small = is_small;
        first = last;
    }
    if (loop > 0) tasks.run_in_order({loops.data(), loop});
}

}  // namespace cairn::physics
