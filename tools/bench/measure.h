// One run of one scene on one engine.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <cairn/physics/profile.h>

#include "scene.h"

namespace cairn::bench {

struct Measurement {
    int steps = 0;                      ///< all, the untimed ones too
    double ms_total = 0;                ///< of the timed steps, with what the scene did before each
    std::vector<double> step_ms;        ///< per sample; a sample is one step unless the scene says otherwise
    Tally tally{};                      ///< after the last step
    std::int64_t awake_body_steps = 0;  ///< bodies awake after a step, summed over the timed steps
    std::int64_t allocations = 0;       ///< in the second half of the timed steps
    std::int64_t bytes_peak = 0;        ///< from the building of the world on
    float max_penetration_m = 0;        ///< after the last step
    /// Root mean square of how much the velocities of the bodies change in one step after the last.
    float jitter_m_s = 0;
    Findings findings{};
    // Known of Cairn only.
    physics::Profile stages{};  ///< mean over the timed steps
    std::uint64_t state_hash = 0;
    std::optional<std::int64_t> allocations_warm{};  ///< as run_warm tells them, if it was asked
};

using MakeEngine = std::unique_ptr<Engine> (*)(const WorldSetting& setting);

/// `most_steps` cuts the scene short; 0 is no limit.
Measurement measure(const Scene& scene, MakeEngine make_engine, int threads, int most_steps = 0);

/// A scene in a world that has run it before.
struct WarmRun {
    std::int64_t allocations = 0;  ///< in all of its steps, with what the scene did before each
    std::uint64_t state_hash = 0;  ///< as of a measurement: it must be the same
};

/// Runs the scene on Cairn, goes back to its begin and runs it again until the world has had all the room it
/// needs, and then once more.
WarmRun run_warm(const Scene& scene, int threads, int most_steps = 0);

}  // namespace cairn::bench
