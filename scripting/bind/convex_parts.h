// What an author draws as one polygon may have dents and many corners; what the physics takes is convex and
// has at most eight. Invariant: the parts cover the drawn outline, and nothing else, without overlapping.
#pragma once

#include <span>
#include <vector>

#include <cairn/physics/math.h>
#include <cairn/physics/result.h>

namespace cairn::scripting {

inline constexpr std::size_t kMostOutlineCorners = 256;

/// The outline's corners in order, either way round. One that the physics takes as it is comes back alone and
/// unchanged; so does one with fewer than three corners, about which the physics has its own words. An error
/// for an outline that crosses itself, and for one of more than kMostOutlineCorners.
physics::Result<std::vector<std::vector<physics::Vec2>>> convex_parts(std::span<const physics::Vec2> outline);

}  // namespace cairn::scripting
