// Going back, pause, single steps, slow and fast motion (F4, F6 to F9). Invariant: only how many updates a
// picture gets changes, never what an update does, so a recording made in slow motion plays at any speed.
#pragma once

#include <string>
#include <utility>

#include <cairn/engine/keys.h>

namespace cairn::scripting {

class TimeControl {
  public:
    /// True when the key is one of its own.
    bool press(engine::Key key);
    /// Going back ends with F4, and the game waits.
    void release(engine::Key key);

    /// Of real time, for how long the game goes on.
    [[nodiscard]] double game_time_s(double real_time_s) const {
        return is_paused_ ? 0 : real_time_s * speed();
    }
    /// Updates that were asked for one by one since this was asked last.
    [[nodiscard]] int take_steps() { return std::exchange(steps_, 0); }
    [[nodiscard]] bool is_paused() const { return is_paused_; }
    [[nodiscard]] bool goes_back() const { return goes_back_; }
    /// 1 is real time.
    [[nodiscard]] double speed() const;
    /// "paused", "speed 1/4", or nothing at the usual speed.
    [[nodiscard]] std::string label() const;

  private:
    bool is_paused_ = false;
    bool goes_back_ = false;
    int doublings_ = 0;  ///< of the speed
    int steps_ = 0;
};

}  // namespace cairn::scripting
