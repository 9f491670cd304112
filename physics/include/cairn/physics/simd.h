// Which SIMD instructions the solver uses. The best that the processor has, unless told otherwise; the
// results are the same bits at every level.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <cairn/physics/result.h>

namespace cairn::physics {

enum class SimdLevel : std::uint8_t {
    Scalar,
    Sse4,  ///< 4 lanes
    Avx2,  ///< 8 lanes
    Neon,  ///< 4 lanes
};

/// "scalar", "sse4", "avx2" or "neon".
std::string_view name(SimdLevel level);

/// What this program and this processor can do, the slowest first.
std::vector<SimdLevel> available_simd_levels();

/// For tests and measurements: every world of the process uses this level from now on. Not while a world
/// steps. An error for a level that is not available.
Result<void> force_simd_level(SimdLevel level);

}  // namespace cairn::physics
