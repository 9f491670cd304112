// Impulses kept, compared and put back, lane by lane.
#include "resolve/kept_impulses.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace cairn::physics {
namespace {

// What is unknown when a step begins, less than 0, is something else after it.
bool has_shifted(const ContactBlock& block, const KeptImpulses& before, std::size_t lane,
                 const Motions& motions) {
    const int a = block.a[lane];
    const int b = block.b[lane];
    float most = std::fabs(block.friction_impulse[lane] - before.friction[lane]);
    for (std::size_t k = 0; k < 2; ++k)
        most = std::max(most, std::fabs(block.points[k].impulse[lane] - before.normal[k][lane]));
    const float gained_m_s = most * (motions.velocity[a].inverse_mass + motions.velocity[b].inverse_mass);
    const float rounding_m_s =
        std::max(motions.rounding_m_s[a], 0.0f) + std::max(motions.rounding_m_s[b], 0.0f);
    return !(gained_m_s <= rounding_m_s);
}

// Contacts of other threads may have the same row.
std::uint8_t standing_of(Motions& motions, int row) {
    return std::atomic_ref<std::uint8_t>(motions.standing[row]).load(std::memory_order_relaxed);
}

void rouse(Motions& motions, int row) {
    if (row == kWorldRow || standing_of(motions, row) != kRests) return;
    std::atomic_ref<std::uint8_t>(motions.standing[row]).store(kStands, std::memory_order_relaxed);
}

}  // namespace

void keep_impulses(std::span<ContactBlock* const> blocks, std::span<KeptImpulses> kept) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const ContactBlock& block = *blocks[i];
        kept[i] = {{block.points[0].impulse, block.points[1].impulse}, block.friction_impulse};
    }
}

void rouse_shifting(std::span<ContactBlock* const> blocks, std::span<const KeptImpulses> kept,
                    Motions& motions) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const ContactBlock& block = *blocks[i];
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            if (!has_shifted(block, kept[i], lane, motions)) continue;
            rouse(motions, block.a[lane]);
            rouse(motions, block.b[lane]);
        }
    }
}

void put_impulses_back(std::span<ContactBlock* const> blocks, std::span<const KeptImpulses> kept,
                       const Motions& motions) {
    const std::uint8_t* const standing = motions.standing.data();
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        ContactBlock& block = *blocks[i];
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            if ((standing[block.a[lane]] & standing[block.b[lane]]) != kRests) continue;
            for (std::size_t k = 0; k < 2; ++k) block.points[k].impulse[lane] = kept[i].normal[k][lane];
            block.friction_impulse[lane] = kept[i].friction[lane];
        }
    }
}

}  // namespace cairn::physics
