// Springs that share bodies, swept and solved directly: whatever their stiffness, they give back no more than
// was put in, and rest where they should.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include <cairn/physics/simd.h>

#include "physics/support/making.h"
#include "physics/support/precise.h"
#include "resolve/joints/exact_spring.h"

namespace cairn::physics {
namespace {

using namespace test;

using Spring = SpringTone;

// Discs that pass through each other, without gravity.
struct Net {
    explicit Net(JointSolver solver = JointSolver::Sweeping)
        : world({.gravity_m_s2 = {}, .joint_solver = solver, .enable_sleep = false}) {}

    World world;
    std::vector<BodyId> discs;

    void disc(double x, double y, float density, Vec2 velocity) {
        discs.push_back(add(world, {.position_m = {x, y}, .linear_velocity_m_s = velocity}, Circle{{}, 0.2f},
                            {.density_kg_m2 = density, .filter = {.mask = 0}}));
    }

    void tie(int i, int j, const Spring& spring) {
        const BodyId a = discs[static_cast<std::size_t>(i)];
        const BodyId b = discs[static_cast<std::size_t>(j)];
        world
            .create_joint(
                DistanceJointDef{.body_a = a,
                                 .body_b = b,
                                 .length_m = length(world.body(a)->position() - world.body(b)->position()),
                                 .enable_spring = true,
                                 .frequency_hz = spring.frequency_hz,
                                 .damping_ratio = spring.damping_ratio})
            .value();
    }
};

// `ratio` is that of the masses of neighbours.
void build_star(Net& net, float ratio, const Spring& spring) {
    net.disc(0, 0, 1, {0, 1});
    for (int i = 0; i < 8; ++i) {
        net.disc(std::cos(i * kPiD / 4), std::sin(i * kPiD / 4), ratio, {});
        net.tie(0, i + 1, spring);
    }
}
void build_chain(Net& net, int size, float ratio, const Spring& spring) {
    for (int i = 0; i < size; ++i) {
        net.disc(i, 0, i % 2 == 0 ? ratio : 1, {0.3f * static_cast<float>(i % 2), static_cast<float>(i % 3)});
        if (i > 0) net.tie(i - 1, i, spring);
    }
}
void build_series(Net& net, float ratio, const Spring& spring) {
    build_chain(net, 3, ratio, spring);
}
void build_long_chain(Net& net, float ratio, const Spring& spring) {
    build_chain(net, 10, ratio, spring);
}
void build_ring(Net& net, float ratio, const Spring& spring) {
    constexpr int kSize = 9;
    for (int i = 0; i < kSize; ++i) {
        const double angle = 2 * kPiD * i / kSize;
        net.disc(2 * std::cos(angle), 2 * std::sin(angle), i % 2 == 0 ? ratio : 1,
                 {static_cast<float>(i % 3), 0});
        if (i > 0) net.tie(i - 1, i, spring);
    }
    net.tie(kSize - 1, 0, spring);
}
void build_grid(Net& net, float ratio, const Spring& spring) {
    constexpr int kSide = 3;
    for (int i = 0; i < kSide * kSide; ++i) {
        const int x = i % kSide;
        const int y = i / kSide;
        net.disc(x, y, (x + y) % 2 == 0 ? ratio : 1,
                 {static_cast<float>(x - 1), static_cast<float>(x * y % 2)});
        if (x > 0) net.tie(i - 1, i, spring);
        if (y > 0) net.tie(i - kSide, i, spring);
        if (x > 0 && y > 0) net.tie(i - kSide - 1, i, spring);
        if (x + 1 < kSide && y > 0) net.tie(i - kSide + 1, i, spring);
    }
}

struct Pattern {
    const char* name;
    void (*build)(Net& net, float ratio, const Spring& spring);
};
constexpr Pattern kPatterns[] = {{"star", build_star},
                                 {"series", build_series},
                                 {"chain", build_long_chain},
                                 {"ring", build_ring},
                                 {"grid", build_grid}};

// In SIMD lanes, from the second step on.
void build_hub(World& world, const Spring& spring) {
    const ShapeDef ghost{.filter = {.mask = 0}};
    const BodyId hub = add(world, {.angular_velocity_rad_s = 3}, Circle{{}, 0.2f}, ghost);
    for (int i = 0; i < 8; ++i) {
        const BodyId disc = add(world, {}, Circle{{}, 0.2f + 0.02f * static_cast<float>(i)}, ghost);
        world
            .create_joint(RevoluteJointDef{.body_a = i % 2 == 0 ? hub : disc,
                                           .body_b = i % 2 == 0 ? disc : hub,
                                           .enable_spring = true,
                                           .frequency_hz = spring.frequency_hz,
                                           .damping_ratio = spring.damping_ratio})
            .value();
    }
}

double most_kinetic_energy(World& world, int steps) {
    double most = 0;
    for (int i = 0; i < steps; ++i) {
        world.step(kStep_s).value();
        const double energy = world.report().kinetic_energy_j;
        REQUIRE(std::isfinite(energy));
        most = std::max(most, energy);
    }
    return most;
}

}  // namespace

TEST_CASE("springs that share bodies give back no more than was put in, at any stiffness") {
    for (const Pattern& pattern : kPatterns) {
        for (const float ratio : {1.0f, 5.0f, 30.0f}) {
            for (const float frequency : {20.0f, 30.0f, 60.0f, 120.0f, 1200.0f, 120000.0f}) {
                for (const float damping : {0.0f, 0.5f, 1.0f}) {
                    Net net;
                    pattern.build(net, ratio, {frequency, damping});
                    // All springs start at their lengths: this is all the energy that there is.
                    const double energy = net.world.report().kinetic_energy_j;
                    const double early = most_kinetic_energy(net.world, 200);
                    const double late = most_kinetic_energy(net.world, 400);
                    INFO(pattern.name << ", masses 1 : " << ratio << ", " << frequency
                                      << " Hz, damping ratio " << damping);
                    // Velocities are those of half a substep ago, and what is kept is less than their energy:
                    // by W^2/6 of an undamped spring, and by several times that where many share a body.
                    const double room = frequency <= 20 && damping == 0 ? 1.6 : 1.03;
                    CHECK(early <= room * energy);
                    CHECK(late <= room * energy);
                }
            }
        }
    }
}

TEST_CASE("stiff springs that share bodies give back no more than was put in when solved directly") {
    for (const Pattern& pattern : kPatterns) {
        for (const float ratio : {1.0f, 5.0f, 30.0f}) {
            for (const float frequency : {47.0f, 60.0f, 120.0f, 1200.0f, 120000.0f}) {
                for (const float damping : {0.0f, 0.5f, 1.0f}) {
                    Net net(JointSolver::Direct);
                    pattern.build(net, ratio, {frequency, damping});
                    const double energy = net.world.report().kinetic_energy_j;
                    INFO(pattern.name << ", masses 1 : " << ratio << ", " << frequency
                                      << " Hz, damping ratio " << damping);
                    CHECK(most_kinetic_energy(net.world, 600) <= 1.03 * energy);
                }
            }
        }
    }
}

TEST_CASE("soft springs and stiff ones that share bodies give back no more than was put in") {
    for (const float soft : {1.0f, 10.0f, 19.0f}) {
        for (const float stiff : {60.0f, 1200.0f, 120000.0f}) {
            for (const float damping : {0.0f, 0.5f}) {
                Net net;
                build_chain(net, 6, 5, {stiff, damping});
                for (int i = 0; i + 2 < 6; ++i) net.tie(i, i + 2, {soft, 0});
                const double energy = net.world.report().kinetic_energy_j;
                INFO(soft << " Hz and " << stiff << " Hz, damping ratio " << damping);
                CHECK(most_kinetic_energy(net.world, 600) <= 1.05 * energy);
            }
        }
    }
}

TEST_CASE("springs that turn discs on one hub give back no more than was put in") {
    for (const float frequency : {20.0f, 60.0f, 1200.0f, 120000.0f}) {
        for (const float damping : {0.0f, 0.5f, 1.0f}) {
            World world({.gravity_m_s2 = {}, .joint_solver = JointSolver::Sweeping, .enable_sleep = false});
            build_hub(world, {frequency, damping});
            const double energy = world.report().kinetic_energy_j;
            INFO(frequency << " Hz, damping ratio " << damping);
            const double room = frequency <= 20 && damping == 0 ? 1.6 : 1.03;
            CHECK(most_kinetic_energy(world, 600) <= room * energy);
        }
    }
}

TEST_CASE("springs that turn discs on one hub go the same way at every SIMD level") {
    const std::vector<SimdLevel> levels = available_simd_levels();
    std::vector<std::uint64_t> hashes;
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        World world({.gravity_m_s2 = {}, .joint_solver = JointSolver::Sweeping, .enable_sleep = false});
        build_hub(world, {60, 0.5f});
        step_times(world, 60);
        hashes.push_back(world.state_hash());
    }
    force_simd_level(levels.back()).value();
    for (const std::uint64_t hash : hashes) CHECK(hash == hashes.front());
}

