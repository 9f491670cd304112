// A restored world goes on as the one that the snapshot was taken from: compared by the bytes of the
// snapshots of both, step for step, which is more than their hashes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "physics/state/state_scenes.h"
#include "physics/support/allocation_counter.h"
#include "state/checksum.h"

namespace cairn::physics {
namespace {

using namespace test;

using Bytes = std::vector<std::byte>;

Bytes bytes_of(const World& world) {
    const Snapshot snapshot = world.snapshot().value();
    return {snapshot.bytes().begin(), snapshot.bytes().end()};
}

// The snapshots before each step.
std::vector<Bytes> run(const Scene& scene, World& world, int steps) {
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

// Bytes are long; what differs first is enough to know.
std::string difference(const Bytes& a, const Bytes& b) {
    if (a == b) return "none";
    constexpr std::ptrdiff_t kFrame = 32;  // holds the checksum, which differs too
    const auto [at, other] = std::mismatch(a.begin() + kFrame, a.end(), b.begin() + kFrame, b.end());
    return "sizes " + std::to_string(a.size()) + " and " + std::to_string(b.size()) + ", first at byte " +
           std::to_string(at - a.begin());
}

constexpr int kSteps = 150;

}  // namespace

TEST_CASE("restored at every step, ten scenes go on as if nothing had happened") {
    for (const Scene& scene : state_scenes()) {
        World original;
        const std::vector<Bytes> history = run(scene, original, kSteps);
        World other({.gravity_m_s2 = {3, 1}, .substeps = 2});
        for (int step = 0; step < kSteps; ++step) {
            INFO(scene.name << ", step " << step);
            other.restore(history[static_cast<std::size_t>(step)]).value();
            REQUIRE(difference(bytes_of(other), history[static_cast<std::size_t>(step)]) == "none");
            for (int next = step; next < std::min(step + 3, kSteps); ++next) {
                scene.act(other, next);
                other.step(kStep_s).value();
                INFO("after step " << next);
                REQUIRE(difference(bytes_of(other), history[static_cast<std::size_t>(next) + 1]) == "none");
            }
        }
    }
}

}  // namespace cairn::physics
