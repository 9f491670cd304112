// The settings that must not make a difference, and what is said about them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "determinism/divergence.h"

namespace cairn::lab {

/// Scenes of cairn-bench, then those of joints.
const std::vector<bench::Scene>& determinism_scenes();

/// The first is the one to which the others are compared: one thread, the best level. Quick: each level once,
/// and 2 and 8 threads; else 1 to 8 threads at each level.
std::vector<RunSetting> determinism_settings(bool quick);

struct Comparison {
    RunSetting setting;
    History history;
    std::optional<Divergence> divergence;
};

struct Proof {
    const bench::Scene* scene = nullptr;
    int steps = 0;
    History reference;
    std::vector<Comparison> comparisons;

    [[nodiscard]] bool holds() const;
};

/// `most_steps` cuts the scene short; 0 is no limit. `nudged_step` is that of the last setting alone.
Proof prove(const bench::Scene& scene, const std::vector<RunSetting>& settings, int most_steps,
            int nudged_step = -1);

std::string determinism_head();
/// A row for the scene, and one for each setting that made a difference.
std::vector<std::string> determinism_rows(const Proof& proof);
/// One line of JSON for each comparison.
std::vector<std::string> determinism_lines(const Proof& proof);

}  // namespace cairn::lab
