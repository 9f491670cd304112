// Heavy bodies on light ones: at rest, dropped, in towers, on structures of joints.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include <cairn/physics/prefabs/bridge.h>
#include <cairn/physics/prefabs/vehicle.h>

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
    const int boxes = GENERATE(2, 5, 10, 20, 60);
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
    // Steps see it at other places before it meets them.
    const double height_m = GENERATE(0.81, 0.88, 0.93, 1.0, 1.03, 1.08, 1.14, 1.2);
    World world;
    add_ground(world);
    const std::vector<BodyId> tower = add_tower(world, boxes, ratio, height_m);
    CAPTURE(ratio, boxes, height_m);
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
    CHECK(fastest < 1.1 * std::sqrt(2 * 10 * height_m));
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

// A board of 1 kg, its upper side at y = 0, and how it is held.
struct Board {
    const char* name;
    std::vector<JointDef> joints;  // of the ground and the board, which get their bodies with the world
};

const std::vector<Board>& boards() {
    const auto on_both_sides = [](const auto& make) {
        return std::vector<JointDef>{make(-1.4f), make(1.4f)};
    };
    static const std::vector<Board> all{
        {"a swing on two rods", on_both_sides([](float x) {
             return DistanceJointDef{
                 .local_anchor_a_m = {x, 3}, .local_anchor_b_m = {x, 0}, .length_m = 3.05f};
         })},
        {"a shelf on two pins", on_both_sides([](float x) {
             return RevoluteJointDef{.local_anchor_a_m = {x, -0.05f}, .local_anchor_b_m = {x, 0}};
         })},
        {"a shelf that is welded to a wall",
         {WeldJointDef{.local_anchor_a_m = {-1.5f, -0.05f}, .local_anchor_b_m = {-1.5f, 0}}}},
    };
    return all;
}

TEST_CASE("a board that hangs on joints bears a load of a thousand times its weight") {
    const Board& board = GENERATE(from_range(boards()));
    const float load_kg = GENERATE(10.0f, 60.0f, 100.0f, 1000.0f);
    CAPTURE(board.name, load_kg);
    World world;
    const BodyId frame = world.create_body({.type = BodyType::Static}).value();
    const BodyId plank =
        add(world, {.position_m = {0, -0.05}}, Box{1.5f, 0.05f}, {.density_kg_m2 = 1 / 0.3f});
    for (JointDef def : board.joints) {
        std::visit(
            [&](auto& d) {
                if constexpr (requires { d.body_a; }) {
                    d.body_a = frame;
                    d.body_b = plank;
                }
            },
            def);
        (void)world.create_joint(def).value();
    }
    const BodyId load = add(world, {.position_m = {0, 0.5}}, Box{}, {.density_kg_m2 = load_kg});
    run_for(world, 8);
    // Ten times its weight are swept, and rods and welds give a little.
    const double sinks_m = load_kg < 50 ? 0.03 : 2e-3;
    CHECK(world.body(load)->position().y > 0.5 - sinks_m);
    CHECK(world.max_penetration_m() < 2e-3f);
    CHECK(world.counts().awake_bodies == 0);
}

TEST_CASE("a table of welds bears what is put on it") {
    World world;
    add_ground(world);
    const BodyId plate = add(world, {.position_m = {0, 1.05}}, Box{1.5f, 0.05f}, {.density_kg_m2 = 3});
    for (const float x : {-1.4f, 1.4f}) {
        const BodyId leg =
            add(world, {.position_m = {static_cast<double>(x), 0.5}}, Box{0.05f, 0.5f}, {.density_kg_m2 = 2});
        (void)world
            .create_joint(WeldJointDef{.body_a = plate,
                                       .body_b = leg,
                                       .local_anchor_a_m = {x, -0.05f},
                                       .local_anchor_b_m = {0, 0.5f}})
            .value();
    }
    const BodyId load = add(world, {.position_m = {0, 1.6}}, Box{}, {.density_kg_m2 = 1000});
    run_for(world, 5);
    CHECK(world.body(load)->position().y == Approx(1.6).margin(2e-3));
    CHECK(world.counts().awake_bodies == 0);
}

