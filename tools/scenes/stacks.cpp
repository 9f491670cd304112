// Stacks of 10 boxes on floors of 100 stacks: scale_N keeps them awake, settled_10k lets them fall asleep.
// Floors stand above each other, so that a large world is no longer than a small one.
#include <algorithm>

#include "scene.h"

namespace cairn::bench {

using physics::BodyType;
using physics::Box;

namespace {

constexpr int kStackHeight = 10;
constexpr int kStacksPerFloor = 100;

BeforeStep build_stacks(Engine& engine, int bodies) {
    const int stacks = bodies / kStackHeight;
    const BodyRef ground = engine.add_body({.type = BodyType::Static});
    for (int first = 0; first < stacks; first += kStacksPerFloor) {
        const int floor_m = 14 * (first / kStacksPerFloor);
        engine.add_shape(ground, Box{101, 1, {0, static_cast<float>(floor_m) - 1}}, {});
        for (int stack = first; stack < std::min(stacks, first + kStacksPerFloor); ++stack) {
            const double x = 2.0 * (stack - first) - kStacksPerFloor + 1;
            for (int i = 0; i < kStackHeight; ++i) {
                engine.add({.position_m = {x, floor_m + i + 0.5}}, Box{0.5f, 0.5f});
            }
        }
    }
    return {};
}

}  // namespace

Scene scale(int bodies) {
    const std::string thousands = std::to_string(bodies / 1000);
    return {.name = "scale_" + thousands + "k",
            .summary = thousands + ",000 boxes in stacks of 10, kept awake",
            .world = {.enable_sleep = false},
            .steps = bodies <= 20000 ? 200 : 60,
            .for_every_engine = bodies <= 10000,  // others take minutes beyond
            .build = [bodies](Engine& engine) { return build_stacks(engine, bodies); }};
}

Scene settled_10k() {
    return {.name = "settled_10k",
            .summary = "10,000 boxes in stacks of 10, asleep",
            .steps = 20180,
            .untimed_steps = 180,  // 3 s: six times what an island at rest waits before it sleeps
            .steps_per_sample = 1000,
            .build = [](Engine& engine) { return build_stacks(engine, 10000); }};
}

}  // namespace cairn::bench
