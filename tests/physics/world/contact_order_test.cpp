// Worlds with so many contacts that these are put in order now and then.
#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using namespace test;

// Boxes poured into a pit, where they roll over each other.
void pour(World& world, int count) {
    add(world, {.type = BodyType::Static, .position_m = {0, -1}}, Box{40, 1});
    for (const double x : {-15.5, 15.5})
        add(world, {.type = BodyType::Static, .position_m = {x, 40}}, Box{0.5f, 40});
    Random random(7);
    for (int i = 0; i < count; ++i) {
        add(world,
            {.position_m = {-14.0 + 0.7 * (i % 40), 0.5 + 0.55 * (i / 40)},
             .angle_rad = random.real(-1, 1),
             .linear_velocity_m_s = random.vector(-3, 3)},
            Box{random.real_f(0.15, 0.3), 0.2f});
    }
}

std::vector<std::uint64_t> hashes_of(World& world, int steps) {
    std::vector<std::uint64_t> hashes;
    for (int step = 0; step < steps; ++step) {
        step_times(world, 1);
        hashes.push_back(world.state_hash());
    }
    return hashes;
}

}  // namespace

TEST_CASE("a crowd goes on alike from before, at and after the step in which its contacts are put in order") {
    World world;
    pour(world, 1500);
    step_times(world, 61);
    REQUIRE(world.counts().contacts > 3000);
    std::vector<Snapshot> snapshots;
    for (int step = 61; step < 68; ++step) {
        snapshots.push_back(world.snapshot().value());
        step_times(world, 1);
    }
    const std::vector<std::uint64_t> after = hashes_of(world, 20);
    for (std::size_t i = 0; i < snapshots.size(); ++i) {
        INFO("from step " << 61 + i);
        World other(WorldDef{.threads = i % 2 == 0 ? 1 : 2});
        other.restore(snapshots[i].bytes()).value();
        step_times(other, static_cast<int>(snapshots.size() - i));
        CHECK(hashes_of(other, 20) == after);
    }
}

}  // namespace cairn::physics
