// The choice of the SIMD level, by Highway's dispatch.
#include <array>
#include <cstdint>
#include <hwy/highway.h>
#include <string>

#include <cairn/physics/simd.h>

namespace cairn::physics {
namespace {

struct LevelTargets {
    SimdLevel level;
    std::int64_t targets;
};

// Exactly one of the fallbacks is compiled in, depending on the compiler.
constexpr std::array kLevels{LevelTargets{SimdLevel::Scalar, HWY_SCALAR | HWY_EMU128},
                             LevelTargets{SimdLevel::Sse4, HWY_SSE4}, LevelTargets{SimdLevel::Avx2, HWY_AVX2},
                             LevelTargets{SimdLevel::Neon, HWY_NEON}};

// What the processor has, whatever was forced before.
std::int64_t processor_targets() {
    static const std::int64_t targets = hwy::SupportedTargets();
    return targets & HWY_TARGETS;
}

}  // namespace

std::string_view name(SimdLevel level) {
    switch (level) {
        case SimdLevel::Scalar:
            return "scalar";
        case SimdLevel::Sse4:
            return "sse4";
        case SimdLevel::Avx2:
            return "avx2";
        case SimdLevel::Neon:
            return "neon";
    }
    return "unknown";
}

std::vector<SimdLevel> available_simd_levels() {
    std::vector<SimdLevel> available;
    for (const auto& [level, targets] : kLevels) {
        if ((processor_targets() & targets) != 0) available.push_back(level);
    }
    return available;
}

Result<void> force_simd_level(SimdLevel level) {
    for (const auto& [candidate, targets] : kLevels) {
        const std::int64_t usable = processor_targets() & targets;
        if (candidate != level || usable == 0) continue;
        hwy::SetSupportedTargetsForTest(usable);
        hwy::GetChosenTarget().Update(usable);
        return {};
    }
    return Error{"SIMD level '" + std::string(name(level)) + "' is not available on this processor"};
}

}  // namespace cairn::physics
