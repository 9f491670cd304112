// Where there are many impacts, most are in a heap: so many bodies that the groups which are grown from
// impacts (world/impact_groups.h, world/bounce_energy.h) are let go. All heaps are then found at once.
// Whether they are known changes no result.
#pragma once

#include <cstddef>

#include "resolve/contact_lanes.h"

namespace cairn::physics {

/// To grow a group from one impact costs about as much as to look at this many contacts as they stand in
/// memory.
inline constexpr std::size_t kContactsForOneGroup = 512;

inline bool pays_to_find_heaps(std::size_t impacts, const ContactLanes& lanes) {
    return kContactsForOneGroup * impacts >= kLanes * lanes.blocks_in_memory().size();
}

}  // namespace cairn::physics
