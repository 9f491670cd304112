// Where the time of a step went. Measured only in worlds that are told to (`World::set_profiling`); nothing
// of it has any influence on the simulation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace cairn::physics {

/// A stretch of the step, as world/step.cpp lists its stages.
enum class Stage : std::uint8_t {
    Pairs,       ///< shapes that have come near each other
    Contacts,    ///< where shapes touch
    Prepare,     ///< motions and constraints, laid out for the solver
    Solve,       ///< the substeps
    Store,       ///< restitution, events, and the impulses that the next step starts from
    Finalize,    ///< bodies take their new places
    Continuous,  ///< fast bodies are held back
    Sensors,     ///< what overlaps sensors
    Sleep,       ///< islands at rest fall asleep
};

inline constexpr std::array kStages{Stage::Pairs,      Stage::Contacts, Stage::Prepare,
                                    Stage::Solve,      Stage::Store,    Stage::Finalize,
                                    Stage::Continuous, Stage::Sensors,  Stage::Sleep};

/// "pairs", "contacts", "prepare", "solve", "store", "finalize", "continuous", "sensors" or "sleep".
std::string_view name(Stage stage);

/// Milliseconds of one step, stage by stage.
struct Profile {
    std::array<double, kStages.size()> stage_ms{};

    [[nodiscard]] double& operator[](Stage stage) { return stage_ms[static_cast<std::size_t>(stage)]; }
    [[nodiscard]] double operator[](Stage stage) const { return stage_ms[static_cast<std::size_t>(stage)]; }
    /// Of the whole step.
    [[nodiscard]] double total_ms() const {
        double total = 0;
        for (const double ms : stage_ms) total += ms;
        return total;
    }
};

}  // namespace cairn::physics
