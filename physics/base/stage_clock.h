// Writes down how long the stages of a step take. Invariant: with nowhere to write it reads no clock.
// This is the only file of the physics that may see a clock, and its readings go into the profile and nowhere
// else.
#pragma once

#include <chrono>

#include <cairn/physics/profile.h>

namespace cairn::physics {

class StageClock {
  public:
    /// Starts over with `profile`; nullptr switches the clock off.
    explicit StageClock(Profile* profile) : profile_(profile) {
        if (profile_ == nullptr) return;
        *profile_ = {};
        since_ = Clock::now();
    }
    StageClock(const StageClock&) = delete;
    StageClock& operator=(const StageClock&) = delete;
    ~StageClock() {
        if (profile_ != nullptr) book(Clock::now());
    }

    /// From here on the time is this stage's, until the next call or the end of the clock.
    void enter(Stage stage) {
        if (profile_ == nullptr) return;
        const Clock::time_point now = Clock::now();
        book(now);
        stage_ = stage;
        since_ = now;
    }

  private:
    using Clock = std::chrono::steady_clock;

    void book(Clock::time_point now) {
        (*profile_)[stage_] += std::chrono::duration<double, std::milli>(now - since_).count();
    }

    Profile* profile_;
    Stage stage_ = kStages.front();
    Clock::time_point since_;
};

}  // namespace cairn::physics
