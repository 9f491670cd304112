// Worlds with so many contacts or joints that these are put in order now and then.
#include <array>
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

// Rows of rods that hang from a ceiling; every other one is driven at its second joint.
class HangingRods {
  public:
    static constexpr int kRods = 4;

    HangingRods(World& world, int rows) : world_(world), ceiling_(add(world, {}, Box{200, 0.5f})) {
        for (int row = 0; row < rows; ++row) {
            rods_.emplace_back();
            for (int i = 0; i < kRods; ++i)
                rods_.back()[i] = add(world, {.position_m = {0.5 * row, -1.5 - i}}, Box{0.02f, 0.4f});
            join(row);
        }
    }

    /// Joins every third row anew, so that its joints take the last lanes.
    void rejoin() {
        for (std::size_t row = 0; row < rods_.size(); row += 3) {
            for (const JointId joint : joints_[row]) world_.destroy_joint(joint).value();
            join(static_cast<int>(row));
        }
    }

  private:
    void join(int row) {
        joints_.resize(rods_.size());
        for (int i = 0; i < kRods; ++i) {
            RevoluteJointDef def{.body_a = i == 0 ? ceiling_ : rods_[row][i - 1],
                                 .body_b = rods_[row][i],
                                 .local_anchor_a_m = {0, -0.5f},
                                 .local_anchor_b_m = {0, 0.5f}};
            if (i == 0) def.local_anchor_a_m = {0.5f * static_cast<float>(row), -1};
            def.enable_motor = i == 1 && row % 2 == 0;
            def.motor_speed_rad_s = 3;
            def.max_motor_torque_nm = 2;
            joints_[row][i] = world_.create_joint(def).value();
        }
    }

    World& world_;
    BodyId ceiling_;
    std::vector<std::array<BodyId, kRods>> rods_;
    std::vector<std::array<JointId, kRods>> joints_;
};

// Of a world that has made 61 steps: a snapshot of each of the next, over the 64th, goes on as the world did.
void check_goes_on_alike(World& world) {
    std::vector<Snapshot> snapshots;
    for (int step = 61; step < 68; ++step) {
        snapshots.push_back(world.snapshot().value());
        step_times(world, 1);
    }
    const std::vector<std::uint64_t> after = hashes_of(world, 20);
    for (std::size_t i = 0; i < snapshots.size(); i += 2) {
        INFO("from step " << 61 + i);
        World other(WorldDef{.threads = i % 4 == 0 ? 1 : 2});
        other.restore(snapshots[i].bytes()).value();
        step_times(other, static_cast<int>(snapshots.size() - i));
        CHECK(hashes_of(other, 20) == after);
    }
}

}  // namespace

TEST_CASE("a crowd goes on alike from before, at and after the step in which its contacts are put in order") {
    World world;
    pour(world, 1500);
    step_times(world, 61);
    check_goes_on_alike(world);
    CHECK(world.counts().contacts > 3000);
}

TEST_CASE("rods go on alike from before, at and after the step in which their joints are put in order") {
    World world;
    HangingRods rods(world, 400);
    step_times(world, 60);
    rods.rejoin();
    step_times(world, 1);
    check_goes_on_alike(world);
    CHECK(world.counts().joints == 1600);
}

}  // namespace cairn::physics
