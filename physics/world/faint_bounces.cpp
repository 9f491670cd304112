// Runs of the blocks that bounce.
#include "world/faint_bounces.h"

#include "base/colored_runs.h"
#include "resolve/restitution_kernel.h"

namespace cairn::physics {
namespace {

// What a thread takes at once.
constexpr int kBlocksPerChunk = 24;

}  // namespace

void bounce_in_lanes(ContactStore& contacts, StepScratch& scratch, const StepTime& time,
                     const ContactRules& rules, TaskPool& tasks) {
    if (!scratch.some_bounce_in_lanes) return;
    ContactLanes& lanes = contacts.lanes;
    std::vector<BouncingBlock>& blocks = scratch.bouncing_blocks;
    blocks.clear();
    blocks.reserve(static_cast<std::size_t>(lanes.pool_size()));
    std::vector<BouncingRun>& runs = scratch.bouncing_runs;
    runs.clear();
    runs.reserve(lanes.buckets().size());
    for (const int bucket : lanes.buckets()) {
        const std::size_t first = blocks.size();
        for (const int block : lanes.blocks(bucket)) {
            if (lanes.block(block).bounces != 0)
                blocks.push_back({&lanes.block(block), lanes.impacts(block)});
        }
        if (blocks.size() == first) continue;
        runs.push_back({bucket, first, blocks.size() - first});
    }
    Motions& motions = scratch.motions;
    const ReboundTime rebound{1 / time.h_s, rules.restitution_speed_m_s};
    const auto run_at = [&](int i) {
        const BouncingRun& run = runs[static_cast<std::size_t>(i)];
        return ColoredRun{color_of(run.bucket), static_cast<int>(run.count), domain_of(run.bucket)};
    };
    const auto give_back = [&](int i, int first, int size) {
        const BouncingRun& run = runs[static_cast<std::size_t>(i)];
        const auto part = std::span<const BouncingBlock>(blocks).subspan(
            run.first + static_cast<std::size_t>(first), static_cast<std::size_t>(size));
        give_back_blocks(part, kind_of(run.bucket), motions.velocity.data(), motions.kick.data(), rebound);
    };
    for_colored_runs<kBucketsOfDomain>(static_cast<int>(runs.size()), run_at, kBlocksPerChunk, tasks,
                                       give_back);
}

}  // namespace cairn::physics
