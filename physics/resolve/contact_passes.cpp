// Runs go to the kernels, whole or in parts.
#include "resolve/contact_passes.h"

#include <array>

#include "base/assert.h"
#include "resolve/contact_kernels.h"
#include "resolve/contact_lanes.h"

namespace cairn::physics {
namespace {

// What a thread takes at once: enough to be worth a microsecond.
constexpr int kBlocksPerChunk = 24;

constexpr std::size_t kMostRuns = kBuckets;

// Calls pass(run) for parts of all runs.
template <class RunPass>
void in_parts(std::span<const ContactRun> runs, TaskPool& tasks, const RunPass& pass) {
    struct Part {
        const RunPass* pass;
        const ContactRun* run;
    };
    const auto body = [](const void* context, const Chunk& chunk) {
        const Part& part = *static_cast<const Part*>(context);
        const auto first = static_cast<std::size_t>(chunk.begin);
        const auto count = static_cast<std::size_t>(chunk.end - chunk.begin);
        (*part.pass)(ContactRun{part.run->kind, part.run->blocks.subspan(first, count)});
    };
    CAIRN_ASSERT(runs.size() <= kMostRuns, "no more runs than buckets");
    std::array<Part, kMostRuns> parts;
    std::array<ParallelLoop, kMostRuns> loops;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        parts[i] = {&pass, &runs[i]};
        loops[i] = {body, &parts[i], static_cast<int>(runs[i].blocks.size()), kBlocksPerChunk};
    }
    if (!runs.empty()) tasks.run_in_order({loops.data(), runs.size()});
}

}  // namespace

void warm_start(const ContactRun& run, Motions& motions, float step_ratio, float friction_ratio) {
    warm_start_blocks(run.blocks, run.kind, motions.velocity.data(), step_ratio, friction_ratio);
}

void solve(const ContactRun& run, Motions& motions, const ContactRules& rules, float h_s, Pass pass) {
    const Softness& softness =
        run.kind == BlockKind::TwoBodies ? rules.dynamic_softness : rules.static_softness;
    const ContactPassTime time{softness, 1 / h_s, rules.max_push_out_speed_m_s};
    if (pass == Pass::Biased) {
        solve_blocks(run.blocks, run.kind, motions.velocity.data(), time);
    } else {
        relax_blocks(run.blocks, run.kind, motions.velocity.data(), motions.pose.data(), time);
    }
}

void warm_start(std::span<const ContactRun> runs, Motions& motions, float step_ratio, float friction_ratio,
                TaskPool& tasks) {
    in_parts(runs, tasks,
             [&](const ContactRun& run) { warm_start(run, motions, step_ratio, friction_ratio); });
}

void solve(std::span<const ContactRun> runs, Motions& motions, const ContactRules& rules, float h_s,
           Pass pass, TaskPool& tasks) {
    in_parts(runs, tasks, [&](const ContactRun& run) { solve(run, motions, rules, h_s, pass); });
}

}  // namespace cairn::physics
