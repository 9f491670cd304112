// Snapshots as lists of bytes, to be kept, compared and damaged.
#pragma once

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "physics/support/scenes.h"
#include "state/checksum.h"

namespace cairn::physics::test {

using Bytes = std::vector<std::byte>;

inline constexpr std::size_t kFrame = 32;  // the checksum is its last word

inline Bytes copy_of(std::span<const std::byte> bytes) {
    return {bytes.begin(), bytes.end()};
}

inline Bytes bytes_of(const World& world) {
    return copy_of(world.snapshot().value().bytes());
}

/// The snapshots before each step, and after the last.
inline std::vector<Bytes> run(const Scene& scene, World& world, int steps) {
    std::vector<Bytes> history;
    scene.build(world);
    for (int step = 0; step < steps; ++step) {
        history.push_back(bytes_of(world));
        scene.act(world, step);
        world.step(kStep_s).value();
    }
    history.push_back(bytes_of(world));
    return history;
}

/// Bytes are long; what differs first is enough to know.
inline std::string difference(const Bytes& a, const Bytes& b) {
    if (a == b) return "none";
    const auto frame = static_cast<std::ptrdiff_t>(kFrame);  // its checksum differs too
    const auto [at, other] = std::mismatch(a.begin() + frame, a.end(), b.begin() + frame, b.end());
    return "sizes " + std::to_string(a.size()) + " and " + std::to_string(b.size()) + ", first at byte " +
           std::to_string(at - a.begin());
}

inline void fit_checksum(Bytes& bytes) {
    const std::uint64_t sum = checksum(std::span(bytes).subspan(kFrame));
    std::memcpy(bytes.data() + kFrame - sizeof sum, &sum, sizeof sum);
}

/// Changes some bytes behind the frame, and makes the checksum fit.
inline void make_nonsense(Bytes& bytes, Random& random) {
    for (int changes = random.below(3); changes >= 0; --changes) {
        const auto at =
            kFrame + static_cast<std::size_t>(random.below(static_cast<int>(bytes.size() - kFrame)));
        bytes[at] = static_cast<std::byte>(random.chance(0.3) ? 0xff : random.below(256));
    }
    fit_checksum(bytes);
}

}  // namespace cairn::physics::test
