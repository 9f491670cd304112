// What separations of contacts in lanes are besides their linear form where bodies turn far. The same bits at
// every SIMD level.
#pragma once

#include <span>

#include "base/motion.h"
#include "resolve/contact_block.h"

namespace cairn::physics {

/// Between integrating positions and the relaxing pass: puts into the start separations of turning lanes what
/// makes the linear form right for the angles that the bodies have turned by. Other blocks are left alone.
void bend_separations(std::span<ContactBlock* const> blocks, BlockKind kind, const PoseRow* pose);

}  // namespace cairn::physics
