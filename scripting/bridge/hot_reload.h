// Takes in what was saved while a game runs: levels, images and sounds in place, scripts as the game allows.
// Invariant: a fault in a file leaves the game as it was, so that the next save can mend it; a file that the
// game does not use changes nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <cairn/scripting/play.h>

#include "bridge/file_watch.h"
#include "bridge/game.h"
#include "bridge/machine.h"

namespace cairn::scripting {

class HotReload {
  public:
    struct Outcome {
        std::optional<ScriptError> error;
        bool wants_restart = false;  ///< scripts changed, and the game does not say how to go on, or fails to
        bool keeps_the_game = false;  ///< after an error: the game was left as it was
    };

    HotReload(const GameSource& source, Machine& machine, const std::vector<std::string>& arguments);

    /// Whether something was saved that has not been taken in yet. For every frame.
    bool has_changes(double now_s);
    /// What could not be taken in is tried again together with the next change.
    Outcome take_in(Game& game);
    /// The game was started anew, from the files as they are.
    void forget() {
        changed_.clear();
        has_news_ = false;
    }

  private:
    /// Files that the game has asked for and not found are looked at as those that it has.
    void expect_what_is_missing();
    /// Of those that changed; they are taken out.
    std::set<std::string> take(bool (*belongs)(const std::string& path));
    /// Of those among the files that the game runs.
    std::optional<ScriptError> check_syntax(Game& game, const std::set<std::string>& files) const;
    void take_in_assets();

    Machine& machine_;
    std::vector<std::string> arguments_;
    FileWatch watch_;
    std::size_t expected_ = 0;  ///< how many of those that the game has asked for
    std::set<std::string> changed_;
    bool has_news_ = false;
};

}  // namespace cairn::scripting
