// Which of eight pairs of boxes do not meet any more.
#pragma once

#include <cstdint>
#include <span>

#include "base/aabb.h"
#include "base/lanes.h"

namespace cairn::physics {

/// The lanes of which the boxes of both items do not overlap, or keep apart on their ways (broad/box_way.h).
/// Boxes and ways are by item; no ways: all stand. `lanes` has a bit for each lane that is wanted; the others
/// need not name an item.
unsigned parted_lanes(std::span<const Aabb> boxes, std::span<const Vec2> ways,
                      const Lanes<std::int32_t>& item_a, const Lanes<std::int32_t>& item_b, unsigned lanes);

}  // namespace cairn::physics
