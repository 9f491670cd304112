// When pairs get a contact, and lose it: each pair has one exactly while it is near.
#include "world/contacts.h"

#include <catch2/catch.hpp>

#include <cairn/physics/tuning.h>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

// A box that sleeps on a static platform, which stands on nothing.
struct Sleeper {
    World world;
    BodyId platform = add(world, {.type = BodyType::Static, .position_m = {0, -1}}, Box{2, 1});
    BodyId box = add(world, {.position_m = {0, 0.5}}, Box{0.5f, 0.5f});

    Sleeper() {
        run_for(world, 2);
        REQUIRE(world.counts().awake_bodies == 0);
        REQUIRE(world.counts().touching == 1);
    }
};

}  // namespace

TEST_CASE("a platform that goes and comes back between steps finds its contact again") {
    Sleeper scene;
    Body platform = *scene.world.body(scene.platform);
    platform.set_transform({50, -1}, 0).value();
    platform.set_transform({0, -1}, 0).value();
    step_times(scene.world, 1);
    CHECK(scene.world.counts().contacts == 1);
    CHECK(scene.world.counts().touching == 1);
}

TEST_CASE("a platform that leaves a sleeper it does not touch, and returns, has one contact with it") {
    World world;
    const BodyId platform = add(world, {.type = BodyType::Static, .position_m = {0, -1}}, Box{2, 1});
    // Near enough for a contact, too far to touch; asleep, so that it stays there.
    const BodyId box = add(world, {.position_m = {0, 0.53}, .awake = false}, Box{0.5f, 0.5f});
    step_times(world, 1);
    REQUIRE(world.counts().contacts == 1);
    REQUIRE(world.counts().touching == 0);
    for (int visit = 0; visit < 3; ++visit) {
        world.body(platform)->set_transform({50, -1}, 0).value();
        step_times(world, 1);
        world.body(box)->set_awake(false);
        world.body(platform)->set_transform({0, -1}, 0).value();
        step_times(world, 1);
        world.body(box)->set_awake(false);
        CHECK(world.counts().contacts == 1);
    }
    world.body(platform)->set_transform({50, -1}, 0).value();
    world.body(box)->set_awake(true);
    step_times(world, 1);
    CHECK(world.counts().contacts == 0);
}

TEST_CASE("a body that is moved away and put to sleep at once, then moved back, has one contact") {
    Sleeper scene;
    Body box = *scene.world.body(scene.box);
    box.set_transform({0, 30}, 0).value();
    box.set_awake(false);
    step_times(scene.world, 2);
    box.set_transform({0, 0.5}, 0).value();
    step_times(scene.world, 2);
    CHECK(scene.world.counts().contacts == 1);
    CHECK(scene.world.counts().touching == 1);
}

TEST_CASE("changing a filter to one that allows the pair as before makes no second contact") {
    Sleeper scene;
    const ShapeId shape = scene.world.body(scene.box)->shapes()[0];
    for (int i = 0; i < 3; ++i) {
        scene.world.shape(shape)->set_filter({.categories = 3, .mask = 3});
        step_times(scene.world, 1);
        CHECK(scene.world.counts().contacts == 1);
        CHECK(scene.world.counts().touching == 1);
    }
}

TEST_CASE("a contact begins before its shapes are as near as a contact point is made") {
    // Down to grains of half a millimetre, whose bounds have little to spare.
    for (const float radius_m : {0.0005f, 0.005f, 0.05f, 0.5f}) {
        World world({.gravity_m_s2 = {}});
        const double apart = 2 * static_cast<double>(radius_m) + 0.99 * tuning::kSpeculativeDistance_m;
        add(world, {.type = BodyType::Static}, Circle{{}, radius_m});
        add(world, {.position_m = {apart, 0}}, Circle{{}, radius_m});
        step_times(world, 1);
        CHECK(world.counts().contacts == 1);
    }
}

}  // namespace cairn::physics
