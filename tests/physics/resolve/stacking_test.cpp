// Things that stand must stand still.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "physics/support/making.h"
#include "world/prepare.h"

namespace cairn::physics {
namespace {

using namespace test;

std::vector<BodyId> add_stack(World& world, int count, double gap = 0) {
    std::vector<BodyId> boxes;
    for (int i = 0; i < count; ++i)
        boxes.push_back(add(world, {.position_m = {0, 0.5 + i * (1 + gap)}}, Box{0.5f, 0.5f}));
    return boxes;
}

std::vector<Position> centers(World& world, const std::vector<BodyId>& ids) {
    std::vector<Position> result;
    for (const BodyId id : ids) result.push_back(world.body(id)->world_center());
    return result;
}

double farthest_moved(World& world, const std::vector<BodyId>& ids, const std::vector<Position>& from) {
    double farthest = 0;
    for (std::size_t i = 0; i < ids.size(); ++i)
        farthest =
            std::max(farthest, static_cast<double>(length(world.body(ids[i])->world_center() - from[i])));
    return farthest;
}

// Largest distance of any body from where it was after the first two seconds, over the rest of the time.
double trembling(World& world, const std::vector<BodyId>& ids, double time_s) {
    run_for(world, 2);
    const std::vector<Position> settled = centers(world, ids);
    double farthest = 0;
    for (int i = 0; i < static_cast<int>(time_s * 60) - 120; ++i) {
        world.step(kStep_s).value();
        farthest = std::max(farthest, farthest_moved(world, ids, settled));
    }
    return farthest;
}

}  // namespace

TEST_CASE("ten boxes stand for a minute: none moves 1 mm after the first 2 s, and all sleep") {
    World world;
    add_ground(world);
    const std::vector<BodyId> boxes = add_stack(world, 10);
    CHECK(trembling(world, boxes, 60) < 1e-3);
    CHECK(world.counts().awake_bodies == 0);
}

TEST_CASE("ten boxes stand for a minute without sleep and without trembling") {
    World world({.enable_sleep = false});
    add_ground(world);
    const std::vector<BodyId> boxes = add_stack(world, 10);
    CHECK(trembling(world, boxes, 60) < 1e-5);
    float fastest = 0;
    for (const BodyId id : boxes) fastest = std::max(fastest, length(world.body(id)->linear_velocity()));
    CHECK(fastest < 1e-4f);
    CHECK(world.counts().awake_bodies == 10);
}

TEST_CASE("a stack does not sink under its own weight") {
    World world({.enable_sleep = false});
    add_ground(world);
    const std::vector<BodyId> boxes = add_stack(world, 10);
    run_for(world, 20);
    // Rigid bodies stand where they were put; positions are kept to about 1e-7 of the height.
    for (int i = 0; i < 10; ++i)
        CHECK(world.body(boxes[i])->position().y == Approx(0.5 + i).epsilon(0).margin(1e-5));
}

TEST_CASE("towers of 30 and 100 boxes stand upright for a minute, awake") {
    const int height = GENERATE(30, 100);
    World world({.enable_sleep = false});
    add_ground(world);
    const std::vector<BodyId> boxes = add_stack(world, height);
    run_for(world, 60);
    CAPTURE(height);
    CHECK(world.body(boxes.back())->position().y == Approx(height - 0.5).epsilon(0).margin(1e-3));
    CHECK(world.body(boxes.back())->position().x == Approx(0).margin(1e-2));
}

TEST_CASE("a tower of 200 boxes stands for a minute, awake, with its top over its base") {
    World world({.enable_sleep = false});
    add_ground(world);
    const std::vector<BodyId> boxes = add_stack(world, 200);
    run_for(world, 60);
    // It leans more and more, slowly: the noise of the solver is what an upright column multiplies.
    CHECK(world.body(boxes.back())->position().y > 199);
    CHECK(std::fabs(world.body(boxes.back())->position().x) < 0.5);
}

TEST_CASE("towers go to sleep") {
    World world;
    add_ground(world);
    add_stack(world, GENERATE(100, 200));
    run_for(world, 2);
    CHECK(world.counts().awake_bodies == 0);
}

TEST_CASE("the apex of a pyramid of base 40 stays where it is") {
    World world({.enable_sleep = false});
    add_ground(world);
    BodyId apex;
    for (int row = 0; row < 40; ++row) {
        for (int i = row; i < 40; ++i) {
            apex = add(world, {.position_m = {0.5 * (row + 1) + (i - row) - 20, 0.5 + row}}, Box{});
        }
    }
    run_for(world, 10);
    CHECK(world.body(apex)->position().y == Approx(39.5).epsilon(0).margin(1e-3));
}

TEST_CASE("a heavy box rests on a light one, up to a million to one") {
    const float ratio = GENERATE(1e2f, 1e4f, 1e6f);
    World world({.enable_sleep = false});
    add_ground(world);
    const BodyId light = add(world, {.position_m = {0, 0.5}}, Box{});
    const BodyId heavy = add(world, {.position_m = {0, 2}}, Box{1, 1}, {.density_kg_m2 = ratio / 4});
    run_for(world, 10);
    CAPTURE(ratio);
    CHECK(world.body(light)->position().y == Approx(0.5).epsilon(0).margin(1e-3));
    CHECK(world.body(heavy)->position().y == Approx(2).epsilon(0).margin(1e-3));
}

TEST_CASE("a wall of staggered bricks stands") {
    World world({.enable_sleep = false});
    add_ground(world);
    std::vector<BodyId> bricks;
    for (int row = 0; row < 20; ++row) {
        for (int i = 0; i < 10; ++i) {
            bricks.push_back(
                add(world, {.position_m = {i + 0.4 * (row % 2), 0.25 + 0.5 * row}}, Box{0.5f, 0.25f}));
        }
    }
    run_for(world, 20);
    for (int i = 0; i < 200; ++i) {
        CHECK(world.body(bricks[i])->position().y == Approx(0.25 + 0.5 * (i / 10)).epsilon(0).margin(1e-3));
    }
}

TEST_CASE("ten boxes dropped onto each other come to stand") {
    std::vector<double> aside_m;
    for (int gap_cm = 1; gap_cm <= 12; ++gap_cm) {
        CAPTURE(gap_cm);
        World world;
        add_ground(world);
        const std::vector<BodyId> boxes = add_stack(world, 10, 0.01 * gap_cm);
        run_for(world, 10);
        CHECK(world.counts().awake_bodies == 0);
        double farthest_m = 0;
        for (int i = 0; i < 10; ++i) {
            farthest_m = std::max(farthest_m, std::fabs(world.body(boxes[i])->position().x));
            CHECK(world.body(boxes[i])->position().y == Approx(0.5 + i).margin(0.005));
            CHECK(world.body(boxes[i])->angle() == Approx(0).margin(0.01));
        }
        aside_m.push_back(farthest_m);
    }
    // Now and then one rocks when it falls.
    std::sort(aside_m.begin(), aside_m.end());
    CHECK(aside_m[6] < 0.01);
    CHECK(aside_m.back() < 0.06);
}

TEST_CASE("what lands flat lies flat, however fast, and wherever in a step it lands") {
    for (const double speed_m_s : {2.0, 5.0, 10.0, 20.0, 50.0, 200.0}) {
        for (int phase = 0; phase < 50; ++phase) {
            World world({.enable_sleep = false});
            add_ground(world);
            const BodyId box = add(world,
                                   {.position_m = {0, 0.6 + speed_m_s * (1 + 0.02 * phase) / 60},
                                    .linear_velocity_m_s = {0, static_cast<float>(-speed_m_s)}},
                                   Box{0.5f, 0.5f});
            for (int step = 0; step < 30; ++step) {
                step_times(world, 1);
                INFO(speed_m_s << " m/s, phase " << phase << ", step " << step);
                REQUIRE(std::fabs(world.body(box)->angle()) < 1e-5);
                REQUIRE(std::fabs(world.body(box)->position().x) < 1e-5);
            }
            CHECK(world.body(box)->position().y == Approx(0.5).margin(1e-4));
        }
    }
}

TEST_CASE("two bricks on half a one come to rest after a push") {
    for (int i = 0; i < 300; ++i) {
        World world({.enable_sleep = false});
        add_ground(world);
        const float push_m_s = 0.02f + 0.02f * static_cast<float>(i % 10);
        const double left_m = -0.13 + 0.002 * (i / 10);
        const std::array<BodyId, 3> bricks{
            add(world, {.position_m = {0, 0.125}}, Box{0.125f, 0.125f}),
            add(world, {.position_m = {left_m, 0.375}}, Box{0.25f, 0.125f}),
            add(world, {.position_m = {-0.006, 0.625}, .linear_velocity_m_s = {push_m_s, 0}},
                Box{0.25f, 0.125f})};
        run_for(world, 10);
        for (const BodyId brick : bricks) {
            INFO("start " << i);
            CHECK(length(world.body(brick)->linear_velocity()) < 1e-3f);
        }
    }
}

TEST_CASE("a tower of five boxes of different sizes stands") {
    for (const auto& halves :
         {std::array{1.0f, 0.8f, 0.6f, 0.4f, 0.2f}, std::array{0.5f, 0.3f, 0.6f, 0.4f, 0.5f}}) {
        World world({.enable_sleep = false});
        add_ground(world);
        std::vector<BodyId> boxes;
        double height = 0;
        for (const float half : halves) {
            boxes.push_back(
                add(world, {.position_m = {0, height + static_cast<double>(half)}}, Box{half, half}));
            height += 2 * static_cast<double>(half);
        }
        run_for(world, 3);
        CHECK(trembling(world, boxes, 12) < 1e-3);
        for (const BodyId id : boxes) CHECK(world.body(id)->angle() == Approx(0).margin(2e-3));
    }
}

TEST_CASE("a ball rests on a lying capsule, and a capsule on two balls") {
    World world({.enable_sleep = false});
    add(world, {.type = BodyType::Static}, Capsule{{-2, 0}, {2, 0}, 0.5f});
    const BodyId ball = add(world, {.position_m = {0, 1}}, Circle{});
    add(world, {.type = BodyType::Static, .position_m = {10, 0}}, Circle{});
    add(world, {.type = BodyType::Static, .position_m = {12, 0}}, Circle{});
    const BodyId capsule = add(world, {.position_m = {11, 0.75}}, Capsule{{-1.5f, 0}, {1.5f, 0}, 0.25f});
    CHECK(trembling(world, {ball, capsule}, 12) < 1e-3);
    CHECK(world.body(ball)->position().y == Approx(1).margin(0.005));
    CHECK(world.body(capsule)->position().y == Approx(0.75).margin(0.005));
}

TEST_CASE("a bridge of a plank on two posts stands") {
    World world;
    add_ground(world);
    std::vector<BodyId> parts{add(world, {.position_m = {-2, 1}}, Box{0.2f, 1}),
                              add(world, {.position_m = {2, 1}}, Box{0.2f, 1}),
                              add(world, {.position_m = {0, 2.1}}, Box{2.5f, 0.1f})};
    CHECK(trembling(world, parts, 20) < 1e-3);
    CHECK(world.counts().awake_bodies == 0);
}

TEST_CASE("alternating long and short steps give a standing stack no kick") {
    const auto alternate = [](World& world, const std::vector<BodyId>& boxes, auto&& check) {
        run_for(world, 5);
        const std::vector<Position> settled = centers(world, boxes);
        for (int i = 0; i < 300; ++i) {
            world.step(i % 2 == 0 ? 1.0f / 30 : 1.0f / 240).value();
            for (std::size_t box = 0; box < boxes.size(); ++box)
                check(world.body(boxes[box])->world_center() - settled[box]);
        }
    };
    World two({.enable_sleep = false});
    add_ground(two);
    alternate(two, add_stack(two, 2), [](Vec2 moved) { CHECK(length(moved) < 0.005f); });
    World five({.enable_sleep = false});
    add_ground(five);
    alternate(five, add_stack(five, 5), [](Vec2 moved) {
        // It yields more than under even steps, but it stands and nothing is thrown up.
        CHECK(moved.y < 0.005f);
        CHECK(length(moved) < 0.05f);
    });
}

TEST_CASE("a stack of ten stands under gravity of up to 10,000 m/s2") {
    for (const float g : {1e2f, 1e3f, 1e4f}) {
        World world({.gravity_m_s2 = {0, -g}});
        add_ground(world);
        const std::vector<BodyId> boxes = add_stack(world, 10);
        float deepest = 0;
        for (int i = 0; i < 600; ++i) {
            world.step(kStep_s).value();
            deepest = std::max(deepest, world.max_penetration_m());
        }
        INFO("g = " << g);
        CHECK(deepest < 0.005f);
        CHECK(world.body(boxes.back())->position().y == Approx(9.5).margin(0.005));
        CHECK(std::fabs(world.body(boxes.back())->position().x) < 0.001);
    }
}

TEST_CASE("strong gravity gets as many substeps as n = dt sqrt(2 g / slop) asks for") {
    CHECK(substeps_under(10, kStep_s, 4) == 4);
    CHECK(substeps_under(10, kStep_s, 1) == 2);     // 1.05
    CHECK(substeps_under(143, kStep_s, 4) == 4);    // 3.99
    CHECK(substeps_under(145, kStep_s, 4) == 8);    // 4.01
    CHECK(substeps_under(1000, kStep_s, 4) == 16);  // 10.5
    CHECK(substeps_under(1e4f, kStep_s, 4) == 32);  // 33.3
    CHECK(substeps_under(1e30f, kStep_s, 4) == 32);
    CHECK(substeps_under(1e4f, kStep_s, 64) == 64);
    CHECK(substeps_under(0, kStep_s, 3) == 3);
}

}  // namespace cairn::physics
