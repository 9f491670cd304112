// Which body of a contact stands on which, and at what places: what the statics estimate needs of a block, in
// a third of its memory, and what it says.
#pragma once

#include <cstdint>

#include <cairn/physics/math.h>

#include "resolve/contact_block.h"

namespace cairn::physics {

/// Contacts steeper than this do not bear, in the statics estimate: cosine between normal and gravity, 8
/// degrees. On steeper ones friction and wedging decide, of which it knows nothing; with 60 degrees heaps
/// were seen to tremble.
inline constexpr float kBearing = 0.99f;
/// The same in lanes where both bodies may be moved: 2 degrees. With 8 columns that lean on a wall were seen
/// to sway on.
inline constexpr float kBearingBetween = 0.9994f;
/// Slopes of what does not move bear down to this cosine, 60 degrees, what touches nothing else: there is
/// nothing to wedge.
inline constexpr float kSlope = 0.5f;

/// Places are along the horizontal, from the centre of mass, scaled as arms are.
struct alignas(32) SupportLanes {
    Lanes<std::int32_t> upper;   // row of the body borne; that of the world when nothing is borne here
    Lanes<std::int32_t> lower;   // row of the body that bears it; that of the world when it has no weight
    Lanes<std::int32_t> points;  // 1 or 2
    Lanes<float> steepness;  // cosine between the normal and the upward direction; below kBearing: a slope
    std::array<Lanes<float>, 2> x;        // of the points, seen from the body borne
    std::array<Lanes<float>, 2> x_below;  // from the other
    std::array<Lanes<float>, 2> impulse;  // N s, the estimate: 0 at first
};

/// `up` has length 1.
void find_supports(const ContactBlock& block, BlockKind kind, Vec2 up, SupportLanes& out);

}  // namespace cairn::physics
