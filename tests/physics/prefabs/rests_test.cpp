// What stands, stands still: with sleep off, so that nothing but the solver holds it.
#include <catch2/catch.hpp>

#include <cairn/physics/prefabs/all.h>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

// 1 mm in ten minutes.
constexpr double kStill_m_s = 1e-3 / 600;

// After 15 s.
double creep_m_s(World& world, double watched_s) {
    run_for(world, 15);
    const std::vector<BodyId> bodies = world.bodies();
    std::vector<Position> before;
    for (const BodyId body : bodies) before.push_back(world.body(body)->position());
    run_for(world, watched_s);
    double farthest = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Vec2 way = world.body(bodies[i])->position() - before[i];
        farthest = std::max(farthest, static_cast<double>(length(way)));
    }
    return farthest / watched_s;
}

TEST_CASE("crates on a bridge, level or hanging deep, do not creep down its slopes") {
    for (const float slack : {0.01f, 0.05f}) {
        World world({.enable_sleep = false});
        create_bridge(world, {.slack = slack}).value();
        for (int i = 0; i < 3; ++i)
            add(world, {.position_m = {3.0 + 2 * i, 1}}, Box{0.4f, 0.4f}, {.density_kg_m2 = 5});
        // Crates on their corners give way now and then, by some hundredths of a millimetre.
        CHECK(creep_m_s(world, 60) < kStill_m_s);
    }
}

TEST_CASE("a vehicle with its brakes on does not creep down a slope") {
    World world({.enable_sleep = false});
    add(world, {.type = BodyType::Static, .angle_rad = 0.15}, Box{50, 1, {0, -1}});
    const Vehicle vehicle = create_vehicle(world, {.position_m = {0, 1}}).value();
    brake_vehicle(world, vehicle).value();
    CHECK(creep_m_s(world, 20) < kStill_m_s);
}

TEST_CASE("a ragdoll on the ground, a blob, a wall and a loaded elevator do not creep") {
    World world({.enable_sleep = false});
    add_ground(world);
    create_ragdoll(world, {.position_m = {-10, 2}}).value();
    create_blob(world, {.position_m = {0, 2}}).value();
    create_brick_wall(world, {.position_m = {10, 0}}).value();
    create_elevator(world, {.position_m = {20, 1}}).value();
    add(world, {.position_m = {20, 1.5}}, Box{}, {.density_kg_m2 = 100});
    CHECK(creep_m_s(world, 20) < kStill_m_s);
}

TEST_CASE(
    "within ten minutes a ragdoll hung by a hand, a bridge under load and a vehicle that nothing brakes "
    "sleep") {
    // One stands, one sways until its load has settled, one swings on a hook without friction.
    const auto asleep_after_s = [](World& world) {
        for (int step = 0; step < 36000; ++step) {
            world.step(kStep_s).value();
            if (world.counts().awake_bodies == 0) return step / 60.0;
        }
        return 600.0;
    };
    World road;
    add_ground(road);
    create_vehicle(road, {.position_m = {0, 1}}).value();
    CHECK(asleep_after_s(road) < 5);

    World gorge;
    create_bridge(gorge, {}).value();
    for (int i = 0; i < 6; ++i)
        add(gorge, {.position_m = {2.0 + i, 1.5}}, Box{0.4f, 0.4f}, {.density_kg_m2 = 20});
    CHECK(asleep_after_s(gorge) < 30);

    World gallows;
    const BodyId hook = gallows.create_body({.type = BodyType::Static}).value();
    const Ragdoll ragdoll = create_ragdoll(gallows, {}).value();
    const BodyId hand = ragdoll.bodies[static_cast<std::size_t>(Bone::LowerArmLeft)];
    const Vec2 palm{0, -0.125f};
    const Vec2 at = gallows.body(hand)->position() + palm - Position{};
    gallows
        .create_joint(RevoluteJointDef{
            .body_a = hook, .body_b = hand, .local_anchor_a_m = at, .local_anchor_b_m = palm})
        .value();
    CHECK(asleep_after_s(gallows) < 600);
}

}  // namespace
}  // namespace cairn::physics
