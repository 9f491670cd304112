// Runs of the blocks that bounce.
#include "world/faint_bounces.h"

#include <array>

#include "base/colored_runs.h"
#include "resolve/restitution_kernel.h"

namespace cairn::physics {
namespace {

// What a thread takes at once.
constexpr int kBlocksPerChunk = 24;

// Those of a bucket.
struct Bouncing {
    BlockKind kind;
    std::size_t first;
};

}  // namespace

void bounce_in_lanes(ContactStore& contacts, StepScratch& scratch, const StepTime& time,
                     const ContactRules& rules, TaskPool& tasks) {
    if (!scratch.some_bounce_in_lanes) return;
    ContactLanes& lanes = contacts.lanes;
    std::vector<BouncingBlock>& blocks = scratch.bouncing_blocks;
    blocks.clear();
    blocks.reserve(static_cast<std::size_t>(lanes.pool_size()));
    std::array<ColoredRun, kBuckets> runs;
    std::array<Bouncing, kBuckets> bouncing;
    std::size_t count = 0;
    for (const int bucket : lanes.buckets()) {
        const std::size_t first = blocks.size();
        for (const int block : lanes.blocks(bucket)) {
            if (lanes.block(block).bounces != 0)
                blocks.push_back({&lanes.block(block), lanes.impacts(block)});
        }
        if (blocks.size() == first) continue;
        runs[count] = {color_of(bucket), static_cast<int>(blocks.size() - first)};
        bouncing[count++] = {kind_of(bucket), first};
    }
    Motions& motions = scratch.motions;
    const ReboundTime rebound{1 / time.h_s, rules.restitution_speed_m_s};
    const auto give_back = [&](int run, int first, int size) {
        const Bouncing& of_run = bouncing[static_cast<std::size_t>(run)];
        const auto part = std::span<const BouncingBlock>(blocks).subspan(
            of_run.first + static_cast<std::size_t>(first), static_cast<std::size_t>(size));
        give_back_blocks(part, of_run.kind, motions.velocity.data(), motions.kick.data(), rebound);
    };
    for_colored_runs<kBuckets>({runs.data(), count}, kBlocksPerChunk, tasks, give_back);
}

}  // namespace cairn::physics
