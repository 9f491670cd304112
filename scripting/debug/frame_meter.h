// What a frame took, part by part, and the last four seconds of it. Invariant: while it is off nothing is
// measured, and it never tells the game anything.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <cairn/physics/profile.h>

#include "bind/context.h"

namespace cairn::scripting {

enum class FramePart {
    Update,   ///< the game's updates, steps of the physics among them
    Draw,     ///< the game's drawing
    Present,  ///< handing the picture to the display
};
inline constexpr std::size_t kFrameParts = 3;

struct FrameFigures {
    double frame_ms = 0;  ///< from one picture to the next
    std::array<double, kFrameParts> part_ms{};
    double physics_ms = 0;            ///< of Update: the last step of each world, times its steps
    physics::Profile stages;          ///< of all worlds
    std::uint64_t lua_allocated = 0;  ///< bytes

    [[nodiscard]] double operator[](FramePart part) const { return part_ms[static_cast<std::size_t>(part)]; }
    /// Of all parts: without waiting for the display.
    [[nodiscard]] double work_ms() const {
        double work = 0;
        for (const double ms : part_ms) work += ms;
        return work;
    }
};

/// Of all frames since measuring began.
struct FrameTotals {
    std::uint64_t frames = 0;
    double work_ms = 0;
    FrameFigures slowest;  ///< the one with the most work
    int draw_calls = 0;    ///< the most in a frame
};

class FrameMeter {
  public:
    static constexpr std::size_t kHistory = 240;

    /// Adds the time of its scope to a part of the frame.
    class Scope {
      public:
        Scope(FrameMeter& meter, FramePart part) : meter_(meter), part_(part) {
            if (meter.is_on_) start_ = Clock::now();
        }
        ~Scope() {
            if (meter_.is_on_ && start_ != Clock::time_point{})
                meter_.now_.part_ms[static_cast<std::size_t>(part_)] += ms_since(start_);
        }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        FrameMeter& meter_;
        FramePart part_;
        std::chrono::steady_clock::time_point start_{};
    };

    [[nodiscard]] bool is_on() const { return is_on_; }
    /// The worlds measure their stages while it is on.
    void turn(bool on, const Context& context);
    /// The picture is done: takes the figures down. `lua_allocated` counts from the start of the state.
    void end_frame(const Context& context, std::uint64_t lua_allocated);

    [[nodiscard]] const FrameTotals& totals() const { return totals_; }
    /// Oldest first; at most kHistory.
    [[nodiscard]] std::vector<FrameFigures> history() const;
    /// The mean of the last quarter of a second, which a person can read.
    [[nodiscard]] FrameFigures mean() const;

  private:
    using Clock = std::chrono::steady_clock;
    static double ms_since(Clock::time_point start) {
        return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    }

    bool is_on_ = false;
    FrameFigures now_;
    FrameTotals totals_;
    Clock::time_point frame_start_{};
    std::uint64_t lua_allocated_before_ = 0;
    std::vector<std::uint64_t> steps_before_;  ///< of the worlds, in their order
    std::vector<FrameFigures> frames_;         // a ring, once it is full
    std::size_t next_ = 0;
};

}  // namespace cairn::scripting
