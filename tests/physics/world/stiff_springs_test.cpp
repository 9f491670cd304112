// Springs beside pins: bounded whatever their stiffness, by either solver, and what hangs on them hangs where
// statics says by the one that the world chooses.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <cairn/physics/simd.h>

#include "physics/support/making.h"
#include "physics/support/precise.h"
#include "resolve/joints/exact_spring.h"

namespace cairn::physics {
namespace {

using namespace test;

using Spring = SpringTone;

// Planks of a metre that pass through each other, pinned end to end.
struct Planks {
    explicit Planks(JointSolver solver, float gravity_m_s2 = 0, int threads = 1)
        : world({.gravity_m_s2 = {0, -gravity_m_s2},
                 .joint_solver = solver,
                 .enable_sleep = false,
                 .threads = threads}) {}

    World world;
    BodyId wall = world.create_body({.type = BodyType::Static}).value();
    std::vector<BodyId> planks;
    std::vector<JointId> joints;

    void plank(Position position_m, double angle_rad, float density) {
        const auto i = static_cast<float>(planks.size());
        planks.push_back(add(world,
                             {.position_m = position_m,
                              .angle_rad = angle_rad,
                              .linear_velocity_m_s = {0, 0.3f * std::sin(1.7f * i)},
                              .angular_velocity_rad_s = 0.5f * std::cos(2.1f * i)},
                             Box{0.5f, 0.1f}, {.density_kg_m2 = density, .filter = {.mask = 0}}));
    }
    void pin(BodyId a, BodyId b, Vec2 at_a, Vec2 at_b, const Spring& spring, float bend_rad = 0) {
        joints.push_back(world
                             .create_joint(RevoluteJointDef{.body_a = a,
                                                            .body_b = b,
                                                            .local_anchor_a_m = at_a,
                                                            .local_anchor_b_m = at_b,
                                                            .local_angle_a_rad = bend_rad,
                                                            .enable_spring = true,
                                                            .frequency_hz = spring.frequency_hz,
                                                            .damping_ratio = spring.damping_ratio})
                             .value());
    }
    [[nodiscard]] double greatest_gap() const {
        double gap = 0;
        for (const JointId id : joints) gap = std::max(gap, d(world.joint(id)->current_length()));
        return gap;
    }
};

void build_row(Planks& row, int count, float ratio, const Spring& spring) {
    for (int i = 0; i < count; ++i) {
        row.plank({i + 0.5, 0}, 0, i % 2 == 0 ? 1 : ratio);
        const BodyId before = i == 0 ? row.wall : row.planks[static_cast<std::size_t>(i) - 1];
        row.pin(before, row.planks.back(), {i == 0 ? 0.0f : 0.5f, 0}, {-0.5f, 0}, spring);
    }
}
void build_single(Planks& row, float ratio, const Spring& spring) {
    build_row(row, 1, ratio, spring);
}
void build_cantilever(Planks& row, float ratio, const Spring& spring) {
    build_row(row, 12, ratio, spring);
}
void build_beam(Planks& row, float ratio, const Spring& spring) {
    build_row(row, 8, ratio, spring);
    row.pin(row.planks.back(), row.wall, {0.5f, 0}, {8, 0}, spring);
}
void build_ring(Planks& ring, float ratio, const Spring& spring) {
    constexpr int kSize = 10;
    constexpr double kBend = 2 * kPiD / kSize;
    const double radius_m = 0.5 / std::tan(kPiD / kSize);
    for (int i = 0; i < kSize; ++i) {
        const double angle = kBend * i;
        ring.plank({radius_m * std::cos(angle), radius_m * std::sin(angle)}, angle + kPiD / 2,
                   i % 2 == 0 ? 1 : ratio);
    }
    for (int i = 0; i < kSize; ++i) {
        ring.pin(ring.planks[static_cast<std::size_t>(i)],
                 ring.planks[static_cast<std::size_t>((i + 1) % kSize)], {0.5f, 0}, {-0.5f, 0}, spring,
                 static_cast<float>(kBend));
    }
}
// Nothing holds it.
void build_floating(Planks& row, float ratio, const Spring& spring) {
    build_row(row, 9, ratio, spring);
    row.world.destroy_joint(row.joints.front()).value();
    row.joints.erase(row.joints.begin());
}
// Pins have no springs, but the middle of each plank stands on one.
void build_pier(Planks& pier, float ratio, const Spring& spring) {
    build_floating(pier, ratio, spring);
    for (const JointId id : pier.joints) pier.world.joint(id)->set_spring(false, 1, 0).value();
    for (std::size_t i = 0; i < pier.planks.size(); ++i) {
        pier.world
            .create_joint(DistanceJointDef{.body_a = pier.wall,
                                           .body_b = pier.planks[i],
                                           .local_anchor_a_m = {static_cast<float>(i) + 0.5f, 1},
                                           .length_m = 1,
                                           .enable_spring = true,
                                           .frequency_hz = spring.frequency_hz,
                                           .damping_ratio = spring.damping_ratio})
            .value();
    }
}
// Some of its pins have no springs, and springs along lines tie what lies two apart.
void build_truss(Planks& truss, float ratio, const Spring& spring) {
    build_row(truss, 7, ratio, spring);
    for (std::size_t i = 1; i < truss.joints.size(); i += 3)
        truss.world.joint(truss.joints[i])->set_spring(false, spring.frequency_hz, 0).value();
    for (std::size_t i = 2; i < truss.planks.size(); ++i) {
        truss.world
            .create_joint(DistanceJointDef{.body_a = truss.planks[i - 2],
                                           .body_b = truss.planks[i],
                                           .local_anchor_a_m = {0, 0.1f},
                                           .local_anchor_b_m = {0, 0.1f},
                                           .length_m = 2,
                                           .enable_spring = true,
                                           .frequency_hz = spring.frequency_hz,
                                           .damping_ratio = spring.damping_ratio})
            .value();
    }
}

struct Pattern {
    const char* name;
    void (*build)(Planks& planks, float ratio, const Spring& spring);
    double most_gain = 1.03;
};
// Springs of the pier that are not stiff, and not damped, have the poles that each would have alone.
constexpr Pattern kPatterns[] = {{"single", build_single},     {"cantilever", build_cantilever},
                                 {"beam", build_beam},         {"ring", build_ring},
                                 {"floating", build_floating}, {"pier", build_pier, 1.1},
                                 {"truss", build_truss}};

// The fastest of the boxes that lie on four planks, welded in a row with springs, in the half second after a
// rod that bears the second one has broken, because one more box has fallen on the last. Up to then the rod
// closes a loop, and the planks are swept.
double fastest_after_brace(float frequency_hz) {
    World world({.enable_sleep = false});
    const BodyId wall = world.create_body({.type = BodyType::Static}).value();
    std::vector<BodyId> planks;
    for (int i = 0; i < 4; ++i) {
        planks.push_back(add(world, {.position_m = {i + 0.5, 0}}, Box{0.5f, 0.1f}));
        world
            .create_joint(WeldJointDef{.body_a = i == 0 ? wall : planks[static_cast<std::size_t>(i) - 1],
                                       .body_b = planks.back(),
                                       .local_anchor_a_m = {i == 0 ? 0.0f : 0.5f, 0},
                                       .local_anchor_b_m = {-0.5f, 0},
                                       .angular_frequency_hz = frequency_hz,
                                       .angular_damping_ratio = 1})
            .value();
    }
    const JointId rod = world
                            .create_joint(DistanceJointDef{.body_a = wall,
                                                           .body_b = planks[1],
                                                           .local_anchor_a_m = {0, 1.2f},
                                                           .length_m = std::hypot(1.5f, 1.2f),
                                                           .strength = {.break_force_n = 400}})
                            .value();
    std::vector<BodyId> boxes;
    for (int i = 0; i < 8; ++i)
        boxes.push_back(
            add(world, {.position_m = {2.1 + 0.22 * i, 0.2}}, Box{0.1f, 0.1f}, {.density_kg_m2 = 8}));
    run_for(world, 5);
    boxes.push_back(add(world, {.position_m = {3.5, 1.2}, .linear_velocity_m_s = {0, -6}}, Box{0.15f, 0.15f},
                        {.density_kg_m2 = 60}));
    double fastest = 0;
    int steps_after = 0;
    for (int i = 0; i < 600 && steps_after < 30; ++i) {
        world.step(kStep_s).value();
        if (world.joint(rod)) continue;
        ++steps_after;
        for (const BodyId box : boxes)
            fastest = std::max(fastest, d(length(world.body(box)->linear_velocity())));
    }
    REQUIRE(steps_after == 30);
    return fastest;
}

}  // namespace

TEST_CASE("springs beside pins give back no more than was put in, however stiff they are") {
    for (const JointSolver solver : {JointSolver::Sweeping, JointSolver::Automatic}) {
        for (const Pattern& pattern : kPatterns) {
            for (const float frequency : {30.0f, 50.0f, 90.0f, 120.0f, 1200.0f, 120000.0f}) {
                for (const float damping_ratio : {0.0f, 0.3f, 2.0f}) {
                    for (const float ratio : {1.0f, 20.0f}) {
                        Planks planks(solver);
                        pattern.build(planks, ratio, {frequency, damping_ratio});
                        const double energy = planks.world.report().kinetic_energy_j;
                        double most = 0;
                        double gap = 0;
                        for (int i = 0; i < 600; ++i) {
                            planks.world.step(kStep_s).value();
                            most = std::max(most, planks.world.report().kinetic_energy_j);
                            gap = std::max(gap, planks.greatest_gap());
                        }
                        INFO((solver == JointSolver::Sweeping ? "swept " : "")
                             << pattern.name << ", " << frequency << " Hz, damping " << damping_ratio
                             << ", 1 : " << ratio);
                        CHECK(most <= pattern.most_gain * energy);
                        CHECK(gap < 0.02);
                    }
                }
            }
        }
    }
}

// What it weighs turns it against the spring alone, whose stiffness is w^2 I about its own centre.
TEST_CASE("a plank on a hinge with a spring hangs as far as it should, and the hinge bears its weight") {
    constexpr float kGravity = 5;
    for (const float frequency : {10.0f, 30.0f, 40.0f, 60.0f, 120.0f, 1200.0f}) {
        for (const float damping_ratio : {0.0f, 0.3f, 1.0f}) {
            INFO(frequency << " Hz, damping " << damping_ratio);
            Planks planks(JointSolver::Automatic, kGravity);
            build_single(planks, 1, {frequency, damping_ratio});
            run_for(planks.world, 30);
            const Body plank = *planks.world.body(planks.planks.front());
            const auto joint = planks.world.joint(planks.joints.front());
            double angle = 0;
            double force = 0;
            double torque = 0;
            constexpr int kSteps = 600;
            for (int i = 0; i < kSteps; ++i) {
                planks.world.step(kStep_s).value();
                angle += plank.angle() / kSteps;
                force += d(joint->reaction_force().y) / kSteps;
                torque += d(joint->reaction_torque()) / kSteps;
            }
            const double weight = d(plank.mass()) * d(kGravity);
            const double w = 2 * kPiD * d(frequency);
            const double stiffness = w * w * d(plank.mass_data().inertia_kg_m2);
            CHECK(angle == Approx(-0.5 * weight / stiffness).epsilon(0.02));
            CHECK(force == Approx(weight).epsilon(1e-3));
            CHECK(torque == Approx(0.5 * weight).epsilon(5e-3));
        }
    }
}

// The first hinge bears all that hangs below it.
TEST_CASE("a hinge with a spring gives way as far as it should to what hangs from it by plain pins") {
    for (const float frequency : {25.0f, 60.0f, 90.0f, 600.0f}) {
        for (const int hanging : {1, 5}) {
            INFO(frequency << " Hz, " << hanging << " hang");
            Planks planks(JointSolver::Automatic, 1);
            build_single(planks, 1, {frequency, 1});
            const double mass = d(planks.world.body(planks.planks.front())->mass());
            const double inertia = d(planks.world.body(planks.planks.front())->mass_data().inertia_kg_m2);
            for (int i = 0; i < hanging; ++i) {
                planks.plank({1, -0.5 - i}, kPiD / 2, 1);
                planks.pin(planks.planks[static_cast<std::size_t>(i)], planks.planks.back(),
                           {i == 0 ? 0.5f : -0.5f, 0}, {0.5f, 0}, {frequency, 1});
                planks.world.joint(planks.joints.back())->set_spring(false, 1, 0).value();
            }
            run_for(planks.world, 60);
            double angle = 0;
            constexpr int kSteps = 600;
            for (int i = 0; i < kSteps; ++i) {
                planks.world.step(kStep_s).value();
                angle += planks.world.body(planks.planks.front())->angle() / kSteps;
            }
            const double w = 2 * kPiD * d(frequency);
            const double torque = mass * (0.5 + hanging);
            CHECK(angle == Approx(-torque / (w * w * inertia)).epsilon(0.02));
        }
    }
}

TEST_CASE("a stiff spring that draws a hinge past its stop stays at the stop, and breaks nothing") {
    for (const float frequency : {60.0f, 300.0f, 3000.0f, 100000.0f}) {
        INFO(frequency << " Hz");
        World world;
        const BodyId wall = world.create_body({.type = BodyType::Static}).value();
        const BodyId plank = add(world, {.position_m = {0.5, 0}}, Box{0.5f, 0.1f});
        const JointId hinge = world
                                  .create_joint(RevoluteJointDef{.body_a = wall,
                                                                 .body_b = plank,
                                                                 .local_anchor_b_m = {-0.5f, 0},
                                                                 .enable_limit = true,
                                                                 .lower_rad = -0.2f,
                                                                 .upper_rad = 0.2f,
                                                                 .enable_spring = true,
                                                                 .frequency_hz = frequency,
                                                                 .damping_ratio = 1,
                                                                 .target_rad = 0.21f})
                                  .value();
        double most_force = 0;
        for (int i = 0; i < 300; ++i) {
            world.step(kStep_s).value();
            most_force = std::max(most_force, d(length(world.joint(hinge)->reaction_force())));
        }
        CHECK(world.body(plank)->angle() == Approx(0.2).margin(0.01));
        CHECK(most_force < 1000);
    }
}

// More than a direct solution takes up, and fewer again.
TEST_CASE("boxes that are laid on a stiff bracket, and taken away, are not thrown") {
    for (const float frequency : {120.0f, 1000.0f, 100000.0f}) {
        INFO(frequency << " Hz");
        World world;
        BodyId last = world.create_body({.type = BodyType::Static}).value();
        for (int i = 0; i < 2; ++i) {
            const BodyId part = add(world, {.position_m = {i + 0.5, 0}}, Box{0.5f, 0.1f});
            world
                .create_joint(WeldJointDef{.body_a = last,
                                           .body_b = part,
                                           .local_anchor_a_m = {i == 0 ? 0.0f : 0.5f, 0},
                                           .local_anchor_b_m = {-0.5f, 0},
                                           .angular_frequency_hz = frequency,
                                           .angular_damping_ratio = 1})
                .value();
            last = part;
        }
        std::vector<BodyId> boxes;
        const auto most_speed = [&](double seconds) {
            float most = 0;
            for (int i = 0; i < static_cast<int>(seconds * 60); ++i) {
                world.step(kStep_s).value();
                for (const BodyId box : boxes)
                    most = std::max(most, length(world.body(box)->linear_velocity()));
            }
            return most;
        };
        for (int i = 0; i < 20; ++i) {
            boxes.push_back(
                add(world, {.position_m = {0.2 + 0.2 * (i % 9), 0.19 + 0.17 * (i / 9)}}, Box{0.08f, 0.08f}));
            CHECK(most_speed(0.5) < 1.5f);
        }
        while (boxes.size() > 8) {
            world.destroy_body(boxes.back()).value();
            boxes.pop_back();
            CHECK(most_speed(0.5) < 1.5f);
        }
    }
}

TEST_CASE("planks that are solved directly when a brace breaks throw boxes no faster the stiffer they are") {
    const double by_soft_springs = fastest_after_brace(34);
    for (const float frequency : {120.0f, 1000.0f, 100000.0f}) {
        INFO(frequency << " Hz");
        CHECK(fastest_after_brace(frequency) <= 1.1 * by_soft_springs);
    }
}

TEST_CASE("planks that are swept for one step fall little, and are as stiff as before within a second") {
    for (const float frequency : {120.0f, 1000.0f, 100000.0f}) {
        INFO(frequency << " Hz");
        Planks planks(JointSolver::Automatic, 10);
        build_row(planks, 4, 1, {frequency, 1});
        run_for(planks.world, 10);
        const BodyId last = planks.planks.back();
        const auto tip_m = [&] { return planks.world.body(last)->position().y; };
        const double before_m = tip_m();
        const Position at = planks.world.body(last)->position();
        // It closes a loop.
        const JointId rod =
            planks.world
                .create_joint(DistanceJointDef{.body_a = planks.wall,
                                               .body_b = last,
                                               .local_anchor_a_m = {0, 1.2f},
                                               .length_m = static_cast<float>(std::hypot(at.x, 1.2 - at.y))})
                .value();
        planks.world.step(kStep_s).value();
        planks.world.destroy_joint(rod).value();
        double lowest_m = before_m;
        for (int i = 0; i < 60; ++i) {
            planks.world.step(kStep_s).value();
            lowest_m = std::min(lowest_m, tip_m());
        }
        CHECK(lowest_m > before_m - 0.05);
        CHECK(tip_m() == Approx(before_m).margin(0.002));
    }
}

// Its stiffness is w^2 m, and gravity stretches it by g/w^2.
TEST_CASE("what never acts on a weight leaves the stiff spring that bears it as it is") {
    constexpr float kFrequency_hz = 300;
    const int beside = GENERATE(0, 1, 2, 3);
    World world({.enable_sleep = false});
    const BodyId ceiling = world.create_body({.type = BodyType::Static, .position_m = {0, 5}}).value();
    const BodyId weight = add(world, {.position_m = {0, 4}}, Circle{{}, 0.2f}, {.density_kg_m2 = 8});
    const JointId spring = world
                               .create_joint(DistanceJointDef{.body_a = ceiling,
                                                              .body_b = weight,
                                                              .length_m = 1,
                                                              .enable_spring = true,
                                                              .frequency_hz = kFrequency_hz,
                                                              .damping_ratio = 1})
                               .value();
    const BodyDef post{.type = BodyType::Static, .position_m = {0.1, 4}};
    if (beside == 1) add(world, post, Circle{{}, 0.2f}, {.sensor = true});
    if (beside == 2) add(world, post, Circle{{}, 0.2f}, {.one_way_normal = {0, 1}});
    if (beside == 3) {
        world.set_pair_filter({[](void*, ShapeId, ShapeId) { return false; }, nullptr});
        add(world, post, Circle{{}, 0.2f});
    }
    run_for(world, 5);
    const double w = 2 * kPiD * d(kFrequency_hz);
    const double sag = d(world.joint(spring)->current_length()) - 1;
    INFO("beside it " << beside);
    CHECK(sag == Approx(10 / (w * w)).epsilon(0.05).margin(1e-7));
}

TEST_CASE("planks on stiff springs go the same way at every SIMD level and on every number of threads") {
    const std::vector<SimdLevel> levels = available_simd_levels();
    for (const JointSolver solver : {JointSolver::Sweeping, JointSolver::Automatic}) {
        for (const Pattern& pattern : kPatterns) {
            std::optional<std::uint64_t> first;
            const auto check = [&](int threads) {
                Planks planks(solver, 1, threads);
                pattern.build(planks, 3, {75, 0.2f});
                step_times(planks.world, 120);
                if (!first) first = planks.world.state_hash();
                CHECK(planks.world.state_hash() == *first);
            };
            for (const SimdLevel level : levels) {
                INFO(pattern.name << " at " << name(level));
                force_simd_level(level).value();
                check(1);
            }
            INFO(pattern.name);
            check(3);
        }
    }
}

}  // namespace cairn::physics
