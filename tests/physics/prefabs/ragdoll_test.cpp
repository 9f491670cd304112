// Ragdolls: limits while tumbling, rest, scale.
#include <algorithm>
#include <catch2/catch.hpp>

#include <cairn/physics/prefabs/ragdoll.h>

#include "physics/support/resting.h"

namespace cairn::physics {
namespace {

using namespace test;

double worst_excess_deg(World& world, const Ragdoll& ragdoll) {
    double worst = 0;
    for (const JointId id : ragdoll.joints) {
        const Joint joint = world.joint(id).value();
        const auto& def = std::get<RevoluteJointDef>(joint.definition());
        const double angle = static_cast<double>(joint.joint_angle());
        worst = std::max(
            {worst, static_cast<double>(def.lower_rad) - angle, angle - static_cast<double>(def.upper_rad)});
    }
    return worst / static_cast<double>(kPi) * 180;
}

double worst_gap_m(World& world, const Ragdoll& ragdoll) {
    double worst = 0;
    for (const JointId id : ragdoll.joints) {
        worst = std::max(worst, static_cast<double>(world.joint(id)->current_length()));
    }
    return worst;
}

TEST_CASE("a ragdoll that tumbles down stairs keeps its limits, and comes to rest") {
    World world;
    add_ground(world);
    for (int i = 0; i < 8; ++i) {
        add(world, {.type = BodyType::Static, .position_m = {i * 0.6, 0}},
            Box{0.3f, 0.25f * static_cast<float>(8 - i)});
    }
    const Ragdoll ragdoll = create_ragdoll(world, {.position_m = {0, 2.5}, .velocity_m_s = {3, 0}}).value();
    REQUIRE(ragdoll.bodies.size() == kBoneCount);
    double excess = 0;
    double gap = 0;
    for (int i = 0; i < 240; ++i) {
        world.step(kStep_s).value();
        excess = std::max(excess, worst_excess_deg(world, ragdoll));
        gap = std::max(gap, worst_gap_m(world, ragdoll));
    }
    CHECK(excess < 5);
    CHECK(gap < 0.05);
    CHECK(world.body(ragdoll.bone(Bone::Hip))->position().x > 1);
    CHECK(sleeps_within(world, 10));
    CHECK(worst_excess_deg(world, ragdoll) < 2);
}

TEST_CASE("each ragdoll has a group of its own, so that only its own bones do not collide") {
    World world;
    add_ground(world);
    const Ragdoll below = create_ragdoll(world, {.position_m = {0, 0.05}}).value();
    const auto group = [&](const Ragdoll& ragdoll) {
        return world.shape(world.body(ragdoll.bone(Bone::Hip))->shapes().front())->filter().group;
    };
    const Ragdoll other = create_ragdoll(world, {.position_m = {0.1, 2}}).value();
    CHECK(group(below) < 0);
    CHECK(group(other) < 0);
    CHECK(group(below) != group(other));
    CHECK(sleeps_within(world, 12));
}

TEST_CASE("a ragdoll twice as large has four times the mass, and keeps its limits too") {
    World world;
    add_ground(world);
    const Ragdoll small = create_ragdoll(world, {.position_m = {-10, 1}}).value();
    const Ragdoll large = create_ragdoll(world, {.position_m = {10, 1}, .scale = 2}).value();
    const auto mass = [&](const Ragdoll& ragdoll) {
        double sum = 0;
        for (const BodyId bone : ragdoll.bodies) sum += static_cast<double>(world.body(bone)->mass());
        return sum;
    };
    CHECK(mass(large) == Approx(4 * mass(small)).epsilon(1e-4));
    double excess = 0;
    for (int i = 0; i < 300; ++i) {
        world.step(kStep_s).value();
        excess = std::max({excess, worst_excess_deg(world, small), worst_excess_deg(world, large)});
    }
    CHECK(excess < 7);
}

}  // namespace
}  // namespace cairn::physics
