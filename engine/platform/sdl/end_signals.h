// SIGINT and SIGTERM while there is a window. Invariant: the first one is noted, so that the program can end
// in good order; a second one ends it at once, whatever it is doing.
#pragma once

#include <array>
#include <csignal>

namespace cairn::engine {

/// Listens as long as it lives; at most one at a time. Signals that the program was started to ignore stay
/// ignored, and handlers of a program around this one are left alone.
class EndSignals {
  public:
    EndSignals();
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    /// The number of the signal that has come; 0: none.
    [[nodiscard]] static int received();
    /// What the handler of the first one calls; null: nothing, as at first.
    static void call_on_first(void (*call)());

  private:
    static constexpr std::array kSignals = {SIGINT, SIGTERM};
    std::array<bool, kSignals.size()> is_ours_{};
};

}  // namespace cairn::engine
