// Which parts of a level go on when its file has changed.
#pragma once

#include <cstddef>
#include <vector>

#include "level/reader.h"

namespace cairn::scripting {

inline constexpr std::size_t kNoPart = static_cast<std::size_t>(-1);

/// For each part of the level as it is now the part of the one before that says the same and can stay, or
/// kNoPart.
std::vector<std::size_t> match_parts(const Level& before, const Level& now);

}  // namespace cairn::scripting
