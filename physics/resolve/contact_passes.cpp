// Runs go to the kernels, whole or in parts.
#include "resolve/contact_passes.h"

#include "base/colored_runs.h"
#include "resolve/contact_kernels.h"
#include "resolve/contact_lanes.h"
#include "resolve/turn_kernel.h"

namespace cairn::physics {
namespace {

// What a thread takes at once: enough to be worth a microsecond.
constexpr int kBlocksPerChunk = 24;

// Calls pass(blocks) for parts of all runs.
template <class PartPass>
void in_parts(std::span<const ContactRun> runs, TaskPool& tasks, const PartPass& pass) {
    const auto run_at = [&](int i) {
        const ContactRun& run = runs[static_cast<std::size_t>(i)];
        return ColoredRun{run.color, static_cast<int>(run.blocks.size()), run.domain};
    };
    for_colored_runs<kBucketsOfDomain>(
        static_cast<int>(runs.size()), run_at, kBlocksPerChunk, tasks, [&](int i, int first, int count) {
            const ContactRun& run = runs[static_cast<std::size_t>(i)];
            const bool are_shared = tasks.threads() > 1 && run.domain == kInterface;
            pass(ContactBlocks{run.blocks.subspan(first, count), run.kind, are_shared});
        });
}

std::uint8_t* standing_rows(Motions& motions, Scope scope) {
    return scope == Scope::Disturbed && !motions.standing.empty() ? motions.standing.data() : nullptr;
}

void warm_start_all(const ContactBlocks& blocks, Motions& motions, float step_ratio, float friction_ratio) {
    warm_start_blocks(blocks, motions.velocity.data(), step_ratio, friction_ratio);
}

void solve_all(ContactBlocks blocks, Motions& motions, const ContactRules& rules, float h_s, Pass pass,
               Scope scope) {
    blocks.standing = standing_rows(motions, scope);
    const Softness& softness =
        blocks.kind == BlockKind::TwoBodies ? rules.dynamic_softness : rules.static_softness;
    const ContactPassTime time{softness, 1 / h_s, rules.max_push_out_speed_m_s};
    if (pass == Pass::Biased) {
        solve_blocks(blocks, motions.velocity.data(), time);
    } else {
        if (motions.some_turn_far) bend_separations(blocks.blocks, blocks.kind, motions.pose.data());
        relax_blocks(blocks, motions.velocity.data(), motions.pose.data(), time);
    }
}

}  // namespace

void warm_start(const ContactRun& run, Motions& motions, float step_ratio, float friction_ratio) {
    warm_start_all({run.blocks, run.kind}, motions, step_ratio, friction_ratio);
}

void solve(const ContactRun& run, Motions& motions, const ContactRules& rules, float h_s, Pass pass,
           Scope scope) {
    solve_all({run.blocks, run.kind}, motions, rules, h_s, pass, scope);
}

void warm_start(std::span<const ContactRun> runs, Motions& motions, float step_ratio, float friction_ratio,
                TaskPool& tasks) {
    in_parts(runs, tasks,
             [&](const ContactBlocks& part) { warm_start_all(part, motions, step_ratio, friction_ratio); });
}

void solve(std::span<const ContactRun> runs, Motions& motions, const ContactRules& rules, float h_s,
           Pass pass, Scope scope, TaskPool& tasks) {
    in_parts(runs, tasks,
             [&](const ContactBlocks& part) { solve_all(part, motions, rules, h_s, pass, scope); });
}

}  // namespace cairn::physics
