// Eight boxes side by side, one array per side, so that a box is compared with all eight at once.
// Invariant: a free lane holds the empty box, which overlaps no finite box and changes no union.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "base/aabb.h"

namespace cairn::physics {

inline constexpr int kGroupSize = 8;

struct alignas(32) BoxGroup {
    using Lanes = std::array<float, kGroupSize>;

    BoxGroup() {
        lower_x.fill(Aabb{}.lower.x);
        lower_y.fill(Aabb{}.lower.y);
        upper_x.fill(Aabb{}.upper.x);
        upper_y.fill(Aabb{}.upper.y);
    }

    [[nodiscard]] Aabb box(int lane) const {
        return {{lower_x[lane], lower_y[lane]}, {upper_x[lane], upper_y[lane]}};
    }
    void set_box(int lane, const Aabb& box) {
        lower_x[lane] = box.lower.x;
        lower_y[lane] = box.lower.y;
        upper_x[lane] = box.upper.x;
        upper_y[lane] = box.upper.y;
    }

    Lanes lower_x, lower_y, upper_x, upper_y;
};

/// Lanes as bits: lane i is bit i.
using LaneMask = std::uint32_t;
inline constexpr LaneMask kAllLanes = (1u << kGroupSize) - 1;

/// The lanes whose boxes overlap the given one.
inline LaneMask overlapping(const BoxGroup& group, const Aabb& box) {
    // Vectors of four are what every processor has, without asking; loops over the lanes are not turned into
    // them.
    using Four [[gnu::vector_size(16)]] = float;
    using Bits [[gnu::vector_size(16)]] = std::int32_t;
    const auto load = [](const float* values) {
        Four four;
        std::memcpy(&four, values, sizeof four);
        return four;
    };
    const auto overlap = [&](int i) -> Bits {
        return (load(&group.lower_x[i]) <= box.upper.x) & (load(&group.upper_x[i]) >= box.lower.x) &
               (load(&group.lower_y[i]) <= box.upper.y) & (load(&group.upper_y[i]) >= box.lower.y);
    };
#if defined(__SSE2__)
    const auto bits = [](Bits lanes) {
        return static_cast<LaneMask>(__builtin_ia32_movmskps(reinterpret_cast<Four>(lanes)));
    };
    return bits(overlap(0)) | bits(overlap(4)) << 4;
#else
    const Bits lanes = (overlap(0) & Bits{1, 2, 4, 8}) | (overlap(4) & Bits{16, 32, 64, 128});
    return static_cast<LaneMask>((lanes[0] | lanes[1]) | (lanes[2] | lanes[3]));
#endif
}

/// The box around all eight.
inline Aabb bounds(const BoxGroup& group) {
    // By halves, which the compiler turns into vectors.
    const auto fold = [](const BoxGroup::Lanes& values, auto&& pick) {
        std::array<float, 4> four;
        for (int i = 0; i < 4; ++i) four[i] = pick(values[i], values[i + 4]);
        return pick(pick(four[0], four[2]), pick(four[1], four[3]));
    };
    const auto least = [](float a, float b) { return a < b ? a : b; };
    const auto greatest = [](float a, float b) { return a > b ? a : b; };
    return {{fold(group.lower_x, least), fold(group.lower_y, least)},
            {fold(group.upper_x, greatest), fold(group.upper_y, greatest)}};
}

}  // namespace cairn::physics