TEST_CASE("springs that share a body sag as far as they should together") {
    for (const float frequency : {5.0f, 20.0f, 60.0f, 1200.0f, 120000.0f}) {
        World world({.joint_solver = JointSolver::Sweeping, .enable_sleep = false});
        const BodyId ball = add(world, {.position_m = {0, -2}}, Circle{{}, 0.25f});
        for (int i = 0; i < 2; ++i) {
            const BodyId hook = world.create_body({.type = BodyType::Static}).value();
            world
                .create_joint(DistanceJointDef{.body_a = hook,
                                               .body_b = ball,
                                               .length_m = 2,
                                               .enable_spring = true,
                                               .frequency_hz = frequency,
                                               .damping_ratio = 1})
                .value();
        }
        run_for(world, 3);
        const double w = 2 * kPiD * d(frequency);
        INFO(frequency << " Hz");
        CHECK(-2 - world.body(ball)->position().y == Approx(10 / (2 * w * w)).epsilon(0.02).margin(3e-6));
    }
}

TEST_CASE("balls that hang on each other by stiff springs sag as far as they should") {
    constexpr int kBalls = 3;
    for (const float frequency : {20.0f, 30.0f, 40.0f, 60.0f}) {
        World world({.joint_solver = JointSolver::Sweeping, .enable_sleep = false});
        BodyId last = world.create_body({.type = BodyType::Static}).value();
        const double w = 2 * kPiD * d(frequency);
        double sag = 0;
        for (int i = 1; i <= kBalls; ++i) {
            // Between two equal balls the effective mass is half of one: all springs have the stiffness m
            // w^2.
            const float hz = i == 1 ? frequency : frequency * std::sqrt(2.0f);
            const BodyId ball = add(world, {.position_m = {0, -1.0 * i}}, Circle{{}, 0.25f});
            world
                .create_joint(DistanceJointDef{.body_a = last,
                                               .body_b = ball,
                                               .length_m = 1,
                                               .enable_spring = true,
                                               .frequency_hz = hz,
                                               .damping_ratio = 1})
                .value();
            last = ball;
            sag += (kBalls + 1 - i) * 10 / (w * w);
        }
        run_for(world, 5);
        INFO(frequency << " Hz");
        CHECK(-kBalls - world.body(last)->position().y == Approx(sag).epsilon(0.02));
    }
}

