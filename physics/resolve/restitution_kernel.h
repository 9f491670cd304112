// Impacts that bounce in their lanes: as apply_restitution does it for contacts in plain form, eight at once.
#pragma once

#include <span>

#include "base/motion.h"
#include "resolve/contact_block.h"

namespace cairn::physics {

/// What the kernel needs to know of a step.
struct ReboundTime {
    float inverse_h_1_s = 0;  // of a substep
    float slow_m_s = 0;       // what closes more slowly does not bounce
};

struct BouncingBlock {
    ContactBlock* contacts;
    const ImpactLanes* impacts;
};

/// Gives the lanes that bounce and have met their share of the closing velocity back. Once, after the last
/// substep. Their impulses are forgotten. The blocks are of one colour and kind. `kick`: what forces do to
/// velocities in a substep, by row.
void give_back_blocks(std::span<const BouncingBlock> blocks, BlockKind kind, VelocityRow* velocity,
                      const VelocityRow* kick, const ReboundTime& time);

}  // namespace cairn::physics
