// Measuring a step tells where its time went and changes nothing about the step.
#include <catch2/catch.hpp>
#include <set>
#include <string_view>

#include "physics/support/scenes.h"

namespace cairn::physics {
namespace {

using namespace test;

bool all_zero(const Profile& profile) {
    for (const double ms : profile.stage_ms) {
        if (ms != 0) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("each stage of the step has a name of its own") {
    std::set<std::string_view> names;
    for (const Stage stage : kStages) names.insert(name(stage));
    CHECK(names.size() == kStages.size());
    CHECK(names.count("unknown") == 0);
}

TEST_CASE("a world that was not told to measures nothing") {
    World world;
    build_pyramid(world, 5);
    step_times(world, 10);
    CHECK(all_zero(world.profile()));
}

TEST_CASE("a profile has a time for every stage and their sum, and stays when measuring ends") {
    World world({.enable_sleep = false});
    build_pyramid(world, 10);
    world.set_profiling(true);
    step_times(world, 5);
    const Profile profile = world.profile();
    double sum = 0;
    for (const Stage stage : kStages) {
        CHECK(profile[stage] >= 0);
        sum += profile[stage];
    }
    CHECK(profile.total_ms() == sum);
    CHECK(profile[Stage::Contacts] > 0);
    CHECK(profile[Stage::Solve] > 0);

    world.set_profiling(false);
    step_times(world, 5);
    CHECK(world.profile().stage_ms == profile.stage_ms);
}

TEST_CASE("measuring does not change what happens") {
    World plain;
    World measured;
    measured.set_profiling(true);
    for (World* world : {&plain, &measured}) {
        build_pile(*world, 60, 4);
        step_times(*world, 120);
    }
    CHECK(plain.state_hash() == measured.state_hash());
}

}  // namespace cairn::physics
