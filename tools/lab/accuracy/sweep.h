// A problem solved by each engine at many settings: how large the errors are, and how long it takes.
// Invariant: whatever an engine does at a setting, the others are measured, and the failure is kept.
#pragma once

#include <string>
#include <vector>

#include "accuracy/problem.h"

namespace cairn::lab {

/// What changes along a line of a plot.
enum class Sweep { Default, Effort, TimeStep };

struct Point {
    Setting setting;
    Sweep sweep = Sweep::Default;
    std::vector<double>
        errors;            ///< one per metric of the problem; empty when the run did not come to its end
    std::string ended_by;  ///< then
    // CPU time for a second of simulation: the fastest of the runs, and the spread between the quartiles.
    double cpu_s_per_sim_s = std::numeric_limits<double>::quiet_NaN();
    double cpu_iqr_s = 0;

    /// No finite error, unless the engine cannot tell.
    [[nodiscard]] bool failed(std::size_t metric) const;
    [[nodiscard]] bool tells(std::size_t metric) const;
};

/// Efforts of 1 to 32 at steps of 1/60 s, and steps of 1/30 to 1/480 s at the default effort.
std::vector<Point> points_of(const EngineKind& kind, bool quick);

/// All engines by turns. `samples` timed runs of each setting.
std::vector<Point> solve(const Problem& problem, const std::vector<EngineKind>& kinds, bool quick,
                         int samples);

}  // namespace cairn::lab
