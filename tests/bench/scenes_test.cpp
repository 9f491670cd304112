// The scenes hold what they are described to hold, and give the same state whenever they are run.
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <string>

#include <cairn/physics/simd.h>

#include "measure.h"

namespace cairn::bench {
namespace {

constexpr int kOneThread = 1;

const Scene& scene_named(const std::string& name) {
    for (const Scene& scene : all_scenes()) {
        if (scene.name == name) return scene;
    }
    FAIL("no scene " << name);
    return all_scenes().front();
}

Measurement measure_on_cairn(const std::string& name, int steps) {
    return measure(scene_named(name), measure::make_cairn, kOneThread, steps);
}

struct Content {
    int bodies;
    int shapes;
    int joints;
};

// Counted by hand from the descriptions.
const std::map<std::string, Content> kContents{
    {"compounds", {3001, 6000 + 81 + 200 + 1, 0}},
    {"junkyard", {8002, 8001 + 161 + 100, 0}},
    {"large_pyramid", {5051, 5051, 0}},
    {"many_pyramids", {22001, 22020, 0}},
    {"smash", {9601, 9601, 0}},
    {"spinner", {6078, 6077 + 360, 1}},
    {"tumbler", {2027, 2029, 1}},
    {"washer", {8101, 8140, 0}},
    {"falling_1k", {1003, 1003, 0}},
    {"query_mix", {10000, 10000, 0}},
    {"joint_grid", {10000, 10000, 19794}},
    {"rain", {1 + 25 * 11, 5 * 501 + 25 * 13, 25 * 10}},
    {"chain_1000", {1002, 1001, 1001}},
    {"ragdoll_pile_200", {1 + 200 * 11, 13 + 40 + 200 * 13, 2000}},
    {"vehicles_100", {10 + 300, 2000 + 300, 200}},
    {"bridge_field", {50 * 61, 50 * 62, 50 * 41}},
    {"scale_1k", {1001, 1001, 0}},
    {"scale_5k", {5001, 5005, 0}},
    {"settled_10k", {10001, 10010, 0}},
};

}  // namespace

TEST_CASE("every scene has a name and a summary of its own") {
    std::set<std::string> names;
    std::set<std::string> summaries;
    for (const Scene& scene : all_scenes()) {
        names.insert(scene.name);
        summaries.insert(scene.summary);
        CHECK(scene.steps > scene.untimed_steps);
    }
    CHECK(names.size() == all_scenes().size());
    CHECK(summaries.size() == all_scenes().size());
}

TEST_CASE("scenes hold the bodies, shapes and joints of their description, and end in the same state twice") {
    for (const auto& [name, content] : kContents) {
        INFO(name);
        const Measurement m = measure_on_cairn(name, 4);
        CHECK(m.tally.bodies == content.bodies);
        CHECK(m.tally.shapes == content.shapes);
        CHECK(m.tally.joints == content.joints);
        CHECK(m.state_hash == measure_on_cairn(name, 4).state_hash);
    }
}

TEST_CASE("only the first step is left out of the time and of the awake bodies") {
    const Measurement m = measure_on_cairn("large_pyramid", 6);
    CHECK(m.step_ms.size() == 5);
    CHECK(m.awake_body_steps == 5 * 5050);
    CHECK(m.tally.touching == 14950);  // 2 x 4,950 between rows, 4,950 beside each other, 100 on the ground
}

TEST_CASE("scenes that stand allocate nothing in a step") {
    CHECK(measure_on_cairn("large_pyramid", 20).allocations == 0);
    CHECK(measure_on_cairn("scale_1k", 20).allocations == 0);
}

TEST_CASE("a scene ends in the same state when it was gone back to its begin, and allocates nothing then") {
    for (const std::string name : {"compounds", "smash", "joint_grid", "rain"}) {
        INFO(name);
        const int steps = 30;
        const WarmRun warm = run_warm(scene_named(name), kOneThread, steps);
        CHECK(warm.state_hash == measure_on_cairn(name, steps).state_hash);
        CHECK(warm.allocations == 0);
    }
}

TEST_CASE("a box in a stack takes less than 1,200 bytes, with its contacts and all that steps work on") {
    for (const std::string name : {"scale_1k", "scale_2k", "scale_5k", "scale_10k", "scale_20k"}) {
        INFO(name);
        const Measurement m = measure_on_cairn(name, 20);
        CHECK(m.bytes_peak > 500 * m.tally.bodies);  // that it is measured at all
        CHECK(m.bytes_peak < 1200 * m.tally.bodies);
    }
}

TEST_CASE("a scene ends in the same state at every SIMD level") {
    std::set<std::uint64_t> hashes;
    const auto levels = physics::available_simd_levels();
    for (const physics::SimdLevel level : levels) {
        physics::force_simd_level(level).value();
        hashes.insert(measure_on_cairn("scale_1k", 30).state_hash);
    }
    physics::force_simd_level(levels.back()).value();
    CHECK(hashes.size() == 1);
}

TEST_CASE("a scene ends in the same state on any number of threads") {
    std::set<std::uint64_t> hashes;
    for (const int threads : {1, 2, 3, 8}) {
        for (const std::string name : {"scale_1k", "tumbler"}) {
            hashes.insert(measure(scene_named(name), measure::make_cairn, threads, 20).state_hash);
        }
    }
    CHECK(hashes.size() == 2);
}

TEST_CASE("once the rain is full, as many ragdolls go as come") {
    const Measurement m = measure_on_cairn("rain", 8 * 41 + 2);
    CHECK(m.tally.bodies == 1 + 1000 * 11);
    CHECK(m.tally.joints == 10000);
}

TEST_CASE("each peer that is there builds and steps the same scenes") {
    for (const measure::EngineKind& peer : measure::peers()) {
        for (const std::string name :
             {"compounds", "smash", "tumbler", "joint_grid", "vehicles_100", "bridge_field"}) {
            INFO(peer.name << " on " << name);
            const Scene& scene = scene_named(name);
            REQUIRE(scene.for_every_engine);
            const Measurement m = measure(scene, peer.make, kOneThread, 3);
            CHECK(m.tally.bodies == kContents.at(name).bodies);
            CHECK(m.tally.shapes == kContents.at(name).shapes);
            CHECK(m.tally.joints >= kContents.at(name).joints);
            CHECK(m.awake_body_steps == measure(scene, measure::make_cairn, kOneThread, 3).awake_body_steps);
        }
    }
}

TEST_CASE("every peer is either there or told as absent") {
    CHECK(measure::peers().size() + measure::absent_peers().size() == 2);
}

}  // namespace cairn::bench
