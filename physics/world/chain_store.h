// Chains: their points, and the shapes that are their segments.
// Invariant: segment i is the shape from point i to the next one; its shape names the chain back.
#pragma once

#include <optional>
#include <vector>

#include <cairn/physics/chain.h>

#include "base/slot_map.h"

namespace cairn::physics {

struct ChainRecord {
    int body = kNone;
    bool closed = false;
    std::optional<Vec2> before_m;
    std::optional<Vec2> after_m;
    std::vector<Vec2> points_m;
    std::vector<int> segments;
    std::uint64_t user_data = 0;
};

using ChainStore = SlotMap<ChainRecord, ChainId>;

}  // namespace cairn::physics