TEST_CASE("a soft spring keeps its frequency beside a stiff one") {
    // Two balls that are as good as one, on an undamped spring.
    World world({.gravity_m_s2 = {}, .joint_solver = JointSolver::Sweeping, .enable_sleep = false});
    const BodyId hook = world.create_body({.type = BodyType::Static}).value();
    const BodyId upper = add(world, {.position_m = {0, -2.1}}, Circle{{}, 0.25f});
    const BodyId lower = add(world, {.position_m = {0, -3.1}}, Circle{{}, 0.25f});
    const float frequency = 2;
    world
        .create_joint(DistanceJointDef{
            .body_a = hook, .body_b = upper, .length_m = 2, .enable_spring = true, .frequency_hz = frequency})
        .value();
    world
        .create_joint(DistanceJointDef{.body_a = upper,
                                       .body_b = lower,
                                       .length_m = 1,
                                       .enable_spring = true,
                                       .frequency_hz = 1200,
                                       .damping_ratio = 1})
        .value();
    std::vector<double> crossings;
    double before = 0.1;
    for (int i = 1; crossings.size() < 9; ++i) {
        REQUIRE(i < 3000);
        world.step(kStep_s).value();
        const double now = -2 - world.body(upper)->position().y;
        if (before > 0 && now <= 0) crossings.push_back((i - 1 + before / (before - now)) / 60);
        before = now;
    }
    // Twice the mass.
    CHECK(8 / (crossings.back() - crossings.front()) == Approx(d(frequency) / std::sqrt(2.0)).epsilon(1e-2));
}

}  // namespace cairn::physics
