// Ropes: how long they are, at rest and under load.
#include <catch2/catch.hpp>

#include <cairn/physics/prefabs/rope.h>

#include "physics/support/resting.h"
#include "prefabs/hanging_line.h"

namespace cairn::physics {
namespace {

using namespace test;

double arc_length(World& world, const Rope& rope) {
    double sum = 0;
    for (const JointId id : rope.joints) {
        const Joint joint = world.joint(id).value();
        if (joint.kind() != JointKind::Revolute) continue;
        sum += static_cast<double>(joint.current_length());
    }
    return sum + static_cast<double>(rope.length_m);
}

TEST_CASE("the points of a hanging line are equally far apart, whatever its ends and length") {
    for (const Position to : {Position{5, 0}, Position{-3, 1}, Position{0, -4}, Position{1, 7}}) {
        for (const double slack : {1.0, 1.001, 1.3, 4.0, 50.0}) {
            for (const int count : {2, 3, 20}) {
                const double distance = std::hypot(to.x, to.y);
                const auto points = hanging_line({0, 0}, to, slack * distance, count);
                REQUIRE(points.size() == static_cast<std::size_t>(count + 1));
                for (std::size_t i = 1; i < points.size(); ++i) {
                    CHECK(std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y) ==
                          Approx(slack * distance / count).epsilon(1e-5));
                }
            }
        }
    }
}

TEST_CASE("a rope between two posts hangs as a catenary and sleeps") {
    World world;
    const Rope rope =
        create_rope(world, {.from_m = {0, 5}, .to_m = {4, 5}, .length_m = 6, .links = 40}).value();
    CHECK(sleeps_within(world, 10));
    CHECK(arc_length(world, rope) == Approx(6).epsilon(0.015));
    // Sag of y = a cosh(x / a): 2 a sinh(2 / a) = 6 gives a = 1.2338 and a (cosh(2 / a) - 1) = 2.0101.
    double a = 1;
    for (int i = 0; i < 100; ++i) a = 2 * a * std::sinh(2 / a) > 6 ? a * 1.01 : a * 0.995;
    double lowest = 5;
    for (const BodyId link : rope.links) lowest = std::min(lowest, world.body(link)->position().y);
    CHECK(5 - lowest == Approx(a * (std::cosh(2 / a) - 1)).epsilon(0.05));
}

TEST_CASE("a rope does not stretch under a load of a thousand times its own mass") {
    World world;
    const BodyId load = add(world, {.position_m = {0, -0.5}}, Box{}, {.density_kg_m2 = 500});
    const Rope rope = create_rope(world, {.from_m = {0, 5},
                                          .to_m = {0, 0},
                                          .links = 20,
                                          .to = {.body = load},
                                          .shape = {.filter = {.mask = 0}}})
                          .value();
    run_for(world, 10);
    CHECK(5 - world.body(load)->position().y - 0.5 == Approx(5).epsilon(0.005));
    CHECK(arc_length(world, rope) == Approx(5).epsilon(0.01));
}

TEST_CASE("a free rope falls and comes to rest on the ground") {
    World world;
    add_ground(world);
    const Rope rope =
        create_rope(world, {.from_m = {0, 3}, .to_m = {4, 3}, .from = {.held = false}, .to = {.held = false}})
            .value();
    CHECK(sleeps_within(world, 10));
    for (const BodyId link : rope.links) CHECK(world.body(link)->position().y == Approx(0.04).margin(0.05));
}

}  // namespace
}  // namespace cairn::physics
