// The tools that every game has in a window: help (F1), debug drawing (F2), profiler (F3),
// restart (F5), time (F4, F6 to F9), inspector (F10).
// Invariant: their keys never reach the game or a recording, they draw after the game did, and they change
// nothing that the game can notice.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/input.h>
#include <cairn/engine/renderer.h>
#include <cairn/engine/result.h>

#include "bridge/game.h"
#include "debug/debug_draw.h"
#include "debug/frame_meter.h"
#include "debug/inspector.h"
#include "debug/profiler_overlay.h"
#include "debug/rewind.h"
#include "debug/time_control.h"

namespace cairn::scripting {

/// How much of the worlds F2 shows.
enum class DebugLayer { Off, Shapes, Islands, Everything };

class DeveloperTools {
  public:
    /// Opens "help", "debug", "profiler" or "inspector", as their keys do. The error lists the names.
    engine::Result<void> show(std::string_view name);

    /// Takes the keys that are the tools' own out of the events, and does what they ask for.
    void take_keys(std::vector<engine::InputEvent>& events);
    /// Takes what is meant for the inspector.
    void take_input(std::vector<engine::InputEvent>& events, const Game& game);
    /// Whether the inspector may change things and time may go back; not when a run is recorded or replayed.
    void set_can_change(bool can_change) { can_change_ = can_change; }
    /// After an update: keeps the moment, from the first use of a tool on. The error is the game's.
    std::optional<ScriptError> note_update(Game& game);
    /// One update back, if that is known.
    std::optional<ScriptError> step_back(Game& game) { return rewind_.step_back(game); }
    /// The game's files changed while it runs: what it was before does not fit them any more.
    void forget_past() { rewind_.forget(); }
    /// F7 repeats while it is held.
    [[nodiscard]] TimeControl& time() { return time_; }
    /// Whether F5 was pressed since this was asked last.
    [[nodiscard]] bool take_restart();

    /// Over the game's picture, before the frame ends.
    /// The profiler tells what pictures cost, so a headless run draws them all for it.
    [[nodiscard]] bool needs_every_picture() const { return shows_profiler_; }
    void draw(const Game& game);
    /// The game is about to be made anew.
    void forget_game();
    /// After the picture was handed to the display.
    void end_frame(const Game& game);
    /// Measures from now on, whether the profiler is open or not.
    void measure() { measures_ = true; }
    /// What a frame takes is measured while the profiler is open.
    [[nodiscard]] FrameMeter& meter() { return meter_; }

  private:
    void press(engine::Key key);
    void draw_worlds(const Context& context) const;
    void draw_inspector(const Game& game);
    void draw_label(engine::Renderer& renderer, engine::FontId font, const std::string& label) const;
    void draw_help(engine::Renderer& renderer, engine::FontId font) const;

    bool shows_help_ = false;
    DebugLayer layer_ = DebugLayer::Off;
    bool shows_profiler_ = false;
    bool measures_ = false;
    bool wants_restart_ = false;
    TimeControl time_;
    bool keeps_past_ = false;
    Rewind rewind_;
    FrameMeter meter_;
    ProfilerOverlay profiler_;
    bool shows_inspector_ = false;
    bool can_change_ = true;
    std::unique_ptr<Inspector> inspector_;  ///< made when it is first shown
};

}  // namespace cairn::scripting
