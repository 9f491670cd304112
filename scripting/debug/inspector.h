// The inspector (F10): a window over the game in which worlds, bodies, joints, the script's values, assets
// and the log can be read, and physics be changed. Invariant: it is made when it is first opened, and a run
// that never opens it pays nothing for it.
#pragma once

#include <memory>
#include <vector>

#include <cairn/engine/input.h>
#include <cairn/engine/renderer.h>
#include <cairn/engine/result.h>

#include "bridge/game.h"

namespace cairn::scripting {

class Inspector {
  public:
    /// An error in programs that were built without Dear ImGui.
    static engine::Result<std::unique_ptr<Inspector>> create(const Services& services);
    virtual ~Inspector() = default;

    /// Takes out what is meant for the inspector: the mouse over it, keys typed into it, clicks that pick a
    /// body.
    virtual void take_events(std::vector<engine::InputEvent>& events, const Game& game) = 0;
    /// Over the game's picture. With `can_change` false everything can only be read: a recording would not
    /// know of the changes.
    virtual void draw(const Game& game, bool can_change) = 0;
};

}  // namespace cairn::scripting
