// Heavy bodies on light ones: at rest, dropped, in towers, on structures of joints.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/resting.h"

namespace cairn::physics {
namespace {

using namespace test;

// Boxes of a metre, 1 kg each but the last; a height above where it would stand for that one.
std::vector<BodyId> add_tower(World& world, int boxes, float ratio, double drop_m) {
    std::vector<BodyId> tower;
    for (int i = 0; i < boxes; ++i) {
        const bool last = i == boxes - 1;
        tower.push_back(add(world, {.position_m = {0, 0.5 + i + (last ? drop_m : 0)}}, Box{},
                            {.density_kg_m2 = last ? ratio : 1}));
    }
    return tower;
}

// How far a box of the tower is below its place, at most.
double deepest(World& world, const std::vector<BodyId>& tower) {
    double deepest = 0;
    for (std::size_t i = 0; i < tower.size(); ++i)
        deepest = std::max(deepest, 0.5 + static_cast<double>(i) - world.body(tower[i])->position().y);
    return deepest;
}

}  // namespace

TEST_CASE("a heavy box stands on a tower of light ones, and falls asleep") {
    const float ratio = GENERATE(1e2f, 1e4f, 1e6f);
    const int boxes = GENERATE(2, 5, 10);
    World world;
    add_ground(world);
    const std::vector<BodyId> tower = add_tower(world, boxes, ratio, 0);
    CAPTURE(ratio, boxes);
    double sunk = 0;
    for (int i = 0; i < 300; ++i) {
        world.step(kStep_s).value();
        sunk = std::max(sunk, deepest(world, tower));
    }
    CHECK(sunk < 2e-3);
    CHECK(world.counts().awake_bodies == 0);
}

TEST_CASE(
    "a heavy box dropped on light ones goes in by less than 25 mm, comes to rest, and throws nothing out") {
    const float ratio = GENERATE(1e2f, 1e4f, 1e6f);
    const int boxes = GENERATE(2, 5);
    World world;
    add_ground(world);
    const std::vector<BodyId> tower = add_tower(world, boxes, ratio, 1);
    CAPTURE(ratio, boxes);
    double sunk = 0;
    double fastest = 0;
    for (int i = 0; i < 600; ++i) {
        world.step(kStep_s).value();
        sunk = std::max(sunk, deepest(world, tower));
        for (const BodyId id : tower)
            fastest = std::max(fastest, static_cast<double>(length(world.body(id)->linear_velocity())));
    }
    CHECK(sunk < 0.025);
    CHECK(deepest(world, tower) < 2e-3);
    CHECK(fastest < 1.1 * std::sqrt(2 * 10 * 1.0));
    CHECK(world.counts().awake_bodies == 0);
}

TEST_CASE("ten boxes, every other one a hundred times heavier, stand for a minute") {
    World world({.enable_sleep = false});
    add_ground(world);
    std::vector<BodyId> tower;
    for (int i = 0; i < 10; ++i) {
        tower.push_back(
            add(world, {.position_m = {0, 0.5 + i}}, Box{}, {.density_kg_m2 = i % 2 == 1 ? 100.0f : 1.0f}));
    }
    run_for(world, 60);
    CHECK(deepest(world, tower) < 2e-3);
    for (const BodyId id : tower) CHECK(std::fabs(world.body(id)->position().x) < 1e-3);
}

TEST_CASE("a heavy disc rolls over light boxes without pressing them into the ground") {
    World world;
    add_ground(world);
    std::vector<BodyId> boxes;
    for (int i = 0; i < 6; ++i)
        boxes.push_back(add(world, {.position_m = {1.01 * i, 0.25}}, Box{0.5f, 0.25f}));
    const BodyId disc = add(world, {.position_m = {0, 1}, .linear_velocity_m_s = {2, 0}}, Circle{{}, 0.5f},
                            {.density_kg_m2 = 5000});
    for (int i = 0; i < 120; ++i) {
        world.step(kStep_s).value();
        for (const BodyId id : boxes) REQUIRE(world.body(id)->position().y > 0.25 - 2e-3);
    }
    // It begins to roll at two thirds of its speed.
    CHECK(world.body(disc)->position().x > 2.6);
}

TEST_CASE("a light link that lies over a post bears the heavy ends of its chain") {
    World world({.enable_sleep = false});
    const BodyId post = add(world, {.type = BodyType::Static, .position_m = {0, -0.1}}, Box{0.1f, 0.1f});
    (void)post;
    // Three links over the post, and a ball of 1,000 times their mass at either end.
    std::vector<BodyId> links;
    for (int i = 0; i < 3; ++i) {
        links.push_back(add(world, {.position_m = {i - 1.0, 0.05}}, Box{0.5f, 0.05f}, {.density_kg_m2 = 10}));
    }
    const auto pin = [&](BodyId a, BodyId b, Vec2 on_a, Vec2 on_b) {
        (void)world
            .create_joint(RevoluteJointDef{
                .body_a = a, .body_b = b, .local_anchor_a_m = on_a, .local_anchor_b_m = on_b})
            .value();
    };
    pin(links[0], links[1], {0.5f, 0}, {-0.5f, 0});
    pin(links[1], links[2], {0.5f, 0}, {-0.5f, 0});
    for (const int side : {-1, 1}) {
        const BodyId ball = add(world, {.position_m = {1.5 * side, -1}}, Circle{{}, 0.3f},
                                {.density_kg_m2 = 1000.0f / 0.2827433f});
        pin(links[side < 0 ? 0 : 2], ball, {0.5f * static_cast<float>(side), 0}, {0, 1.05f});
    }
    double lowest = 1;
    for (int i = 0; i < 120; ++i) {
        world.step(kStep_s).value();
        lowest = std::min(lowest, world.body(links[1])->position().y);
    }
    CHECK(lowest > 0.05 - 1e-3);
}

}  // namespace cairn::physics
