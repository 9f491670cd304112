// Grids of pins, which have too many loops to be solved directly.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/precise.h"

namespace cairn::physics {
namespace {

using namespace test;

// Discs a metre apart, pinned half-way between. Three in the middle of the top row are held.
struct Grid {
    static constexpr int kSide = 24;
    World world;
    std::vector<BodyId> held;
    std::vector<BodyId> free;
    std::vector<JointId> holding;  // pins between the two
    double mass_kg = 0;            // of what is free

    explicit Grid(JointSolver solver = JointSolver::Automatic)
        : world({.joint_solver = solver, .enable_sleep = false}) {
        std::vector<BodyId> above;
        for (int row = 0; row < kSide; ++row) {
            std::vector<BodyId> discs;
            for (int column = 0; column < kSide; ++column) {
                const bool is_held = is_at_hook(row, column);
                discs.push_back(add(world,
                                    {.type = is_held ? BodyType::Static : BodyType::Dynamic,
                                     .position_m = {1.0 * column, -1.0 * row}},
                                    Circle{{}, 0.4f}, {.filter = {.group = -1}}));
                (is_held ? held : free).push_back(discs.back());
                if (!is_held) mass_kg += d(world.body(discs.back())->mass());
                if (row > 0) {
                    const bool holds = is_at_hook(row - 1, column);
                    pin(above[static_cast<std::size_t>(column)], discs.back(), {0, -0.5f}, holds);
                }
                if (column > 0 && !(is_held && is_at_hook(row, column - 1))) {
                    const bool holds = is_held || is_at_hook(row, column - 1);
                    pin(discs[static_cast<std::size_t>(column) - 1], discs.back(), {0.5f, 0}, holds);
                }
            }
            above = std::move(discs);
        }
    }

    static bool is_at_hook(int row, int column) { return row == 0 && column >= 11 && column <= 13; }

    void pin(BodyId a, BodyId b, Vec2 arm, bool holds) {
        const JointId id =
            world
                .create_joint(RevoluteJointDef{
                    .body_a = a, .body_b = b, .local_anchor_a_m = arm, .local_anchor_b_m = -arm})
                .value();
        if (holds) holding.push_back(id);
    }

    // Of all joints, over all steps.
    double worst_gap(int steps) {
        double worst = 0;
        for (int i = 0; i < steps; ++i) {
            world.step(kStep_s).value();
            worst = std::max(worst, d(world.report().max_joint_error_m));
        }
        return worst;
    }
};

}  // namespace

TEST_CASE("a grid of pins hangs from its first step on as if nothing gave") {
    Grid swept(JointSolver::Sweeping);
    Grid grid;
    const double gap_swept = swept.worst_gap(120);
    const double gap = grid.worst_gap(120);
    INFO(gap_swept << " m swept, " << gap << " m");
    CHECK(gap < 0.1 * gap_swept);
    CHECK(gap < 0.005);  // not to be seen
}

TEST_CASE("the pins that hold a grid bear its weight") {
    Grid grid;
    double weight_n = 0;
    constexpr int kSteps = 240;
    for (int i = 0; i < kSteps; ++i) {
        grid.world.step(kStep_s).value();
        for (const JointId id : grid.holding) {
            const Joint joint = *grid.world.joint(id);
            // The reaction is on b: up, where the grid hangs on a, and down, where it hangs on b.
            const bool holds_b = std::ranges::find(grid.held, joint.body_a()) != grid.held.end();
            weight_n += (holds_b ? 1 : -1) * d(joint.reaction_force().y) / kSteps;
        }
    }
    CHECK(weight_n == Approx(10 * grid.mass_kg).epsilon(0.01));
}

TEST_CASE("a grid that is let go falls freely: its loads push nothing") {
    Grid grid;
    grid.worst_gap(60);
    for (const JointId id : grid.holding) grid.world.destroy_joint(id).value();
    const auto mean = [&] {
        double y = 0, v = 0;
        for (const BodyId id : grid.free) {
            const Body body = *grid.world.body(id);
            y += body.world_center().y / static_cast<double>(grid.free.size());
            v += d(body.linear_velocity().y) / static_cast<double>(grid.free.size());
        }
        return std::pair{y, v};
    };
    const auto [y, v] = mean();
    // What the pins bore they let go of, and open by less than springs that bore it.
    Grid swept(JointSolver::Sweeping);
    CHECK(grid.worst_gap(60) < swept.worst_gap(120));
    CHECK(mean().second == Approx(v - 10).epsilon(1e-3));
    CHECK(mean().first == Approx(y + v - 5).epsilon(1e-2));
}

TEST_CASE("loads that have become wrong do little harm: gravity turns to the side at once") {
    Grid swept(JointSolver::Sweeping);
    Grid grid;
    for (Grid* g : {&swept, &grid}) {
        g->worst_gap(60);
        g->world.set_gravity({10, 0}).value();
    }
    const double gap_swept = swept.worst_gap(240);
    const double gap = grid.worst_gap(240);
    INFO(gap_swept << " m swept, " << gap << " m");
    CHECK(gap < 1.1 * gap_swept);
}

TEST_CASE("a grid restored from a snapshot hangs on to the last bit") {
    Grid grid;
    grid.worst_gap(20);
    const Snapshot snapshot = grid.world.snapshot().value();
    grid.worst_gap(20);
    const auto hash = grid.world.state_hash();
    grid.world.restore(snapshot.bytes()).value();
    grid.worst_gap(20);
    CHECK(grid.world.state_hash() == hash);
}

}  // namespace cairn::physics
