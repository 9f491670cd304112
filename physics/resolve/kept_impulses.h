// Impulses of contacts as they were when the step began, for those between bodies that come to rest in its
// first substep (base/standing.h).
#pragma once

#include <cstdint>
#include <span>

#include "base/lanes.h"
#include "base/motion.h"
#include "resolve/contact_block.h"

namespace cairn::physics {

struct KeptImpulses {
    std::array<Lanes<float>, 2> normal;
    Lanes<float> friction;
};

/// Before the first guess of a step; of each block, beside it.
void keep_impulses(std::span<ContactBlock* const> blocks, std::span<KeptImpulses> kept);

/// After the first substep: bodies that rest by their velocities stand only where more than rounding changed
/// impulses of their contacts. These may shift from one to another and move nothing.
void rouse_shifting(std::span<ContactBlock* const> blocks, std::span<const KeptImpulses> kept,
                    Motions& motions);

/// When that was done for all blocks: to contacts of which both bodies rest.
void put_impulses_back(std::span<ContactBlock* const> blocks, std::span<const KeptImpulses> kept,
                       const Motions& motions);

}  // namespace cairn::physics
