// The rules for the points of chains, and the words when they are broken.
#pragma once

#include "base/check.h"
#include "world/world_state.h"

namespace cairn::physics {

check::Fault validate(const ChainDef& def);
check::Fault validate_set_point(const ChainRecord& chain, int index, Vec2 point_m);
check::Fault validate_insert(const ChainRecord& chain, int index, std::span<const Vec2> points_m);
check::Fault validate_remove(const ChainRecord& chain, int first, int count);
check::Fault validate_ends(const ChainRecord& chain, std::optional<Vec2> before_m,
                           std::optional<Vec2> after_m);
check::Fault validate_segment_index(const ChainRecord& chain, int index);

}  // namespace cairn::physics
