// Loops over runs of blocks, colour by colour, on several threads (docs/adr/010-contact-lanes.md).
// What is of one colour may be worked on at once, whatever its kind: it is one loop. Each loop ends with a
// wait for the slowest, of about half a microsecond, and colours differ in size by a factor of hundreds: a
// body with many neighbours has a colour for each. So small colours that follow one another are worked on by
// one thread, as one loop, in their order. Domains (docs/adr/027-domains.md) share nothing: a thread takes
// all colours of one without waiting for others.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/assert.h"
#include "base/task_pool.h"

namespace cairn::physics {

/// Constraints of one domain of space (world/domains.h) share no moving body with those of another, whatever
/// their colour. All others are of the interface between the domains: where there are none, all are.
inline constexpr int kMostDomains = 8;
inline constexpr int kInterface = 0;  // a domain; the proper ones are 1 up to kMostDomains

struct ColoredRun {
    int color;
    int count;  // of blocks
    int domain = kInterface;
};

/// Calls pass(run, first, count) for parts of all runs. Those of domains come first, domain by domain, and
/// are passed whole, in their order within a domain; after all of them the others, those of a colour after
/// all of the colours before it, and otherwise in any order and at once. A thread takes up to `grain` blocks
/// at once; small colours are not shared. run_at(i), of `count` runs, gives a ColoredRun; of the interface
/// there are at most kMostShared.
template <std::size_t kMostShared, class RunAt, class RunPass>
void for_colored_runs(int count, const RunAt& run_at, int grain, TaskPool& tasks, const RunPass& pass) {
    struct Part {
        const RunAt* run_at;
        const RunPass* pass;
        int first;
        int last;  // of its runs, without it
    };
    const auto run_part = [](const void* context, const Chunk& chunk) noexcept {
        const Part& part = *static_cast<const Part*>(context);
        int at = 0;
        for (int run = part.first; run < part.last; ++run) {
            const int size = (*part.run_at)(run).count;
            const int first = std::max(chunk.begin - at, 0);
            const int last = std::min(chunk.end - at, size);
            if (first < last) (*part.pass)(run, first, last - first);
            at += size;
        }
    };
    const auto run_domains = [](const void* context, const Chunk& chunk) noexcept {
        const Part* const domains = static_cast<const Part*>(context);
        for (int i = chunk.begin; i < chunk.end; ++i) {
            for (int run = domains[i].first; run < domains[i].last; ++run)
                (*domains[i].pass)(run, 0, (*domains[i].run_at)(run).count);
        }
    };
    // Of blocks, some 0.2 us each.
    constexpr int kFewestShared = 32;
    std::array<Part, kMostDomains + kMostShared> parts;
    std::array<ParallelLoop, 1 + kMostShared> loops;
    std::size_t part = 0;
    std::size_t loop = 0;
    int first = 0;
    const auto end_of = [&](const auto& belongs) {
        int last = first;
        while (last < count && belongs(run_at(last))) ++last;
        return last;
    };
    while (first < count && run_at(first).domain != kInterface) {
        CAIRN_ASSERT(part < kMostDomains, "no more domains than there is room for");
        const int domain = run_at(first).domain;
        const int last = end_of([&](const ColoredRun& r) { return r.domain == domain; });
        parts[part++] = {&run_at, &pass, first, last};
        first = last;
    }
    if (part > 0) loops[loop++] = {run_domains, parts.data(), static_cast<int>(part), 1};
    bool last_is_small = false;
    while (first < count) {
        const int color = run_at(first).color;
        const int last = end_of([&](const ColoredRun& r) { return r.color == color; });
        int blocks = 0;
        for (int run = first; run < last; ++run) blocks += run_at(run).count;
        const bool is_small = blocks < kFewestShared;
        if (is_small && last_is_small) {
            parts[part - 1].last = last;
            loops[loop - 1].count += blocks;
            loops[loop - 1].grain = std::max(loops[loop - 1].count, 1);
        } else {
            CAIRN_ASSERT(part < parts.size(), "no more runs than there is room for");
            parts[part] = {&run_at, &pass, first, last};
            loops[loop++] = {run_part, &parts[part], blocks,
                             is_small ? std::max(blocks, 1) : std::min(grain, (blocks + 1) / 2)};
            ++part;
        }
        last_is_small = is_small;
        first = last;
    }
    if (loop > 0) tasks.run_in_order({loops.data(), loop});
}

}  // namespace cairn::physics
