// A scene: what stands in the world, and what happens before each step.
// Invariant: building a scene twice gives the same world; scenes differ from run to run in nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine.h"

namespace cairn::bench {

using measure::BodyRef;
using measure::Engine;
using measure::kStep_s;
using measure::Tally;
using measure::WorldSetting;

/// What a run of a scene has to say besides times of steps.
struct Findings {
    struct Cost {
        std::string what;
        double ns_each;
    };
    std::vector<Cost> costs;
    std::uint64_t digest = 0;  ///< of answers that the state of the world does not show
};

/// Called before each step with its number, and timed with it. May be empty. A copy goes on by itself.
using BeforeStep = std::function<void(Engine& engine, int step, Findings& findings)>;

struct Scene {
    std::string name;
    std::string summary;
    WorldSetting world{};
    int steps = 1;                  ///< all of them, the untimed ones too
    int untimed_steps = 1;          ///< at the start: the first step finds every pair at once
    int steps_per_sample = 1;       ///< more than 1 where a single step is too short for the clock
    bool for_every_engine = false;  ///< made of what every 2D engine has
    std::function<BeforeStep(Engine& engine)> build;
};

/// In the order in which they are listed.
std::span<const Scene> all_scenes();

// One family each, in scenes/.
Scene compounds();
Scene junkyard();
Scene large_pyramid();
Scene many_pyramids();
Scene smash();
Scene spinner();
Scene tumbler();
Scene washer();
Scene joint_grid();
Scene rain();
Scene chain_1000();
Scene ragdoll_pile_200();
Scene vehicles_100();
Scene bridge_field();
Scene settled_10k();
Scene falling_1k();
Scene scale(int bodies);
Scene query_mix();

}  // namespace cairn::bench
