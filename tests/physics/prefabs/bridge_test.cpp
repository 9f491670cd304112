// A bridge: it stands, it bears, and its ends stay where they are.
#include <catch2/catch.hpp>

#include <cairn/physics/prefabs/bridge.h>

#include "physics/support/resting.h"

namespace cairn::physics {
namespace {

using namespace test;

double lowest(World& world, const Bridge& bridge) {
    double low = 1e9;
    for (const BodyId plank : bridge.planks) low = std::min(low, world.body(plank)->position().y);
    return low;
}

TEST_CASE("a bridge stands under crates, its ends hold, and all sleeps") {
    World world;
    const Bridge bridge = create_bridge(world, {.planks = 20, .slack = 0.01f}).value();
    std::vector<BodyId> crates;
    for (int i = 0; i < 3; ++i) {
        crates.push_back(add(world, {.position_m = {4 + i * 1.0, 1}}, Box{0.4f, 0.4f}, {.density_kg_m2 = 5}));
    }
    CHECK(sleeps_within(world, 15));
    const Joint first = world.joint(bridge.pins.front()).value();
    const Joint last = world.joint(bridge.pins.back()).value();
    CHECK(length(first.anchor_b() - Position{0, 0}) < 0.01f);
    CHECK(length(last.anchor_b() - Position{10, 0}) < 0.01f);
    // A line of 10.1 m that gives by 2 % at most sags by no more than when it is bent at one point.
    CHECK(lowest(world, bridge) > -std::sqrt(5.05 * 1.02 * 5.05 * 1.02 - 25));
    for (const BodyId crate : crates) CHECK(world.body(crate)->position().y > lowest(world, bridge));
    // Both ends together bear all weight.
    double weight = 0;
    for (const BodyId body : world.bodies()) weight += 10.0 * static_cast<double>(world.body(body)->mass());
    const auto lift = [](const Joint& joint) { return static_cast<double>(joint.reaction_force().y); };
    CHECK(lift(first) + lift(last) == Approx(weight).epsilon(0.02));
}

TEST_CASE("a bridge with weak pins breaks under what it cannot bear") {
    World world;
    const Bridge bridge = create_bridge(world, {.strength = {.break_force_n = 2000}}).value();
    run_for(world, 3);
    REQUIRE(world.counts().joints == static_cast<int>(bridge.pins.size()));
    add(world, {.position_m = {5, 1}}, Box{0.5f, 0.5f}, {.density_kg_m2 = 2000});
    run_for(world, 1);
    CHECK(world.counts().joints < static_cast<int>(bridge.pins.size()));
}

}  // namespace
}  // namespace cairn::physics
