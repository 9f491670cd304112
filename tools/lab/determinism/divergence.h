// Two runs of a scene that should be the same to the last bit: whether they are, and where they part.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <cairn/physics/simd.h>

#include "scene.h"

namespace cairn::lab {

struct RunSetting {
    int threads = 1;
    physics::SimdLevel simd{};
    /// To show that a difference is found: before this step one body gets 10 micrometres per second
    /// more. -1: nothing is done.
    int nudged_step = -1;
};

/// What a run went through.
struct History {
    std::vector<std::uint64_t> hashes;  ///< of the state after each step
    int bodies = 0;                     ///< in the end
};

/// Runs the first `steps` steps of a scene. Chooses the SIMD level for the whole process.
History record(const bench::Scene& scene, const RunSetting& setting, int steps);

/// Where two runs part.
struct Divergence {
    int step = 0;  ///< the first after which the states differ, from 0
    /// The first body that differs then, counted from 0 in the order in which the world lists its bodies; -1:
    /// none does, only what contacts and joints remember.
    int body = -1;
    int bodies = 0;
    std::string what;  ///< of that body: "x: 1.5 and 1.5000000000000002"
};

/// Runs both again up to where their histories part; nothing when they do not.
std::optional<Divergence> divergence(const bench::Scene& scene, const RunSetting& reference,
                                     const RunSetting& setting, const History& reference_history,
                                     const History& history);

}  // namespace cairn::lab
