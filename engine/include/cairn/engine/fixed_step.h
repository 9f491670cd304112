// Turns real time into a whole number of equal updates per frame, plus how far the frame lies between two of
// them. Invariant: after advance(), less than one step of time is left over, and alpha is that rest in steps:
// 0 <= alpha < 1. Source: G. Fiedler, "Fix Your Timestep!", 2004.
#pragma once

namespace cairn::engine {

class FixedStep {
  public:
    /// What one frame has to do.
    struct Frame {
        int updates = 0;   ///< how often to call update with step_s()
        double alpha = 0;  ///< draw the state at (1 - alpha) previous + alpha current
    };

    static constexpr double kDefaultStep_s = 1.0 / 60.0;

    /// Five updates, 83 ms, is the most that one frame catches up. More would let a game whose updates are
    /// slower than real time fall behind further with every frame; less would slow the game down on screens
    /// of 12 to 30 Hz.
    static constexpr int kDefaultMaxUpdates = 5;

    /// Asserts step_s > 0 and max_updates >= 1.
    explicit FixedStep(double step_s = kDefaultStep_s, int max_updates = kDefaultMaxUpdates);

    double step_s() const { return step_s_; }

    /// Takes the real time since the last call; a negative or non-finite time counts as 0. Time beyond the
    /// cap is lost.
    Frame advance(double elapsed_s);

    /// The frame of a run without real time (headless, replay): one update, drawn as it stands.
    static Frame exactly_one() { return {.updates = 1, .alpha = 1}; }

    /// Forgets the time left over, as after loading a level.
    void reset() { accumulated_s_ = 0; }

  private:
    double step_s_;
    int max_updates_;
    double accumulated_s_ = 0;
};

}  // namespace cairn::engine