TEST_CASE("bridges of any length bear a crate that is dropped onto them, and come to rest") {
    const int planks = GENERATE(8, 12, 16, 20, 40);
    const float crate_kg = GENERATE(60.0f, 300.0f);
    CAPTURE(planks, crate_kg);
    World world;
    const Bridge bridge = create_bridge(world, {.planks = planks}).value();
    const BodyId crate =
        add(world, {.position_m = {5, 0.52}}, Box{0.4f, 0.4f}, {.density_kg_m2 = crate_kg / 0.64f});
    CHECK(sleeps_within(world, 30));
    CHECK(world.max_penetration_m() < 2e-3f);
    CHECK(world.report().max_joint_error_m < 1e-3f);
    // With 1 % more length than the straight way of 10 m it can sag by .71 m.
    const double y = world.body(crate)->position().y;
    CHECK(y > -0.75 + 0.5);
    CHECK(y < 0.5 + 0.1);
}

TEST_CASE("a vehicle carries thirty times the weight of its hull") {
    World world;
    add_ground(world);
    const Vehicle vehicle = create_vehicle(world, {.position_m = {0, 0.6}}).value();
    run_for(world, 2);
    const Position hull = world.body(vehicle.chassis)->position();
    const BodyId load =
        add(world, {.position_m = {hull.x, hull.y + 0.65}}, Box{0.3f, 0.3f}, {.density_kg_m2 = 100 / 0.36f});
    run_for(world, 5);
    const Vec2 on_hull = world.body(load)->position() - world.body(vehicle.chassis)->position();
    // A sweep bears thirty times as much, with some millimetres.
    CHECK(world.max_penetration_m() < 0.01f);
    CHECK(on_hull.y > 0.59f);
}

TEST_CASE("a light box at a wall stops a heavy one that comes at it") {
    const float ratio = GENERATE(60.0f, 1e2f, 1e4f, 1e6f);
    const float speed_m_s = GENERATE(1.0f, 2.5f, 4.47f);
    const double gap_m = GENERATE(0.05, 0.3, 1.0, 1.03);
    CAPTURE(ratio, speed_m_s, gap_m);
    World world({.gravity_m_s2 = {}, .enable_sleep = false});
    add(world, {.type = BodyType::Static, .position_m = {-1, 0}}, Box{1, 10});
    const BodyId light = add(world, {.position_m = {0.5, 0}}, Box{});
    const BodyId heavy = add(world, {.position_m = {1.5 + gap_m, 0}, .linear_velocity_m_s = {-speed_m_s, 0}},
                             Box{}, {.density_kg_m2 = ratio});
    // What both may go into each other within the step in which they meet.
    const double overlap_m = static_cast<double>(speed_m_s * kStep_s);
    for (int i = 0; i < 300; ++i) {
        world.step(kStep_s).value();
        REQUIRE(world.body(light)->position().x > 0.5 - overlap_m);
        REQUIRE(world.body(heavy)->position().x > 1.5 - 2 * overlap_m);
    }
    CHECK(length(world.body(light)->linear_velocity()) < 0.1f);
    CHECK(length(world.body(heavy)->linear_velocity()) < 0.1f);
    // To part them gives the heavy one energy, so where that is all they do they come apart slowly.
    CHECK(static_cast<double>(world.max_penetration_m()) < overlap_m);
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

TEST_CASE("one light link over a post bears heavy ends, too") {
    const float end_kg = GENERATE(1e2f, 1e4f);
    CAPTURE(end_kg);
    World world;
    add(world, {.type = BodyType::Static, .position_m = {0, -2}}, Box{0.1f, 2});
    const BodyId link = add(world, {.position_m = {0, 0.1}}, Box{1, 0.1f}, {.density_kg_m2 = 2.5f});
    for (const float x : {-1.0f, 1.0f}) {
        const BodyId end = add(world, {.position_m = {static_cast<double>(x), -1}}, Box{0.4f, 0.4f},
                               {.density_kg_m2 = end_kg / 0.64f});
        (void)world
            .create_joint(RevoluteJointDef{
                .body_a = link, .body_b = end, .local_anchor_a_m = {x, 0}, .local_anchor_b_m = {0, 1.1f}})
            .value();
    }
    run_for(world, 3);
    CHECK(world.body(link)->position().y > 0.1 - 1e-3);
    CHECK(world.report().max_joint_error_m < 1e-3f);
}

}  // namespace cairn::physics
