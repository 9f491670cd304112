// Runs a case on an engine, and says whether it passed. Each run is a process of its own: what an engine does
// to it, from an assertion to a loop without end, is a failure of that run alone.
#pragma once

#include <optional>
#include <string>

#include "torture/case.h"

namespace cairn::lab {

/// Share of the scene's energy that may appear from nowhere.
inline constexpr double kMostEnergyExcess = 0.01;

struct Outcome {
    Findings findings;
    /// Cairn only: the same states at 1, 2 and 8 threads.
    std::optional<bool> same_on_threads;
    std::string ended_by;  ///< what ended the run before its time; empty when nothing did

    [[nodiscard]] bool passed() const;
};

Outcome run_case(const Case& test, const EngineKind& kind);

/// The outcome as text and back: what goes from the one process to the other.
std::string to_text(const Outcome& outcome);
Outcome outcome_from(const std::string& text);

}  // namespace cairn::lab
