// Runs that are the same are said to be; one that was nudged is found out, at the step and the body.
#include "determinism/proof.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <variant>

#include "determinism/joint_scenes.h"
#include "support/golden.h"

namespace cairn::lab {
namespace {

constexpr int kSteps = 20;

const bench::Scene& scene_named(const std::string& name) {
    const auto& scenes = determinism_scenes();
    const auto found =
        std::find_if(scenes.begin(), scenes.end(), [&](const auto& s) { return s.name == name; });
    REQUIRE(found != scenes.end());
    return *found;
}

/// Boxes that fall side by side and never meet: what is done to one stays with it.
bench::Scene falling_boxes() {
    return {.name = "falling_boxes",
            .summary = "boxes that never meet",
            .steps = kSteps,
            .build = [](bench::Engine& engine) -> bench::BeforeStep {
                for (int i = 0; i < 9; ++i)
                    engine.add({.position_m = {3.0 * i, 0}}, physics::Box{0.5f, 0.5f});
                return {};
            }};
}

std::vector<RunSetting> two_settings() {
    const physics::SimdLevel best = physics::available_simd_levels().back();
    return {{1, best}, {2, best}};
}

}  // namespace

TEST_CASE("a body that was nudged is found, with the step") {
    const Proof proof = prove(falling_boxes(), two_settings(), 0, 7);
    CHECK_FALSE(proof.holds());
    const auto& divergence = proof.comparisons.at(0).divergence;
    REQUIRE(divergence);
    CHECK(divergence->step == 7);
    CHECK(divergence->body == 4);  // the middle of nine
    CHECK(divergence->bodies == 9);
    CHECK(divergence->what.substr(0, 3) == "x: ");
}

TEST_CASE("what a nudge does in a pile is found at the step of the nudge") {
    const Proof proof = prove(scene_named("joint_revolute"), two_settings(), kSteps, 12);
    REQUIRE(proof.comparisons.at(0).divergence);
    CHECK(proof.comparisons.at(0).divergence->step == 12);
    CHECK(proof.comparisons.at(0).divergence->body >= 0);
}

TEST_CASE("a difference is told in words and as JSON") {
    const bench::Scene scene = falling_boxes();
    const Proof proof = prove(scene, two_settings(), 0, 7);
    const std::vector<std::string> rows = determinism_rows(proof);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].find("! differs") != std::string::npos);
    CHECK(rows[1].find("! 2 threads, ") != std::string::npos);
    CHECK(rows[1].find("first after step 7, body 4 of 9, x: ") != std::string::npos);
    const auto line = nlohmann::json::parse(determinism_lines(proof).at(0));
    CHECK(line["scene"] == "falling_boxes");
    CHECK(line["threads"] == 2);
    CHECK(line["same"] == false);
    CHECK(line["first_step"] == 7);
    CHECK(line["first_body"] == 4);
}

TEST_CASE("joints of every kind give the same states on threads and at all SIMD levels") {
    const std::vector<RunSetting> settings = determinism_settings(true);
    CHECK(settings.front().threads == 1);
    CHECK(settings.front().simd == physics::available_simd_levels().back());
    for (const bench::Scene& scene : joint_scenes()) {
        const Proof proof = prove(scene, settings, kSteps);
        INFO(determinism_rows(proof).front());
        CHECK(proof.holds());
        CHECK(proof.comparisons.size() + 1 == settings.size());
        CHECK(nlohmann::json::parse(determinism_lines(proof).at(0))["same"] == true);
    }
}

TEST_CASE("all settings are each number of threads at each SIMD level") {
    std::set<std::pair<int, physics::SimdLevel>> found;
    for (const RunSetting& setting : determinism_settings(false))
        found.emplace(setting.threads, setting.simd);
    CHECK(found.size() == 8 * physics::available_simd_levels().size());
}

TEST_CASE("there is a scene for each kind of joint, and one of joints that break") {
    std::set<std::string> names;
    for (const bench::Scene& scene : joint_scenes()) {
        names.insert(scene.name);
        const auto engine = measure::make_cairn(scene.world);
        scene.build(*engine);
        CHECK(engine->cairn_world()->counts().joints >= 24);
    }
    CHECK(names.size() == std::variant_size_v<physics::JointDef> + 1);
}

// Debug and release, with every compiler that runs the tests.
TEST_CASE("joints of every kind end in the same states in all builds", "[golden]") {
    std::uint64_t all = 0;
    const RunSetting setting = determinism_settings(true).front();
    for (const bench::Scene& scene : joint_scenes()) {
        const History history = record(scene, setting, scene.steps);
        all = all * 0x100000001b3u ^ history.hashes.back();  // the prime of FNV
    }
    CHECK_THAT(cairn::test::hash_text(all), cairn::test::MatchesGolden("lab-joint-kinds"));
}

TEST_CASE("the scenes of cairn-bench begin with the same states in all builds", "[golden]") {
    constexpr int kMostBodies = 10001;  // more take long in debug builds, and add nothing new
    constexpr int kFirstSteps = 3;
    std::uint64_t all = 0;
    for (const bench::Scene& scene : bench::all_scenes()) {
        const auto engine = measure::make_cairn(scene.world);
        scene.build(*engine);
        if (engine->tally().bodies > kMostBodies) continue;
        const History history = record(scene, determinism_settings(true).front(), kFirstSteps);
        all = all * 0x100000001b3u ^ history.hashes.back();
    }
    CHECK_THAT(cairn::test::hash_text(all), cairn::test::MatchesGolden("lab-bench-scenes"));
}

}  // namespace cairn::lab
