// Functions to be called after some game time. Invariant: timers run in order of their due frame, then of
// their making, so that a replay runs them alike.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace cairn::scripting {

/// Unless conf.lua says otherwise.
inline constexpr int kUpdatesPerSecond = 60;

class Timers {
  public:
    struct Timer {
        std::uint64_t number = 0;  ///< from 1, in order of making
        int function = 0;          ///< reference in the registry
        bool repeats = false;
        double period_s = 0;
        std::uint64_t start = 0;  ///< the frame of its making
        std::uint64_t turns = 0;  ///< so many before the one that waits
    };

    explicit Timers(int updates_per_second = kUpdatesPerSecond) : updates_per_second_(updates_per_second) {}

    /// Whole updates that make up a time, at least one: a timer never runs in the update that sets it.
    static std::uint64_t frames_of(double time_s, int updates_per_second = kUpdatesPerSecond);

    /// Returns the timer's number.
    std::uint64_t add(std::uint64_t now, double delay_s, bool repeats, int function);
    /// Gives the function reference that is no longer needed, if the timer was still waiting.
    std::optional<int> cancel(std::uint64_t number);
    /// Takes out the next timer due at `now`.
    std::optional<Timer> take_due(std::uint64_t now);
    /// Puts a repeating timer back for its next turn: in the first update in which a whole number of periods
    /// has passed since its making, so that no remainder is lost, but not in this one again.
    void repeat(Timer timer, std::uint64_t now);

    /// Takes all out and gives their function references.
    std::vector<int> take_all();

    [[nodiscard]] std::size_t count() const { return waiting_.size(); }

  private:
    std::map<std::pair<std::uint64_t, std::uint64_t>, Timer> waiting_;  ///< by due frame and number
    std::uint64_t made_ = 0;
    int updates_per_second_;
};

}  // namespace cairn::scripting
