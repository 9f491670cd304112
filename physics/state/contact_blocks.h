// Blocks of contacts as bytes. Of a block only what outlasts a step is written: who is in its lanes, their
// boxes, features and impulses. All else is made anew at the start of each step, before anybody looks at it.
#pragma once

#include "resolve/contact_lanes.h"
#include "state/bytes.h"

namespace cairn::physics {

/// What a block may repeat of the one before it: in stacks of equal boxes it is most of it. Begins anew for
/// each list of blocks.
struct RepeatedParts {
    RepeatedParts() {
        for (auto& lanes : features) lanes.fill(kNoFeature);
    }

    std::array<float, sizeof(BoxLanes) / sizeof(float)> boxes{};
    FeatureLanes features;
};

/// What a block takes: at least what it cannot repeat.
struct BlockBytes {
    std::size_t least;
    std::size_t most;
};
inline constexpr std::size_t kLaneRow = sizeof(Lanes<float>);
/// What it repeats, contact, two shapes, two bytes of bits, two impulses, that of friction, and who touches.
inline constexpr BlockBytes kColoredBlockBytes{
    1 + 6 * kLaneRow + 3, 1 + 6 * kLaneRow + 3 + sizeof(BoxLanes) + sizeof(FeatureLanes)};

/// Lanes from `used` on hold what the last one left there, which means nothing, and are written as empty.
std::byte* put_colored_block(std::byte* at, const PairBlock& pairs, const ContactBlock& block, int used,
                             RepeatedParts& last);

/// False after a fault. Which bodies meet, and with which friction, is left to the caller.
bool read_colored_block(Reader& in, PairBlock& pairs, ContactBlock& block, int used, RepeatedParts& last);

}  // namespace cairn::physics
